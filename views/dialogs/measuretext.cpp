// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/measuretext.h"

#include "views/dialogs/quantitytext.h"

#include <cmath>

namespace views {

LengthUnit lengthUnitFor(double metres)
{
    const double size = std::abs(metres);
    if (size >= 10000)
        return {1000, "km"};
    return size >= 0.1 || size == 0 ? LengthUnit{1, "m"} : LengthUnit{1e-3, "mm"};
}

QString lengthText(double metres)
{
    const LengthUnit unit = lengthUnitFor(metres);
    return significantText(metres / unit.metres) + QStringLiteral("\u00a0") + QLatin1String(unit.symbol);
}

QString volumeText(double cubicMetres)
{
    const double size = std::abs(cubicMetres);
    const auto in = [&](double unit, const QString &symbol) {
        return significantText(cubicMetres / unit) + QStringLiteral("\u00a0") + symbol;
    };
    if (size >= 1 || size == 0)
        return in(1, QStringLiteral("m³"));
    if (size >= 1e-3)
        return in(1e-3, QStringLiteral("l"));
    return size >= 1e-7 ? in(1e-6, QStringLiteral("cm³")) : in(1e-9, QStringLiteral("mm³"));
}

} // namespace views
