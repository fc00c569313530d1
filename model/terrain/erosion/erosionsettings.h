// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/material/material.h"

#include <cstdint>

namespace model::terrain {

/// How it is decided what slides.
enum class ErosionRule : std::uint8_t {
    Face, ///< whole triangles, to the critical angle: where nothing slides any more, no triangle is steeper
    Edge, ///< along each edge to its lower end, as in the older work: leaves triangles up to twice as steep
};

struct ErosionSettings
{
    ErosionRule rule = ErosionRule::Face;
    /// By how much of what is too steep a triangle is flattened at once: above 1 it goes too far and comes to rest
    /// sooner. 0.1 ... 1.95.
    double relaxation = 1.85;
    /// Hysteresis: degrees above the critical angle at which resting material starts to slide; what slides stops at the
    /// critical angle. For run(); settle() ends without. 0 ... 10.
    double startAngle = 1.5;
    /// Sweeps over all that may move in a second of simulated time. 1 ... 100000.
    double sweepsPerSecond = 120;
    /// Edges of sliding triangles longer than this are split before material moves over them; 0: none. Metres.
    double longestEdge = 0;
    /// By how much, vertically, the removal of vertices that have become redundant may change the surface; 0: none are
    /// removed. Metres.
    double flatError = 0;
    /// Vertices whose triangles all lie within this angle of each other may be redundant. Degrees, 0 ... 10.
    double flatAngle = 0.4;
    /// settle() moves the bulk of uniform material on a coarse grid first: a third faster, and the tip of a heap a
    /// hundredth or two lower.
    bool hasCoarsePass = false;
    /// What a terrain without layers consists of, down to any depth.
    Material material = terrain::material(MaterialPreset::DrySand);
};

/// \error BadSetting  args: the setting (as its member is called), its value, the allowed range
Result<void> check(const ErosionSettings &settings);

} // namespace model::terrain
