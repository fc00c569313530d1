// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/device/hapticdevice.h"
#include "model/haptics/force/forceblend.h"
#include "model/haptics/servo/settings.h"
#include "model/haptics/servo/velocity.h"
#include "model/haptics/snapshot/triplebuffer.h"

#include <array>
#include <atomic>
#include <memory>

namespace model::haptics {

/// What one step took and gave: enough to do it again.
struct ServoSample
{
    Time now{0};
    Reading reading;
    std::uint64_t patch = 0;    ///< id of the ground that was felt; 0: none
    std::uint64_t settings = 0; ///< id
    bool wantsForces = false;
    Vec3d force;      ///< N, what the device was given
    Vec3d lawForce;   ///< N, before the safety gate
    double depth = 0; ///< m of the hand, below the ground under the centre; 0 without ground
    SafetyState state = SafetyState::Stopped;
    SafetyCause cause = SafetyCause::Stopped;
};

/// One step of the servo as a function of what came before it, the reading, and the time: no clock, no thread. The
/// thread drives it by the real clock, replay and tests by a virtual one, with the same result to the last bit.
///
/// step() takes no lock, allocates nothing and makes no system call. The other functions are for one other thread.
class ServoCore
{
public:
    ServoCore();

    /// Where the next patch is to be written. publish() hands it over.
    TerrainPatch &nextPatch() { return mPatches->writable(); }
    void publishPatch() { mPatches->publish(); }
    void publishSettings(const ServoSettings &settings);
    /// Forces are off until this asks for them. After a latched fault they have to be put off and on again.
    void setForces(bool on) { mWantsForces.store(on, std::memory_order_relaxed); }
    bool wantsForces() const { return mWantsForces.load(std::memory_order_relaxed); }

    /// The servo's own; `reading` is of `now` or before.
    ServoSample step(const Reading &reading, Time now);

    /// The period that the loop can be trusted to keep: the second longest of the last thousand.
    Time trustedPeriod() const { return mPeriods.trusted(); }

private:
    /// Finds the second longest of a thousand periods, and heeds longer ones at once.
    class Periods
    {
    public:
        void add(Time period);
        Time trusted() const { return std::max(mBefore, mSecond); }

    private:
        Time mLongest{0}, mSecond{0};
        Time mBefore = 2 * ServoPeriod; ///< of the thousand before; cautious at the start
        int mCount = 0;
    };

    void takeSettings();
    void heedSwitch(bool wantsForces);
    Vec3d lawForce(const Reading &reading, Vec3d velocity, Time elapsed, ServoSample &sample);
    Vec3d ask(const Contact &contact, LawMemory &memory) const;
    Contact contactHere(Vec3d position, Vec3d velocity, Time elapsed) const;

    // Shared with the other thread. On the heap: three patches are 180 KiB.
    std::unique_ptr<TripleBuffer<TerrainPatch>> mPatches;
    TripleBuffer<ServoSettings> mNewSettings;
    std::atomic<bool> mWantsForces = false;

    // The servo's own.
    std::array<std::unique_ptr<ForceLaw>, std::size(EveryLaw)> mLaws;
    const ForceLaw *mLaw;
    ServoSettings mSettings;
    LawMemory mMemory;
    ForceBlend mBlend;
    SafetyGate mGate;
    VelocityWindow mVelocity;
    Periods mPeriods;
    bool mWasWanted = false; ///< forces, in the step before
    bool mHasToStart = false;
    bool mHasBegun = false;
    Time mBefore{0};
};

} // namespace model::haptics
