// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/servo/servocore.h"
#include "model/haptics/snapshot/patchbuilder.h"

#include <functional>
#include <random>

namespace tests {

/// A terrain over -1 ... 1 with a vertex each `spacing`, at the height that `height` says.
model::terrain::Terrain groundOf(double spacing, const std::function<double(double, double)> &height);

/// A level patch around the origin, 1 m to each side.
void levelPatch(model::haptics::TerrainPatch &patch, double height, const model::haptics::Feel &feel);
/// The same with its own height at each of its corners: (-1,-1), (1,-1), (1,1), (-1,1).
void tiltedPatch(model::haptics::TerrainPatch &patch, const std::array<float, 4> &heights,
                 const model::haptics::Feel &feel);

/// Hand metres are terrain metres; a tool of 1 cm.
model::haptics::Workspace plainWorkspace();

/// Drives a ServoCore by a virtual clock, with a level ground that is refreshed as an editor would.
class VirtualLoop
{
public:
    explicit VirtualLoop(model::haptics::LawKind law = model::haptics::LawKind::Granular);

    /// One step `elapsed` after the last.
    model::haptics::ServoSample step(model::Vec3d position, model::haptics::Time elapsed = model::haptics::ServoPeriod);
    void refresh(double height);
    /// Forces on, and past the soft start, above the ground at 0.
    void arm(model::Vec3d position = {0, 0, 0.05});

    model::haptics::ServoCore core;
    model::haptics::ServoSettings settings;
    model::haptics::Feel feel;
    model::haptics::Time now{1'000'000'000};
    bool isConnected = true;
    bool refreshes = true; ///< each 20 ms
    double height = 0;

private:
    std::uint64_t mPatch = 0;
    model::haptics::Time mRefreshed{0};
};

inline double lengthOf(model::Vec3d v)
{
    return std::hypot(v.x, v.y, v.z);
}

} // namespace tests
