// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/record/recording.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

namespace model::haptics {

namespace {

bool isSame(Vec3d a, Vec3d b)
{
    return std::memcmp(&a, &b, sizeof a) == 0; // bits: NaN is itself, and -0 is not 0
}

double lengthOf(Vec3d v)
{
    return std::hypot(v.x, v.y, v.z);
}

/// Hands a core the settings and patches that the recorded steps had, when they had them.
class Stage
{
public:
    explicit Stage(ServoCore &core)
        : mCore(core)
    {}

    void add(const ServoSettings &settings) { mSettings[settings.id] = &settings; }
    void add(const RecordedPatch &patch)
    {
        mPatches[patch.id] = {&patch, patch.isRefresh ? mGround : &patch};
        if (!patch.isRefresh)
            mGround = &patch;
    }

    Result<void> prepare(const ServoSample &sample)
    {
        if (sample.settings != mSettingsId) {
            const auto found = mSettings.find(sample.settings);
            if (found == mSettings.end())
                return fail(ErrorCode::BadValue, "settings of a step", std::to_string(sample.settings),
                            "recorded ones");
            mCore.publishSettings(*found->second);
            mSettingsId = sample.settings;
        }
        if (sample.patch == mPatchId)
            return {};
        const auto found = mPatches.find(sample.patch);
        if (found == mPatches.end() || !found->second.ground)
            return fail(ErrorCode::BadValue, "ground of a step", std::to_string(sample.patch), "recorded ones");
        const auto &[patch, ground] = found->second;
        TerrainPatch &next = mCore.nextPatch();
        next.id = patch->id;
        next.time = patch->time;
        next.centre = patch->centre;
        next.centreHeight = patch->centreHeight;
        next.radius = patch->radius;
        next.feel = patch->feel;
        std::copy(ground->triangles.begin(), ground->triangles.end(), next.triangles.begin());
        next.triangleCount = std::uint32_t(ground->triangles.size());
        next.index();
        mCore.publishPatch();
        mPatchId = sample.patch;
        mPatches.erase(mPatches.begin(), found); // the servo never goes back
        return {};
    }

private:
    struct Patch
    {
        const RecordedPatch *patch = nullptr;
        const RecordedPatch *ground = nullptr; ///< whose triangles it has
    };

    ServoCore &mCore;
    std::map<std::uint64_t, const ServoSettings *> mSettings;
    std::map<std::uint64_t, Patch> mPatches;
    const RecordedPatch *mGround = nullptr;
    std::uint64_t mSettingsId = 0, mPatchId = 0;
};

} // namespace

Result<Replay> replay(const Recording &recording)
{
    ServoCore core;
    Stage stage(core);
    Replay result;
    Time first{0};
    for (const Recording::Event &event : recording.events) {
        if (const auto *settings = std::get_if<ServoSettings>(&event)) {
            stage.add(*settings);
            continue;
        }
        if (const auto *patch = std::get_if<RecordedPatch>(&event)) {
            stage.add(*patch);
            continue;
        }
        const ServoSample &then = std::get<ServoSample>(event);
        if (auto prepared = stage.prepare(then); !prepared)
            return fail(std::move(prepared).error());
        core.setForces(then.wantsForces);
        const ServoSample now = core.step(then.reading, then.now);
        if (result.steps == 0)
            first = then.now;
        if (!isSame(now.force, then.force) || now.state != then.state || now.cause != then.cause) {
            if (result.different++ == 0)
                result.firstDifferent = result.steps;
            result.largestDifference = std::max(result.largestDifference, lengthOf(now.force - then.force));
        }
        result.largestForce = std::max(result.largestForce, lengthOf(now.force));
        result.duration = seconds(then.now - first);
        result.samples.push_back(now);
        ++result.steps;
    }
    return result;
}

} // namespace model::haptics
