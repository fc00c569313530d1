// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/force/forcelaw.h"
#include "model/haptics/safety/safetygate.h"

namespace model::haptics {

/// What can be changed while the servo runs. Plain data.
struct ServoSettings
{
    std::uint64_t id = 0; ///< counts up with every change; set by whoever hands them over
    Workspace workspace;
    LawKind law = LawKind::Granular;
    double gain = 1; ///< of the law's force, 0 ... 2
    SafetyLimits limits;
    bool overridesFeel = false; ///< `feel` instead of the patch's own
    Feel feel;
    double deviceDamping = 1; ///< N s/m, as Capabilities::damping

    friend bool operator==(const ServoSettings &, const ServoSettings &) = default;
};

} // namespace model::haptics
