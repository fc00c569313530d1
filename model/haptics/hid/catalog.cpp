// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/hid/catalog.h"

#include "model/haptics/device/simulateddevice.h"
#include "model/haptics/hid/piddevice.h"
#include "model/haptics/hid/spacemouse.h"
#include "model/haptics/servo/periodicthread.h"

#include <algorithm>

namespace model::haptics {

namespace {

constexpr std::uint16_t GenericDesktop = 1, Joystick = 4, GamePad = 5, MultiAxis = 8, SimulationControls = 2;

/// Only what may be one is asked for its descriptor: keyboards and mice are not.
bool mayHaveForce(const HidDeviceInfo &info)
{
    return (info.usagePage == 0 && info.usage == 0) || info.usagePage == SimulationControls ||
           (info.usagePage == GenericDesktop &&
            (info.usage == Joystick || info.usage == GamePad || info.usage == MultiAxis));
}

Result<std::vector<HidField>> fieldsOf(HidSystem &system, const HidDeviceInfo &info)
{
    auto descriptor = system.reportDescriptor(info);
    if (!descriptor)
        return fail(std::move(descriptor).error());
    return parseReportDescriptor(*descriptor);
}

bool hasForce(HidSystem &system, const HidDeviceInfo &info)
{
    const auto fields = fieldsOf(system, info);
    return fields && hasConstantForce(*fields);
}

} // namespace

const char *nameOf(DeviceKind kind)
{
    switch (kind) {
    case DeviceKind::Simulated:
        return "simulated";
    case DeviceKind::SpaceMouse:
        return "spacemouse";
    case DeviceKind::ForceFeedback:
        return "force feedback";
    }
    return "";
}

FoundDevice simulatedDevice()
{
    FoundDevice simulated;
    simulated.id = "simulated";
    simulated.name = "Simulated device";
    return simulated;
}

std::vector<FoundDevice> findDevices(HidSystem &system)
{
    std::vector<FoundDevice> found;
    const auto devices = system.devices();
    for (const HidDeviceInfo &info : devices ? *devices : std::vector<HidDeviceInfo>()) {
        const bool isMouse = isSpaceMouse(info.vendor, info.product, info.usagePage, info.usage);
        if (!isMouse && !(mayHaveForce(info) && hasForce(system, info)))
            continue;
        FoundDevice device;
        device.kind = isMouse ? DeviceKind::SpaceMouse : DeviceKind::ForceFeedback;
        device.id = std::string(isMouse ? "spacemouse:" : "force-feedback:") + info.path;
        device.name = info.productName.empty() ? nameOf(device.kind) : info.productName;
        device.hid = info;
        device.isAllowed = system.hasPermission(info);
        found.push_back(std::move(device));
    }
    std::sort(found.begin(), found.end(), [](const FoundDevice &a, const FoundDevice &b) { return a.id < b.id; });
    // A device with several top-level collections is listed once for each.
    found.erase(std::unique(found.begin(), found.end(),
                            [](const FoundDevice &a, const FoundDevice &b) { return a.id == b.id; }),
                found.end());
    found.insert(found.begin(), simulatedDevice());
    return found;
}

Result<OpenDevice> openDevice(HidSystem &system, const FoundDevice &found)
{
    OpenDevice open;
    const auto linked = [&](auto device) -> Result<OpenDevice> {
        open.link = std::make_unique<HidLink>(system, found.hid, *device);
        open.device = std::move(device);
        if (auto opened = open.link->open(); !opened)
            return fail(std::move(opened).error());
        open.link->start(monotonicNow);
        return std::move(open);
    };
    switch (found.kind) {
    case DeviceKind::Simulated:
        open.device = std::make_unique<SimulatedDevice>();
        return open;
    case DeviceKind::SpaceMouse:
        return linked(std::make_unique<SpaceMouse>(found.hid));
    case DeviceKind::ForceFeedback: {
        auto fields = fieldsOf(system, found.hid);
        if (!fields)
            return fail(std::move(fields).error());
        if (!hasConstantForce(*fields))
            return fail(ErrorCode::UnsupportedFeature, "force feedback");
        return linked(std::make_unique<PidDevice>(found.hid, std::move(*fields)));
    }
    }
    return open;
}

} // namespace model::haptics
