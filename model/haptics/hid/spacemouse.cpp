// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/hid/spacemouse.h"

#include <algorithm>
#include <cmath>

namespace model::haptics {

namespace {

constexpr Time LongestStep = std::chrono::milliseconds(20);

} // namespace

Vec3d deflectionOf(const SpaceMouseState &state)
{
    const auto share = [](int axis) {
        const double all = double(axis) / SpaceMouseState::FullDeflection;
        const double beyond = (std::abs(all) - SpaceMouse::DeadZone) / (1 - SpaceMouse::DeadZone);
        return beyond > 0 ? std::copysign(beyond, all) : 0.0;
    };
    return {share(state.axes[0]), share(-state.axes[1]), share(-state.axes[2])};
}

SpaceMouse::SpaceMouse(const HidDeviceInfo &info)
{
    mCapabilities.name = info.productName.empty() ? "SpaceMouse" : info.productName;
    mCapabilities.movesByDeflection = true;
    mCapabilities.hasLight = true;
    mCapabilities.buttonCount = 2;
}

SpaceMouseState SpaceMouse::state() const
{
    Said said;
    mLatest.read(said);
    return said.state;
}

Reading SpaceMouse::read(Time now) noexcept
{
    mLatest.read(mRead);
    const Time elapsed = mHasBegun ? std::clamp(now - mBefore, Time(0), LongestStep) : Time(0);
    mHasBegun = true;
    mBefore = now;
    if (mRead.isConnected && now - mRead.time <= LongestSilence) {
        const Vec3d moved = mPosition + deflectionOf(mRead.state) * (FullSpeed * seconds(elapsed));
        const Vec3d &low = mCapabilities.low, &high = mCapabilities.high;
        mPosition = {std::clamp(moved.x, low.x, high.x), std::clamp(moved.y, low.y, high.y),
                     std::clamp(moved.z, low.z, high.z)};
    }
    // It is silent while nobody touches it; where the tool is, is known all the same.
    return {mPosition, mRead.state.buttons, now, mRead.isConnected};
}

Result<void> SpaceMouse::connected(HidTransport &)
{
    mSaid = {};
    mSaid.isConnected = true;
    mHasSentLight = false;
    mLatest.set(mSaid);
    return {};
}

void SpaceMouse::received(std::span<const std::uint8_t> report, Time now)
{
    if (!takeSpaceMouseReport(report, mSaid.state))
        return;
    mSaid.time = now;
    mLatest.set(mSaid);
}

Result<void> SpaceMouse::serve(HidTransport &transport, Time)
{
    const bool wanted = mLight.load(std::memory_order_relaxed);
    if (mHasSentLight && wanted == mSentLight)
        return {};
    mHasSentLight = true;
    mSentLight = wanted;
    // Models without a light refuse this; whether the device is still there shows when it is read.
    (void)transport.write(spaceMouseLight(wanted));
    return {};
}

void SpaceMouse::disconnected()
{
    mSaid = {};
    mLatest.set(mSaid);
}

void SpaceMouse::closing(HidTransport &transport)
{
    (void)transport.write(spaceMouseLight(false));
}

} // namespace model::haptics
