// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/device/hapticdevice.h"
#include "model/haptics/device/latest.h"
#include "model/haptics/hid/hidlink.h"
#include "model/haptics/hid/pidlayout.h"

#include <optional>

namespace model::haptics {

/// A USB force-feedback stick (HID PID): experimental. Two axes have force, in steps of UpdateTime; a third axis, if it
/// has one, is height.
///
/// The one effect is a constant force that lasts EffectTime and is started anew before it ends: should the program
/// hang or die, the stick lets go by itself.
class PidDevice final : public HapticDevice, public HidHandler
{
public:
    static constexpr double Reach = 0.08; ///< m of the hand at full deflection
    static constexpr double MaxForce = 4; ///< N, of common sticks at full magnitude
    static constexpr Time UpdateTime = std::chrono::milliseconds(8);
    static constexpr Time EffectTime = std::chrono::milliseconds(60);
    static constexpr Time RestartTime = std::chrono::milliseconds(24);

    /// \param fields  of the device's descriptor; precondition: hasConstantForce(fields)
    PidDevice(const HidDeviceInfo &info, std::vector<HidField> fields);

    const Capabilities &capabilities() const override { return mCapabilities; }
    Reading read(Time now) noexcept override;
    void write(Vec3d force, Time now) noexcept override;

    /// \error UnsupportedFeature  the device has no room for an effect
    /// \error CannotRead          or does not say whether
    Result<void> connected(HidTransport &transport) override;
    void received(std::span<const std::uint8_t> report, Time now) override;
    Result<void> serve(HidTransport &transport, Time now) override;
    void disconnected() override;
    void closing(HidTransport &transport) override;

private:
    struct Said
    {
        Vec3d position;
        std::uint32_t buttons = 0;
        bool isConnected = false;
    };
    struct Wanted
    {
        Vec3d force;
        Time time{0};
    };

    Result<void> control(HidTransport &transport, HidUsage what) const;
    Result<std::uint8_t> loadEffect(HidTransport &transport) const;
    PidReport effectReport(double turns) const;
    bool takeAxis(std::span<const std::uint8_t> report, HidUsage axis, double &value) const;

    const std::vector<HidField> mFields;
    Capabilities mCapabilities;
    Latest<Said> mLatest;
    Latest<Wanted> mWanted;
    // The link's:
    Said mSaid;
    std::uint8_t mEffect = 0; ///< block index
    Time mUpdated{0}, mStarted{0};
    bool mIsPlaying = false;
    // The servo's:
    Said mRead;
};

} // namespace model::haptics
