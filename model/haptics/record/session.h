// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/device/simulateddevice.h"
#include "model/haptics/record/recording.h"
#include "model/terrain/terrain.h"

namespace model::haptics {

/// What a simulated hand does on a terrain.
struct SessionPlan
{
    ServoSettings settings; ///< its id is set by the session
    Trajectory trajectory;  ///< not empty
    SimulatedHand hand;
    Time snapshotPeriod = std::chrono::milliseconds(20); ///< as an editor at 50 Hz
    bool wantsForces = true;                             ///< from the beginning
};

/// The session, taken down step by step on a virtual clock: the same plan gives the same recording, at once.
Recording simulateSession(const terrain::Terrain &terrain, const SessionPlan &plan);

} // namespace model::haptics
