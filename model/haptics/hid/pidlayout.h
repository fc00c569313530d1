// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/hid/reportdescriptor.h"

namespace model::haptics {

/// Usages of the page Physical Input Device (USB HID PID 1.0) that a constant force takes.
namespace pid {
inline constexpr HidUsage SetEffect = 0xf0021, BlockIndex = 0xf0022, EffectType = 0xf0025, ConstantForce = 0xf0026,
                          Duration = 0xf0050, Gain = 0xf0052, TriggerButton = 0xf0053, DirectionEnable = 0xf0056,
                          Direction = 0xf0057, SetConstantForce = 0xf0073, Magnitude = 0xf0070,
                          EffectOperation = 0xf0077, Operation = 0xf0078, Start = 0xf0079, Stop = 0xf007b,
                          LoopCount = 0xf007c, DeviceGainReport = 0xf007d, DeviceGain = 0xf007e, BlockLoad = 0xf0089,
                          BlockLoadStatus = 0xf008b, BlockLoadSuccess = 0xf008c, BlockLoadFull = 0xf008d,
                          BlockFree = 0xf0090, DeviceControlReport = 0xf0095, DeviceControl = 0xf0096,
                          EnableActuators = 0xf0097, DisableActuators = 0xf0098, StopAll = 0xf0099, Reset = 0xf009a,
                          CreateNewEffect = 0xf00ab;
} // namespace pid

/// A report that one is going to send, filled field by field by usage. Fields that the device does not have are left
/// out, as they may be.
class PidReport
{
public:
    /// Precondition: hasReport().
    PidReport(std::span<const HidField> fields, HidField::Kind kind, HidUsage collection);

    /// A number, within the field's range.
    PidReport &set(HidUsage usage, std::int64_t value);
    /// A share 0 ... 1 (or -1 ... 1) of the field's range: 1 is its largest value, 0 nothing.
    PidReport &setShare(HidUsage usage, double share);
    /// One of the choices in the collection `group`, as an array's index or as a bit, whichever the device has.
    PidReport &choose(HidUsage group, HidUsage choice);
    /// A full turn is the field's range; of its first value.
    PidReport &setAngle(HidUsage group, double turns);

    std::span<const std::uint8_t> bytes() const { return mBytes; }

private:
    template <class Visit>
    void forEachField(Visit visit);

    std::span<const HidField> mFields;
    HidField::Kind mKind;
    HidUsage mCollection;
    std::uint8_t mReportId = 0;
    std::vector<std::uint8_t> mBytes;
};

bool hasReport(std::span<const HidField> fields, HidField::Kind kind, HidUsage collection);
/// The field of `usage` in the report of `collection`; null if there is none.
const HidField *fieldOf(std::span<const HidField> fields, HidField::Kind kind, HidUsage collection, HidUsage usage);
/// Whether a device with these reports can be given a constant force.
bool hasConstantForce(std::span<const HidField> fields);

} // namespace model::haptics
