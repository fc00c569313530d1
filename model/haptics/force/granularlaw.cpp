// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: P. Dupont, V. Hayward, B. Armstrong, F. Altpeter, Single State Elastoplastic Friction Models, 2002 (the
// rest point); C. Li, T. Zhang, D. Goldman, A Terradynamics of Legged Locomotion on Granular Media, 2013 (resistance
// linear in depth, and less on the way out); B. Benes and others, Hands On Virtual Clay, 2006 (vertical repulsion and
// viscous drag).
// Differs: one rest point for all directions, with a yield surface that is an ellipsoid, so that force and yield have
// one direction and pressing down while moving sideways costs less than both alone.
#include "model/haptics/force/granularlaw.h"

#include <algorithm>
#include <cmath>

namespace model::haptics {

namespace {

/// m/s: faster, grains are felt in full.
constexpr double GrainSpeed = 0.02;
/// s: in which they come and go when the motion begins and ends.
constexpr double GrainFade = 0.02;
/// N: a yield force below makes no direction.
constexpr double LeastYield = 1e-3;

/// 0 at `x` <= 0, 1 at `x` >= 1, with slopes of 0 there.
double smoothStep(double x)
{
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// A value in -1 ... 1 for each grain: splitmix64's last step.
double grain(std::int64_t number)
{
    std::uint64_t x = std::uint64_t(number) * 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return double(std::int64_t(x ^ (x >> 31))) * 0x1p-63;
}

/// Smooth in the way gone.
double roughness(double travel, double grainSize)
{
    constexpr double LargestGrain = 1e15;
    const double at = travel / grainSize;
    if (!(at >= 0 && at < LargestGrain))
        return 0;
    const std::int64_t number = std::int64_t(at);
    const double t = smoothStep(at - double(number));
    return grain(number) * (1 - t) + grain(number + 1) * t;
}

struct Yield
{
    double up, down, sideways; ///< N, for a force on the hand in these directions
};

Yield yieldOf(const Contact &contact, const Feel &feel, Vec3d motion)
{
    double around = 0, ahead = 0, weights = 0;
    const double length = std::hypot(motion.x, motion.y);
    for (std::uint32_t i = 0; i < RingPoints; ++i) {
        const double depth = std::max(0.0, contact.ringDepth[i]);
        around += depth * (1.0 / RingPoints);
        const terrain::Point2 direction = RingDirections[i];
        const double weight =
            length > 0 ? std::max(0.0, (direction.x * motion.x + direction.y * motion.y) / length) : 1.0;
        ahead += weight * depth;
        weights += weight;
    }
    const double below = std::max(around, 0.0);
    const double push = feel.crust + feel.resistance * below;
    const double side = 0.5 * feel.crust + feel.plough * (weights > 0 ? ahead / weights : below);
    return {std::max(push, LeastYield), std::max(feel.hold * push, LeastYield), std::max(side, LeastYield)};
}

} // namespace

Vec3d GranularLaw::force(const Contact &contact, const Feel &feel, LawMemory &memory) const
{
    const double presence = contact.isKnown ? smoothStep(1 + contact.centreDepth / Skin) : 0;
    if (presence == 0) {
        memory.isTouching = false;
        return {};
    }
    if (!memory.isTouching) {
        memory.isTouching = true;
        memory.rest = contact.position;
    }

    const double stiffness = std::min(feel.elasticity, contact.stiffnessLimit);
    Vec3d strain = contact.position - memory.rest;
    const Yield yield = yieldOf(contact, feel, strain);
    const double vertical = strain.z < 0 ? yield.up : yield.down;
    const double load =
        stiffness * std::sqrt((strain.x * strain.x + strain.y * strain.y) / (yield.sideways * yield.sideways) +
                              strain.z * strain.z / (vertical * vertical));
    double slip = 0;
    if (load > 1) {
        slip = (1 - 1 / load) * std::sqrt(dot(strain, strain));
        strain = strain * (1 / load);
        memory.rest = contact.position - strain;
    }

    // Grains come with the way that the material gives, not with that of the tool: an elastic tremor stirs none.
    memory.travel += slip;
    const double moving = contact.dt > 0 ? std::min(1.0, slip / contact.dt / GrainSpeed) : 0;
    memory.grains += (moving - memory.grains) * std::min(1.0, contact.dt / GrainFade);
    const double grains = feel.graininess * memory.grains * roughness(memory.travel, feel.grainSize);
    const double damping = std::min(feel.damping, contact.dampingLimit);
    return (strain * (-stiffness * (1 + grains)) + contact.velocity * -damping) * presence;
}

} // namespace model::haptics
