// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/feel/feel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace model::haptics {

namespace {

/// What the numbers below are relative to: loose dry sand.
constexpr double SandDensity = 1600, SandAngle = 30;
/// Degrees by which water has to steepen a material until it holds a tool with all it has.
constexpr double FullCohesion = 15;
/// N/m; 3 cm deep in dry sand is 3.6 N, in the middle of what desktop devices can push.
constexpr double SandResistance = 120;

double tangent(double degrees)
{
    return std::tan(degrees * std::numbers::pi / 180);
}

} // namespace

// The resistance of granular material to an intruder grows linearly with depth, in proportion to weight and to a
// factor that rises with internal friction (C. Li, T. Zhang, D. Goldman, A Terradynamics of Legged Locomotion on
// Granular Media, 2013). Differs: the factor is the tangent of the angle of repose, relative to dry sand's; a device
// needs the relation of materials to each other, not their pascals.
Feel feelOf(const terrain::Material &material, double humidity)
{
    const double wet = std::clamp(humidity, 0.0, 1.0);
    const double angle = terrain::criticalAngleAt(material, wet);
    const double cohesion = std::clamp((angle - terrain::criticalAngleAt(material, 0)) / FullCohesion, 0.0, 1.0);
    const double firmness = material.bulkDensity / SandDensity * tangent(angle) / tangent(SandAngle);
    const double stiff = std::clamp(firmness, 0.05, 4.0) * (1 - 0.6 * std::clamp(material.compressibility, 0.0, 1.0));

    Feel feel;
    feel.resistance = SandResistance * stiff;
    feel.plough = 0.75 * SandResistance * stiff;
    feel.crust = 0.15 * stiff + 0.35 * cohesion;
    feel.elasticity = std::clamp(500 * std::sqrt(stiff), 200.0, 900.0);
    // Water between grains flows: the wetter, the more the speed counts.
    feel.damping = 0.2 + 0.3 * wet;
    feel.hold = 0.05 + 0.55 * cohesion + 0.2 * wet;
    feel.graininess = std::clamp(0.05 + 0.1 * material.roughness, 0.0, 0.3) * (1 - 0.8 * std::max(cohesion, wet));
    feel.grainSize = 0.0004 + 0.002 * material.roughness * material.roughness;
    return feel;
}

Feel rockFeel()
{
    Feel feel;
    feel.resistance = 4000;
    feel.crust = 10;
    feel.plough = 400;
    feel.elasticity = 900;
    feel.damping = 0.2;
    feel.hold = 0;
    feel.graininess = 0;
    return feel;
}

} // namespace model::haptics
