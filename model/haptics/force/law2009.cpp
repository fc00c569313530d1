// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: V. Purchart, modelling of sandy terrain for virtual reality (master thesis, in Czech), 2009, 5.3.2 - 5.3.5
// Differs: the gel force acts against the motion (the text raises the force that is there, whatever its direction); at
// rest, where there is no such direction, it is left out.
#include "model/haptics/force/law2009.h"

#include <algorithm>
#include <cmath>

namespace model::haptics {

namespace {

/// m/s: slower, there is no direction of motion.
constexpr double Resting = 1e-6;

/// The depth where the ray from the centre along `direction` leaves the polygon of control points: between the two
/// that enclose it, as far along their edge as the ray crosses it (figure 5.3.5).
double depthAlong(const Contact &contact, terrain::Point2 direction)
{
    const auto cross = [](terrain::Point2 a, terrain::Point2 b) { return a.x * b.y - a.y * b.x; };
    for (std::uint32_t i = 0; i < RingPoints; ++i) {
        const std::uint32_t j = (i + 1) % RingPoints;
        const double before = cross(RingDirections[i], direction), after = cross(direction, RingDirections[j]);
        if (before < 0 || after <= 0)
            continue;
        const double t = before / (before + after);
        return contact.ringDepth[i] * (1 - t) + contact.ringDepth[j] * t;
    }
    return contact.centreDepth;
}

} // namespace

Vec3d Law2009::force(const Contact &contact, const Feel &, LawMemory &) const
{
    const double early = mParts.early ? Early : 0;
    const double depth = contact.centreDepth / MetresPerUnit;
    if (!contact.isKnown || depth + early <= 0)
        return {};
    Vec3d force = Vec3d(0, 0, Stiffness * (early + depth)) + sideways(contact);
    const double speed = std::sqrt(dot(contact.velocity, contact.velocity));
    if (mParts.gel && depth > 0 && dot(force, force) < Gel * Gel && speed > Resting)
        force = contact.velocity * (-Gel / speed);
    return force;
}

Vec3d Law2009::sideways(const Contact &contact) const
{
    const auto against = [](terrain::Point2 direction, double depth) {
        const double push = Stiffness * std::max(0.0, depth) / MetresPerUnit;
        return Vec3d(-direction.x * push, -direction.y * push, 0);
    };
    Vec3d sum;
    if (mParts.sideways == Sideways::Averaged) {
        for (std::uint32_t i = 0; i < RingPoints; ++i)
            sum = sum + against(RingDirections[i], contact.ringDepth[i]) * (1.0 / RingPoints);
    } else if (mParts.sideways == Sideways::AlongMotion) {
        const double speed = std::hypot(contact.velocity.x, contact.velocity.y);
        if (speed > Resting) {
            const terrain::Point2 direction{contact.velocity.x / speed, contact.velocity.y / speed};
            sum = against(direction, depthAlong(contact, direction));
        }
    }
    return sum;
}

} // namespace model::haptics
