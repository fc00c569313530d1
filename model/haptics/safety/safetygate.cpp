// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/safety/safetygate.h"

#include <algorithm>
#include <cmath>

namespace model::haptics {

namespace {

bool isFinite(Vec3d v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double lengthOf(Vec3d v)
{
    return std::hypot(v.x, v.y, v.z); // does not overflow
}

Vec3d shortened(Vec3d v, double limit)
{
    const double length = lengthOf(v);
    return length > limit ? v * (limit / length) : v;
}

/// `value` if it is a number above 0, else nothing.
double positive(double value)
{
    return value > 0 ? value : 0;
}

} // namespace

void SafetyGate::setLimits(const SafetyLimits &limits)
{
    mLimits = limits;
}

void SafetyGate::start()
{
    if (mState != SafetyState::Stopped)
        return;
    mState = SafetyState::Waiting;
    mCause = SafetyCause::None;
    mSmallSteps = 0;
    mRise = 0;
}

void SafetyGate::stop()
{
    mCause = SafetyCause::Stopped;
    if (mState == SafetyState::Stopped)
        return;
    mState = SafetyState::Fading;
    mFadeRate = std::max(mFadeRate, lengthOf(mForce) / seconds(FadeTime));
}

double SafetyGate::forceLimit() const
{
    return std::min({HardForceLimit, positive(mLimits.deviceForce), positive(mLimits.userForce)});
}

SafetyCause SafetyGate::causeOf(const SafetyInput &input) const
{
    if (!isFinite(input.wanted) || !isFinite(input.position) || !isFinite(input.velocity))
        return SafetyCause::BadNumber;
    if (!input.isConnected)
        return SafetyCause::DeviceLost;
    if (input.readingAge > LargestReadingAge)
        return SafetyCause::DeviceSilent;
    if (input.snapshotAge > LargestSnapshotAge)
        return SafetyCause::StaleSnapshot;
    if (input.elapsed > LatestStep)
        return SafetyCause::LateLoop;
    return SafetyCause::None;
}

Vec3d SafetyGate::wall(Vec3d position) const
{
    const auto push = [this](double at, double low, double high) {
        const double beyond = at > high ? high - at : at < low ? low - at : 0;
        return std::isfinite(beyond) ? positive(mLimits.wallStiffness) * beyond : 0;
    };
    const Vec3d force(push(position.x, mLimits.low.x, mLimits.high.x), push(position.y, mLimits.low.y, mLimits.high.y),
                      push(position.z, mLimits.low.z, mLimits.high.z));
    return isFinite(force) ? shortened(force, positive(mLimits.wallForce)) : Vec3d();
}

/// What may be asked for in this step, before it is slewed.
Vec3d SafetyGate::target(const SafetyInput &input)
{
    if (mState == SafetyState::Waiting) {
        mSmallSteps = lengthOf(input.wanted) < SmallForce ? mSmallSteps + 1 : 0;
        if (mSmallSteps < SmallSteps)
            return {};
        mState = SafetyState::Rising;
        mRise = 0;
    }
    Vec3d force = shortened(input.wanted, HardForceLimit) + wall(input.position);
    if (mState == SafetyState::Rising) {
        mRise += seconds(std::clamp(input.elapsed, Time(0), LongestStep)) / seconds(SoftStart);
        if (mRise >= 1)
            mState = SafetyState::On;
        else
            force = force * mRise;
        if (mRise < 1 && input.rate > StartDampingRate)
            force = force - shortened(input.velocity, HardForceLimit / StartDamping) * (StartDamping * (1 - mRise));
    }
    force = shortened(force, forceLimit());
    const double power = std::abs(dot(force, input.velocity)), limit = positive(mLimits.power);
    return power > limit ? force * (limit / power) : force;
}

/// One step from the force before towards `target`.
Vec3d SafetyGate::slewed(Vec3d target, Time elapsed) const
{
    const Vec3d change = target - mForce;
    const bool falls = lengthOf(target) <= lengthOf(mForce) && dot(target, mForce) >= 0;
    const double step = seconds(std::clamp(elapsed, Time(0), LongestStep)) * (falls ? FallRate : RiseRate);
    return mForce + shortened(change, step);
}

/// One step towards nothing, by the time that really went by: after a long sleep at once.
Vec3d SafetyGate::faded(Time elapsed)
{
    const double length = lengthOf(mForce), left = length - mFadeRate * positive(seconds(elapsed));
    return left > 0 ? mForce * (left / length) : Vec3d();
}

Vec3d SafetyGate::filter(const SafetyInput &input)
{
    if (mState == SafetyState::Stopped)
        return mForce = {};
    const SafetyCause cause = causeOf(input);
    if (cause != SafetyCause::None && mCause != SafetyCause::Stopped && mCause != SafetyCause::BadNumber) {
        if (mState != SafetyState::Fading)
            mFadeRate = lengthOf(mForce) / seconds(FadeTime);
        mState = SafetyState::Fading;
        mCause = cause;
    }
    if (mState != SafetyState::Fading) {
        mForce =
            shortened(slewed(target(input), input.elapsed), std::min(HardForceLimit, positive(mLimits.deviceForce)));
        return mForce;
    }

    mForce = faded(input.elapsed);
    if (lengthOf(mForce) > 0)
        return mForce;
    mFadeRate = 0;
    if (mCause == SafetyCause::Stopped || mCause == SafetyCause::BadNumber)
        mState = SafetyState::Stopped;
    else if (cause == SafetyCause::None) {
        mState = SafetyState::Waiting;
        mCause = SafetyCause::None;
        mSmallSteps = 0;
    }
    return mForce;
}

} // namespace model::haptics
