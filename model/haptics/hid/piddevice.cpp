// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: USB Device Class Definition for Physical Interface Devices 1.0; Linux drivers/hid/usbhid/hid-pidff.c (order
// of reports, retries, directions).
#include "model/haptics/hid/piddevice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace model::haptics {

namespace {

using enum HidField::Kind;

constexpr HidUsage AxisX = 0x10030, AxisY = 0x10031, AxisZ = 0x10032, Slider = 0x10036, ButtonPage = 0x90000;
/// As often as the kernel's driver asks.
constexpr int LoadRetries = 60;
/// The servo has said nothing for so long: no force.
constexpr Time LongestSilence = std::chrono::milliseconds(50);
/// N: below, the effect is stopped instead of started anew.
constexpr double LeastForce = 0.01;

} // namespace

PidDevice::PidDevice(const HidDeviceInfo &info, std::vector<HidField> fields)
    : mFields(std::move(fields))
{
    mCapabilities.name = info.productName.empty() ? "Force-feedback device" : info.productName;
    mCapabilities.hasForce = true;
    mCapabilities.isExperimental = true;
    mCapabilities.maxForce = MaxForce;
    mCapabilities.low = {-Reach, -Reach, -Reach};
    mCapabilities.high = {Reach, Reach, Reach};
    for (const HidField &field : mFields)
        if (field.kind == Input && !field.isConstant && !field.usages.empty() &&
            (field.usages[0] & 0xffff0000) == ButtonPage)
            mCapabilities.buttonCount += field.count;
    mCapabilities.buttonCount = std::min(mCapabilities.buttonCount, 32u);
}

Reading PidDevice::read(Time now) noexcept
{
    mLatest.read(mRead);
    // A stick speaks when something changes; the link notices when it is gone.
    return {mRead.position, mRead.buttons, now, mRead.isConnected};
}

void PidDevice::write(Vec3d force, Time now) noexcept
{
    mWanted.set({force, now});
}

Result<void> PidDevice::control(HidTransport &transport, HidUsage what) const
{
    if (!hasReport(mFields, Output, pid::DeviceControlReport))
        return {};
    return transport.write(
        PidReport(mFields, Output, pid::DeviceControlReport).choose(pid::DeviceControl, what).bytes());
}

Result<std::uint8_t> PidDevice::loadEffect(HidTransport &transport) const
{
    const PidReport create =
        PidReport(mFields, Feature, pid::CreateNewEffect).choose(pid::EffectType, pid::ConstantForce);
    if (auto sent = transport.sendFeature(create.bytes()); !sent)
        return fail(std::move(sent).error());
    const HidField &index = *fieldOf(mFields, Feature, pid::BlockLoad, pid::BlockIndex);
    const HidField *const status = fieldOf(mFields, Feature, pid::BlockLoad, pid::BlockLoadSuccess);
    std::vector<std::uint8_t> report(reportSize(mFields, Feature, index.reportId));
    for (int attempt = 0; attempt < LoadRetries; ++attempt) {
        report[0] = index.reportId;
        const auto count = transport.getFeature(report);
        if (!count)
            return fail(count.error());
        const std::span<const std::uint8_t> answer(report.data(), std::min(*count, report.size()));
        const auto says = [&](HidUsage what) {
            if (!status)
                return what == pid::BlockLoadSuccess;
            const auto at = std::find(status->usages.begin(), status->usages.end(), what) - status->usages.begin();
            return status->isArray ? valueIn(answer, *status) == status->least + at
                                   : valueIn(answer, *status, std::uint32_t(at)) != 0;
        };
        const std::int32_t block = valueIn(answer, index);
        if (says(pid::BlockLoadSuccess) && block > 0 && block < 256)
            return std::uint8_t(block);
        if (says(pid::BlockLoadFull))
            return fail(ErrorCode::UnsupportedFeature, "no room for an effect");
    }
    return fail(ErrorCode::CannotRead, "the device does not load an effect");
}

PidReport PidDevice::effectReport(double turns) const
{
    PidReport report(mFields, Output, pid::SetEffect);
    report.set(pid::BlockIndex, mEffect).choose(pid::EffectType, pid::ConstantForce);
    report.set(pid::Duration, EffectTime / std::chrono::milliseconds(1));
    report.setShare(pid::Gain, 1).set(pid::TriggerButton, 255).set(pid::DirectionEnable, 1);
    report.setAngle(pid::Direction, turns);
    return report;
}

