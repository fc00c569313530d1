// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <variant>

namespace model {

/// The codecs; the numbers are those of the file format. codec::availableCodecs() says which of them this program has.
enum class CodecId : std::uint8_t { Direct = 1, Pca = 2, Coddyac = 3, Reel = 4 };

/// What `direct` takes the position of a vertex to be before it is told. The numbers are those of the file format.
enum class Predictor : std::uint8_t {
    None,         ///< 0: the position itself is coded
    Still,        ///< A: where it was
    Steady,       ///< B: it goes on at the speed that it had
    Accelerating, ///< C: its speed goes on changing as it did
    Neighbours,   ///< N: it moves as its neighbours in the mesh do that are known already
};

/// How `direct` packs its residuals. The numbers are those of the file format.
enum class Entropy : std::uint8_t {
    Deflate, ///< zlib
    Range,   ///< adaptive range coder
};

// One struct for each codec. Each range is what a reader of the settings (a file, the dialog, the command line) must
// refuse to leave; visitFields() in settingsfields.h lists them all.

/// Quantised positions, a frame predicted from those before it. Exact to half a cell.
struct DirectSettings
{
    static constexpr CodecId Codec = CodecId::Direct;
    static constexpr std::uint32_t MinResolution = 1;
    static constexpr std::uint32_t MaxResolution = 1u << 24; ///< beyond it a float has no more to give

    /// Cells along the longest side of the box around all frames.
    std::uint32_t resolution = 4096;
    Predictor predictor = Predictor::Neighbours;
    Entropy entropy = Entropy::Range;

    friend bool operator==(const DirectSettings &, const DirectSettings &) = default;
};

/// Principal components, all at one resolution.
struct PcaSettings
{
    static constexpr CodecId Codec = CodecId::Pca;
    static constexpr std::uint32_t MinBasisSize = 1;
    static constexpr std::uint32_t MaxBasisSize = 1000;
    static constexpr double MinResolution = 1;
    static constexpr double MaxResolution = 1e7;

    /// Number of basis trajectories kept; an animation of lower rank keeps fewer.
    std::uint32_t basisSize = 20;
    /// Quantisation steps per unit, for means, basis and coefficients.
    double resolution = 10000;

    friend bool operator==(const PcaSettings &, const PcaSettings &) = default;
};

/// Least and largest step of CoddyacSettings and ReelSettings.
inline constexpr double MinStep = 1e-7;
inline constexpr double MaxStep = 1;

/// Principal components, predicted over the mesh by parallelograms.
struct CoddyacSettings
{
    static constexpr CodecId Codec = CodecId::Coddyac;
    static constexpr std::uint32_t MinBasisSize = 1;
    static constexpr std::uint32_t MaxBasisSize = 1000;
    static constexpr double MinStep = model::MinStep;
    static constexpr double MaxStep = model::MaxStep;
    static constexpr double MinBasisStep = 1e-7;
    static constexpr double MaxBasisStep = 1;

    /// Number of basis trajectories kept; an animation of lower rank keeps fewer.
    std::uint32_t basisSize = 40;
    /// Quantisation step of the coefficients (delta_d), relative to the root mean square over the vertices of
    /// |trajectory - mean trajectory|: it means the same for every animation, whatever its unit or length.
    double step = 0.005;
    /// Quantisation step of the basis (delta_q), relative to the same step for an entry that meets the coefficients'
    /// root mean square.
    double basisStep = 0.005;

    friend bool operator==(const CoddyacSettings &, const CoddyacSettings &) = default;
};

/// Principal components, band by band, coarse to fine over the mesh.
struct ReelSettings
{
    static constexpr CodecId Codec = CodecId::Reel;
    static constexpr std::uint32_t MinBasisSize = 0;
    static constexpr std::uint32_t MaxBasisSize = 1000;
    static constexpr double MinStep = model::MinStep;
    static constexpr double MaxStep = model::MaxStep;

    /// As CoddyacSettings::step.
    double step = 0.005;
    /// Number of basis trajectories kept at most; 0: as many as pay.
    std::uint32_t basisSize = 0;

    friend bool operator==(const ReelSettings &, const ReelSettings &) = default;
};

using CodecSettings = std::variant<DirectSettings, PcaSettings, CoddyacSettings, ReelSettings>;

/// How an animation is turned into an `.anim` file.
struct CompressionSettings
{
    CodecSettings method = ReelSettings();
    /// The decoded vertices have the order of the input. `direct` and `pca` keep it anyway, that of the triangles too.
    bool keepOrder = false;

    CodecId codec() const
    {
        return std::visit([](const auto &m) { return m.Codec; }, method);
    }

    friend bool operator==(const CompressionSettings &, const CompressionSettings &) = default;
};

/// A codec's settings as they are before anybody changes them.
inline CodecSettings defaultSettings(CodecId codec)
{
    switch (codec) {
    case CodecId::Direct:
        return DirectSettings();
    case CodecId::Pca:
        return PcaSettings();
    case CodecId::Coddyac:
        return CoddyacSettings();
    case CodecId::Reel:
        return ReelSettings();
    }
    return PcaSettings();
}

} // namespace model
