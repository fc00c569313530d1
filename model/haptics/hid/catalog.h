// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/device/hapticdevice.h"
#include "model/haptics/hid/hidlink.h"

namespace model::haptics {

enum class DeviceKind : std::uint8_t { Simulated, SpaceMouse, ForceFeedback };

/// "simulated", "spacemouse", "force feedback"
const char *nameOf(DeviceKind kind);

/// A device that one can choose.
struct FoundDevice
{
    std::string id; ///< names it in settings and on the command line: "simulated", or kind and path
    DeviceKind kind = DeviceKind::Simulated;
    std::string name;
    HidDeviceInfo hid;     ///< not of the simulated one
    bool isAllowed = true; ///< false: this user has no right to open it; UdevRuleName says what helps
    friend bool operator==(const FoundDevice &, const FoundDevice &) = default;
};

/// The file that gives the right to who sits at the machine. Installed with the program; to be copied to
/// /etc/udev/rules.d by hand otherwise.
inline constexpr const char *UdevRuleName = "70-sandreel-haptics.rules";

/// The one that is always there.
FoundDevice simulatedDevice();

/// The simulated device, and every device of the system that is of use, in a stable order. A system whose HID library
/// fails has the simulated one alone.
std::vector<FoundDevice> findDevices(HidSystem &system);

/// A device with what keeps it open.
struct OpenDevice
{
    std::unique_ptr<HapticDevice> device;
    std::unique_ptr<HidLink> link; ///< after `device`: it is the first to go. Null for the simulated one
};

/// Opens what findDevices() found, and starts the link's thread on the clock of the servo.
/// \error CannotOpen, UnsupportedFeature, CannotRead, CannotWrite, and those of parseReportDescriptor()
Result<OpenDevice> openDevice(HidSystem &system, const FoundDevice &found);

} // namespace model::haptics
