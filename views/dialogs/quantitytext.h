// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

/// Quantities as people read them, in the interface's language (the default QLocale).
namespace views {

/// At most `decimals` decimals, none of them a trailing zero: "25", "29.97".
QString numberText(double value, int decimals);
/// About four significant digits: "0.001234", "12.35", "1.2 × 10⁻⁹".
QString significantText(double value);
/// "1.172 %", never broken between number and sign.
QString percentText(double percent);
/// "12,345"
QString countText(std::uint64_t count);
/// "4.5 MB"
QString bytesText(std::uint64_t bytes);
/// "0.8 s", "12 s", "3 min 5 s"
QString durationText(double seconds);

} // namespace views
