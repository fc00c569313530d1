// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/device/simulateddevice.h"
#include "model/haptics/force/granularlaw.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace tests {

/// Whether a hand that presses on ground of `stiffness` N/m comes to rest, when the force reaches it `delay`
/// milliseconds after it was computed, at 1000 Hz. The ground does not yield, so that nothing but the loop is tried.
inline bool comesToRest(double stiffness, int delay, const model::haptics::SimulatedHand &hand = {})
{
    using namespace model::haptics;
    model::haptics::SimulatedHand held = hand;
    held.position = {0, 0, 0.001};
    const GranularLaw law;
    Feel feel;
    feel.elasticity = stiffness;
    feel.crust = 1e6;
    feel.damping = feel.graininess = 0;
    LawMemory memory;
    std::deque<model::Vec3d> underway;
    underway.resize(std::size_t(delay));
    double low = 1e9, high = -1e9;
    constexpr int Steps = 6000, Watched = 500;
    for (int i = 0; i < Steps; ++i) {
        Contact contact;
        contact.isKnown = true;
        contact.position = held.position;
        contact.centreDepth = -held.position.z;
        contact.ringDepth.fill(contact.centreDepth);
        contact.dt = 0.001;
        contact.stiffnessLimit = 1e9;
        underway.push_back(law.force(contact, feel, memory));
        held.advance({0, 0, -0.01}, underway.front(), 0.001);
        underway.pop_front();
        if (!(std::abs(held.position.z) < 1))
            return false;
        if (i >= Steps - Watched) {
            low = std::min(low, held.position.z);
            high = std::max(high, held.position.z);
        }
    }
    return high - low < 2e-5;
}

/// N/m: the stiffest ground on which it does, to 1 %.
inline double stiffestStable(int delay, const model::haptics::SimulatedHand &hand = {})
{
    double stable = 1, unstable = 1e5;
    while (unstable > 1.01 * stable)
        (comesToRest(std::sqrt(stable * unstable), delay, hand) ? stable : unstable) = std::sqrt(stable * unstable);
    return stable;
}

} // namespace tests
