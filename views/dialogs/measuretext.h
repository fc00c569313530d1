// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

/// Lengths and volumes as people read them, in units that suit them.
namespace views {

/// Four significant digits in the unit that suits them: "1.5 km", "25 m", "12.5 mm"; "340 l", "12.5 m³", "80 cm³".
QString lengthText(double metres);
QString volumeText(double cubicMetres);
/// The unit for lengths up to `metres`; metres for 0.
struct LengthUnit
{
    double metres; ///< one of it
    const char *symbol;
};
LengthUnit lengthUnitFor(double metres);

} // namespace views
