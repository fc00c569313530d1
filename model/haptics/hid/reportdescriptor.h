// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"

#include <cstdint>
#include <span>
#include <vector>

namespace model::haptics {

/// A usage page and a usage in it: 0x000f0073 is the 0x73 of page 0x0f.
using HidUsage = std::uint32_t;

/// One or several values side by side in a report.
struct HidField
{
    enum class Kind : std::uint8_t { Input, Output, Feature };

    Kind kind = Kind::Input;
    std::uint8_t reportId = 0;   ///< 0: the device numbers no reports
    bool isArray = false;        ///< values are indices into `usages` (from `least` on), not one value for each of them
    bool isConstant = false;     ///< padding
    std::uint32_t bitOffset = 0; ///< of the first value, the report's id not counted
    std::uint32_t bitSize = 0;   ///< of each value, 1 ... 32
    std::uint32_t count = 0;
    std::int32_t least = 0, most = 0; ///< logical
    std::vector<HidUsage> usages;
    std::vector<HidUsage> collections; ///< around it, from the outermost in

    bool isIn(HidUsage collection) const;
};

/// The fields of a HID report descriptor, in its order. Safe on any bytes: what it allocates is bounded.
/// \error Truncated      an item that runs over the end
/// \error BadValue       collections or pushes that do not match, a size of 0 or above 32 bits
/// \error LimitExceeded  more than 4096 bytes, 1024 fields or usages of one, 32 levels, 64 Ki bits of a report
/// Source: USB Device Class Definition for HID 1.11, 6.2.2.
Result<std::vector<HidField>> parseReportDescriptor(std::span<const std::uint8_t> descriptor);

/// Bytes of a report with its id, if the device has one; 0 if there is no such report.
std::size_t reportSize(std::span<const HidField> fields, HidField::Kind kind, std::uint8_t reportId);

/// Value `index` of `field` in a report that begins with its id byte (0 if there are none). 0 beyond the report's end.
std::int32_t valueIn(std::span<const std::uint8_t> report, const HidField &field, std::uint32_t index = 0);
/// Writes it; nothing beyond the report's end.
void setValueIn(std::span<std::uint8_t> report, const HidField &field, std::int32_t value, std::uint32_t index = 0);

} // namespace model::haptics
