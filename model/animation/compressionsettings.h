// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace model {

/// The codecs; the numbers are those of the file format.
enum class CodecId : std::uint8_t { Pca = 2 };

/// How an animation is turned into an `.anim` file. The ranges are those that a reader of the settings (dialog, command
/// line) must refuse to leave.
struct CompressionSettings
{
    static constexpr std::uint32_t MinBasisSize = 1;
    static constexpr std::uint32_t MaxBasisSize = 1000;
    static constexpr double MinResolution = 1;
    static constexpr double MaxResolution = 1e7;

    CodecId codec = CodecId::Pca;
    /// Number of basis trajectories kept; an animation of lower rank keeps fewer.
    std::uint32_t basisSize = 20;
    /// Quantisation steps per unit, for means, basis and coefficients.
    double resolution = 10000;

    friend bool operator==(const CompressionSettings &, const CompressionSettings &) = default;
};

} // namespace model
