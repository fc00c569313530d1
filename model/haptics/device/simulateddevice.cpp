// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/device/simulateddevice.h"

#include <algorithm>
#include <cmath>

namespace model::haptics {

namespace {

/// s: steps of the hand; far below its own times (mass / damping is 50 ms).
constexpr double HandStep = 0.0001;
/// s: a longer pause moves the hand no further.
constexpr double LongestPause = 0.1;

} // namespace

void SimulatedHand::advance(Vec3d wanted, Vec3d force, double dt)
{
    const double time = std::clamp(dt, 0.0, LongestPause);
    const int steps = std::max(1, int(std::ceil(time / HandStep)));
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        const Vec3d push = force + (wanted - position) * stiffness - velocity * damping;
        velocity = velocity + push * (h / mass);
        position = position + velocity * h;
    }
}

SimulatedDevice::SimulatedDevice()
{
    mCapabilities.name = "Simulated device";
    mCapabilities.hasForce = true;
    mCapabilities.maxForce = 10;
    mCapabilities.low = {-0.2, -0.2, -0.2};
    mCapabilities.high = {0.2, 0.2, 0.2};
    mCapabilities.buttonCount = 1;
}

void SimulatedDevice::moveTo(Vec3d position, std::uint32_t buttons)
{
    mWanted.set({position, buttons});
}

void SimulatedDevice::follow(Trajectory trajectory)
{
    mTrajectory = std::move(trajectory);
    if (mHasHand && !mTrajectory.isEmpty())
        mHand.position = mTrajectory.at(0).position;
}

void SimulatedDevice::holdWith(const SimulatedHand &hand)
{
    mHand = hand;
    mHasHand = true;
    if (!mTrajectory.isEmpty())
        mHand.position = mTrajectory.at(0).position;
}

Vec3d SimulatedDevice::lastForce() const
{
    Vec3d force;
    mShownForce.read(force);
    return force;
}

Reading SimulatedDevice::read(Time now) noexcept
{
    if (!mHasBegun) {
        mHasBegun = true;
        mBegin = mBefore = now;
    }
    if (mTrajectory.isEmpty()) {
        mWanted.read(mPose);
    } else {
        const Trajectory::Point point = mTrajectory.at(seconds(now - mBegin));
        mPose = {point.position, point.buttons};
    }
    if (mHasHand)
        mHand.advance(mPose.position, mForce, seconds(now - mBefore));
    mBefore = now;
    mReading.isConnected = mIsConnected.load(std::memory_order_relaxed);
    if (mReading.isConnected && !mIsSilent.load(std::memory_order_relaxed)) {
        mReading.position = mHasHand ? mHand.position : mPose.position;
        mReading.buttons = mPose.buttons;
        mReading.time = now;
    }
    return mReading;
}

void SimulatedDevice::write(Vec3d force, Time) noexcept
{
    mForce = force;
    mShownForce.set(force);
}

} // namespace model::haptics