Result<void> PidDevice::connected(HidTransport &transport)
{
    for (const HidUsage step : {pid::Reset, pid::EnableActuators})
        if (auto sent = control(transport, step); !sent)
            return sent;
    if (hasReport(mFields, Output, pid::DeviceGainReport)) {
        const PidReport gain = PidReport(mFields, Output, pid::DeviceGainReport).setShare(pid::DeviceGain, 1);
        if (auto sent = transport.write(gain.bytes()); !sent)
            return sent;
    }
    const auto effect = loadEffect(transport);
    if (!effect)
        return fail(effect.error());
    mEffect = *effect;
    mIsPlaying = false;
    mUpdated = Time(0);
    mSaid = {};
    mSaid.isConnected = true;
    mLatest.set(mSaid);
    return transport.write(effectReport(0).bytes());
}

bool PidDevice::takeAxis(std::span<const std::uint8_t> report, HidUsage axis, double &value) const
{
    for (const HidField &field : mFields) {
        const auto at = std::find(field.usages.begin(), field.usages.end(), axis);
        if (field.kind != Input || field.isArray || field.reportId != report[0] || at == field.usages.end() ||
            field.most <= field.least)
            continue;
        const double raw = valueIn(report, field, std::uint32_t(at - field.usages.begin()));
        const double half = (double(field.most) - field.least) / 2;
        value = std::clamp((raw - field.least) / half - 1, -1.0, 1.0) * Reach;
        return true;
    }
    return false;
}

void PidDevice::received(std::span<const std::uint8_t> report, Time)
{
    if (report.empty())
        return;
    const bool isNumbered =
        std::any_of(mFields.begin(), mFields.end(), [](const HidField &field) { return field.reportId != 0; });
    std::vector<std::uint8_t> withId;
    if (!isNumbered) {
        withId.push_back(0);
        withId.insert(withId.end(), report.begin(), report.end());
        report = withId;
    }
    // What is cut short would read as a stick that jumps to its end.
    if (report.size() < reportSize(mFields, Input, report[0]))
        return;
    takeAxis(report, AxisX, mSaid.position.x);
    if (double y = 0; takeAxis(report, AxisY, y))
        mSaid.position.y = -y; // away from the user is negative
    if (!takeAxis(report, AxisZ, mSaid.position.z))
        takeAxis(report, Slider, mSaid.position.z);
    std::uint32_t number = 0;
    for (const HidField &field : mFields) {
        if (field.kind != Input || field.isArray || field.isConstant || field.usages.empty() ||
            (field.usages[0] & 0xffff0000) != ButtonPage)
            continue;
        for (std::uint32_t i = 0; i < field.count && number < 32; ++i, ++number)
            if (field.reportId == report[0])
                mSaid.buttons =
                    (mSaid.buttons & ~(1u << number)) | (valueIn(report, field, i) != 0 ? 1u << number : 0u);
    }
    mLatest.set(mSaid);
}

Result<void> PidDevice::serve(HidTransport &transport, Time now)
{
    if (now - mUpdated < UpdateTime)
        return {};
    mUpdated = now;
    Wanted wanted;
    mWanted.read(wanted);
    const double force = std::hypot(wanted.force.x, wanted.force.y);
    const auto operate = [&](HidUsage operation) {
        PidReport report(mFields, Output, pid::EffectOperation);
        report.set(pid::BlockIndex, mEffect).choose(pid::Operation, operation).set(pid::LoopCount, 1);
        return transport.write(report.bytes());
    };
    if (!(force >= LeastForce) || now - wanted.time > LongestSilence) {
        if (!mIsPlaying)
            return {};
        mIsPlaying = false;
        return operate(pid::Stop);
    }
    // 0 is a force towards the user, a quarter turn one to the left (hid-pidff passes on evdev's directions).
    const double turns = std::atan2(-wanted.force.x, -wanted.force.y) / (2 * std::numbers::pi);
    if (auto sent = transport.write(effectReport(turns).bytes()); !sent)
        return sent;
    PidReport magnitude(mFields, Output, pid::SetConstantForce);
    magnitude.set(pid::BlockIndex, mEffect).setShare(pid::Magnitude, force / MaxForce);
    if (auto sent = transport.write(magnitude.bytes()); !sent)
        return sent;
    if (mIsPlaying && now - mStarted < RestartTime)
        return {};
    mIsPlaying = true;
    mStarted = now;
    return operate(pid::Start);
}

void PidDevice::disconnected()
{
    mSaid.isConnected = false;
    mLatest.set(mSaid);
    mIsPlaying = false;
}

void PidDevice::closing(HidTransport &transport)
{
    (void)control(transport, pid::StopAll);
    (void)control(transport, pid::DisableActuators);
}

} // namespace model::haptics
