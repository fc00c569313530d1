// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/device/hapticdevice.h"
#include "model/haptics/device/latest.h"
#include "model/haptics/device/trajectory.h"

#include <atomic>

namespace model::haptics {

/// A hand that holds a tool: a mass on a spring and damper to where the hand wants to be, pushed by the device. It is
/// what a force meets in the end, so loops are tested with it.
struct SimulatedHand
{
    double mass = 0.15;     ///< kg, hand and stylus
    double damping = 3;     ///< N s/m
    double stiffness = 150; ///< N/m, of the grip
    Vec3d position, velocity;

    /// Moves on by `dt` seconds, in steps short enough to be exact. Semi-implicit: it gains no energy by itself.
    void advance(Vec3d wanted, Vec3d force, double dt);
};

/// The device that is always there: moved by a mouse (through moveTo()) or by a trajectory; by a hand that gives way to
/// the force, or by one that does not. Forces go nowhere else: the last one can be asked for.
class SimulatedDevice final : public HapticDevice
{
public:
    SimulatedDevice();

    /// From any one thread, at any time.
    void moveTo(Vec3d position, std::uint32_t buttons);
    /// Follows `trajectory` from the first read() on, instead of moveTo(). Before the servo starts.
    void follow(Trajectory trajectory);
    /// Puts a hand in between. Before the servo starts.
    void holdWith(const SimulatedHand &hand);
    /// As if unplugged, or plugged in again.
    void setConnected(bool connected) { mIsConnected.store(connected, std::memory_order_relaxed); }
    /// Says nothing new while it is silent.
    void setSilent(bool silent) { mIsSilent.store(silent, std::memory_order_relaxed); }
    Vec3d lastForce() const;

    const Capabilities &capabilities() const override { return mCapabilities; }
    Reading read(Time now) noexcept override;
    void write(Vec3d force, Time now) noexcept override;

private:
    struct Pose
    {
        Vec3d position;
        std::uint32_t buttons = 0;
    };

    Capabilities mCapabilities;
    Latest<Pose> mWanted;
    Latest<Vec3d> mShownForce;
    Trajectory mTrajectory;
    SimulatedHand mHand;
    bool mHasHand = false;
    std::atomic<bool> mIsConnected = true, mIsSilent = false;
    // Of the servo's thread:
    bool mHasBegun = false;
    Time mBegin{0}, mBefore{0};
    Pose mPose;
    Vec3d mForce;
    Reading mReading;
};

} // namespace model::haptics
