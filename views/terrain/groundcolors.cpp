// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/groundcolors.h"

#include <algorithm>
#include <cmath>

namespace views {

QRgb colorAt(const GroundColors &colors, const GroundRange &range, double value)
{
    const double place = std::clamp((value - range.low) / (range.high - range.low), 0.0, 1.0) * (colors.size() - 1);
    const std::size_t below = std::min(std::size_t(place), colors.size() - 2);
    const double part = place - double(below);
    const QRgb a = colors[below], b = colors[below + 1];
    const auto mix = [part](int from, int to) { return int(std::lround(from + part * (to - from))); };
    return qRgb(mix(qRed(a), qRed(b)), mix(qGreen(a), qGreen(b)), mix(qBlue(a), qBlue(b)));
}

double roundUp(double length)
{
    if (!(length > 0) || !std::isfinite(length))
        return 1;
    const double power = std::pow(10.0, std::floor(std::log10(length)));
    for (const double step : {1.0, 2.0, 5.0})
        if (power * step >= length * (1 - 1e-9))
            return power * step;
    return 10 * power;
}

} // namespace views
