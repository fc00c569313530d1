// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/record/session.h"

#include "model/haptics/snapshot/patchbuilder.h"

namespace model::haptics {

namespace {

/// The patch reaches so many radii of the tool around it: it must not leave it within a period of snapshots.
constexpr double PatchReach = 6;

} // namespace

Recording simulateSession(const terrain::Terrain &terrain, const SessionPlan &plan)
{
    SimulatedDevice device;
    device.follow(plan.trajectory);
    device.holdWith(plan.hand);
    Recorder recorder(device.capabilities().name);
    ServoCore core;
    ServoSettings settings = plan.settings;
    settings.id = 1;
    core.publishSettings(settings);
    recorder.add(settings);
    core.setForces(plan.wantsForces);

    PatchBuilder builder;
    Time now{0}, refreshed{0};
    std::uint64_t patches = 0;
    Vec3d position = plan.trajectory.at(0).position;
    const Time end(std::int64_t(plan.trajectory.duration() * 1e9));
    for (; now <= end; now += ServoPeriod) {
        if (patches == 0 || now - refreshed >= plan.snapshotPeriod) {
            refreshed = now;
            TerrainPatch &patch = core.nextPatch();
            const terrain::Point3 tool = settings.workspace.toTerrain(position);
            builder.build(terrain, {tool.x, tool.y}, PatchReach * settings.workspace.toolRadius, patch);
            patch.id = ++patches;
            patch.time = now;
            recorder.add(patch);
            core.publishPatch();
        }
        const Reading reading = device.read(now);
        const ServoSample sample = core.step(reading, now);
        device.write(sample.force, now);
        position = reading.position;
        recorder.add({&sample, 1});
    }
    return recorder.recording();
}

} // namespace model::haptics
