// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/container/container.h"
#include "model/codec/container/syntax.h"
#include "model/codec/entropy/integercoder.h"
#include "model/codec/reel/bandcoder.h"
#include "model/codec/reel/shapecoder.h"

#include <cmath>

namespace model::codec {

// What encoder and decoder of `reel` share beside the coders: the parameters, and the order of things. FORMAT.md 13.

inline constexpr std::string_view ReelParametersTag = "REEL";
inline constexpr std::string_view ReelConnectivityTag = "CLRS";
/// Only where the order of the vertices was kept.
inline constexpr std::string_view ReelOrderTag = "ORDR";
/// Only where there are several.
inline constexpr std::string_view ReelClustersTag = "PART";
inline constexpr std::string_view ReelShapeTag = "SHAP";
inline constexpr std::string_view ReelBandsTag = "BAND";

struct ReelParameters
{
    // As in ReelSettings, so that a file can be encoded again as it was.
    double wantedStep = 0;
    std::uint32_t wantedBasisSize = 0;

    double step = 0; ///< of coefficients, in the animation's unit times sqrt(F)
    /// The rest shape's step is (n + 1) / 32 of it; that of the mean vertices 2^(-n / 8) of it.
    std::uint8_t shapeShare = 0, meanExponent = 0;
    std::array<float, 3> origin{}; ///< what the mean vertices are relative to
    // (n + 1) / 256: BandSettings::levelRatio.
    std::uint8_t shapeRatio = 255, basisRatio = 255, coefficientRatio = 255;
    std::uint32_t basisSize = 0;
};

template <class Stream, class Origin>
bool originSyntax(Stream &s, Origin &origin)
{
    constexpr double Most = 3.4e38;
    for (auto &value : origin)
        if (!s.f32(value) || !s.requireReal(double(value), -Most, Most, "origin"))
            return false;
    return true;
}

template <class Stream, class Fields>
bool reelSyntax(Stream &s, Fields &p, const Header &header) // FORMAT.md 13.1
{
    constexpr double Least = 1e-100, Most = 1e100;
    const std::uint64_t most = std::min<std::uint64_t>(1000, header.vertexCount);
    return s.f64(p.wantedStep) && s.requireReal(p.wantedStep, MinStep, MaxStep, "wanted step") &&
           s.varUint(p.wantedBasisSize) &&
           s.require(p.wantedBasisSize <= ReelSettings::MaxBasisSize, "wanted basis size", p.wantedBasisSize,
                     "0 ... 1000") &&
           s.f64(p.step) && s.requireReal(p.step, Least, Most, "step") && s.u8(p.shapeShare) && s.u8(p.meanExponent) &&
           originSyntax(s, p.origin) && s.u8(p.shapeRatio) && s.u8(p.basisRatio) && s.u8(p.coefficientRatio) &&
           s.varUint(p.basisSize) && s.require(p.basisSize <= most, "basis size", p.basisSize, "0 ... 1000, vertices");
}

inline double levelRatio(std::uint8_t stored)
{
    return (stored + 1) / 256.0;
}

// What holds the weights at their prior: chosen on chicken, cow, dance, samba and horse-gallop, flat within a factor
// of 2.
inline constexpr double TimeRidge = 3;
inline constexpr double MeshRidge = 0.5;

/// Frames lie on a line.
inline std::vector<Point> framePlaces(const CoarseToFine &frames)
{
    std::vector<Point> places;
    for (const std::uint32_t frame : frames.vertices)
        places.push_back({double(frame), 0, 0});
    return places;
}

/// Steps of the basis as they are stored: an eighth of an octave apart.
inline constexpr std::int32_t MaxStepExponent = 4000;
inline double stepOfExponent(std::int32_t exponent)
{
    // 2^(i/8): the nearest doubles, so that no library's power function matters.
    static constexpr std::array<double, 8> Eighths{1.0,
                                                   1.0905077326652577,
                                                   1.189207115002721,
                                                   1.2968395546510096,
                                                   1.4142135623730951,
                                                   1.5422108254079407,
                                                   1.681792830507429,
                                                   1.8340080864093424};
    const std::int32_t octave = exponent >= 0 ? exponent / 8 : -((7 - exponent) / 8);
    return std::ldexp(Eighths[std::size_t(exponent - 8 * octave)], octave);
}

inline double shapeStep(const ReelParameters &p)
{
    return p.step * ((p.shapeShare + 1) / 32.0);
}
inline double meanStep(const ReelParameters &p)
{
    return p.step * stepOfExponent(-std::int32_t(p.meanExponent));
}

/// Step exponents of the basis trajectories, each relative to the one before.
class StepCoder
{
public:
    template <class Coder>
    std::int32_t code(Coder &coder, std::int32_t exponent = 0)
    {
        const std::int64_t next = mLast + codeInteger(coder, mModels, mSize, 0, exponent - mLast);
        mSize = 1;
        mLast = std::int32_t(std::clamp<std::int64_t>(next, -MaxStepExponent, MaxStepExponent));
        return mLast;
    }

private:
    IntegerModels<5> mModels;
    unsigned mSize = 0;
    std::int32_t mLast = 0;
};

} // namespace model::codec
