// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/device/hapticdevice.h"
#include "model/haptics/device/latest.h"
#include "model/haptics/hid/hidlink.h"
#include "model/haptics/hid/spacemousereport.h"

namespace model::haptics {

/// A SpaceMouse: it moves the tool while its cap is pushed, or a camera; it has no force.
class SpaceMouse final : public HapticDevice, public HidHandler
{
public:
    static constexpr double FullSpeed = 0.15; ///< m/s, at full deflection
    static constexpr double DeadZone = 0.06;  ///< share of the deflection: the cap never rests quite in the middle
    /// Deflected and silent for longer, it is taken as released.
    static constexpr Time LongestSilence = std::chrono::milliseconds(150);

    explicit SpaceMouse(const HidDeviceInfo &info);

    const Capabilities &capabilities() const override { return mCapabilities; }
    Reading read(Time now) noexcept override;
    void write(Vec3d, Time) noexcept override {}

    /// What it said last, for a camera, and to show. Of any thread.
    SpaceMouseState state() const;
    /// Of any thread; sent at the next round of the link.
    void setLight(bool on) { mLight.store(on, std::memory_order_relaxed); }

    Result<void> connected(HidTransport &transport) override;
    void received(std::span<const std::uint8_t> report, Time now) override;
    Result<void> serve(HidTransport &transport, Time now) override;
    void disconnected() override;
    void closing(HidTransport &transport) override;

private:
    struct Said
    {
        SpaceMouseState state;
        Time time{0};
        bool isConnected = false;
    };

    Capabilities mCapabilities;
    Latest<Said> mLatest;
    std::atomic<bool> mLight = false;
    Said mSaid; ///< the link's
    bool mSentLight = false;
    bool mHasSentLight = false;
    // The servo's:
    Said mRead;
    Vec3d mPosition;
    Time mBefore{0};
    bool mHasBegun = false;
};

/// -1 ... 1 along the hand's axes (x right, y away, z up), without what lies in the dead zone.
Vec3d deflectionOf(const SpaceMouseState &state);

} // namespace model::haptics
