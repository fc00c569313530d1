// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/compressionsettings.h"
#include "model/codec/container/container.h"
#include "model/codec/container/syntax.h"

#include <algorithm>

namespace model::codec::coddyac {

inline constexpr std::string_view ParametersTag = "CDYP";
inline constexpr std::string_view ConnectivityTag = "CLRS";
inline constexpr std::string_view OrderTag = "ORDR";
inline constexpr std::string_view MeansTag = "MEAN";
inline constexpr std::string_view BasisTag = "BASE";
inline constexpr std::string_view CoefficientsTag = "COEF";

struct Parameters
{
    CoddyacSettings settings;
    double unit = 1;
    std::uint32_t rank = 0;
    std::vector<std::uint8_t> fineness; ///< #rank
};

/// Of QuantizedCoddyac::unit: what the trajectories of float positions can give.
inline constexpr double MinUnit = 1e-60;
inline constexpr double MaxUnit = 1e60;

// The writer's fields are const and as many as they are.
inline void resizeToRead(const Parameters &) {}
inline void resizeToRead(Parameters &p)
{
    p.fineness.resize(p.rank);
}

template <class Stream, class Fields>
bool parameterSyntax(Stream &s, Fields &p, const Header &header) // FORMAT.md 14.1
{
    using Limits = CoddyacSettings;
    const bool good =
        s.varUint(p.settings.basisSize) &&
        s.require(p.settings.basisSize >= Limits::MinBasisSize && p.settings.basisSize <= Limits::MaxBasisSize,
                  "wanted basis size", p.settings.basisSize, "1 ... 1000") &&
        s.f64(p.settings.step) && s.requireReal(p.settings.step, Limits::MinStep, Limits::MaxStep, "step") &&
        s.f64(p.settings.basisStep) &&
        s.requireReal(p.settings.basisStep, Limits::MinBasisStep, Limits::MaxBasisStep, "basis step") &&
        s.f64(p.unit) && s.requireReal(p.unit, MinUnit, MaxUnit, "unit") && s.varUint(p.rank) &&
        s.require(p.rank <= std::min<std::uint64_t>(
                                {p.settings.basisSize, header.vertexCount, std::uint64_t(3) * header.frameCount}),
                  "basis size", p.rank, "0 ... wanted, vertices, 3 x frames");
    if (!good)
        return false;
    resizeToRead(p);
    for (auto &fineness : p.fineness)
        if (!s.u8(fineness))
            return false;
    return true;
}

} // namespace model::codec::coddyac
