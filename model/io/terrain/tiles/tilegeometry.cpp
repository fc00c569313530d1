// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/tiles/tilegeometry.h"

#include <algorithm>
#include <cmath>

namespace model::io {

std::int64_t predictOnPlane(std::span<const std::int32_t> x, std::span<const std::int32_t> y,
                            std::span<const std::int32_t> done, std::size_t i, const TileContext &context)
{
    constexpr double Farthest = 4;
    const auto [a, b, o] = context;
    if (a == TileContext::NoVertex || b == TileContext::NoVertex || o == TileContext::NoVertex)
        return predictMean(done, i, context);
    // Differences of 31-bit numbers are exact as doubles; the format counts on products and sums being rounded in just
    // this order, and never fused.
    const double bx = double(x[b]) - double(x[a]), by = double(y[b]) - double(y[a]);
    const double ox = double(x[o]) - double(x[a]), oy = double(y[o]) - double(y[a]);
    const double px = double(x[i]) - double(x[a]), py = double(y[i]) - double(y[a]);
    const double area = bx * oy - by * ox;
    const double alongB = (px * oy - py * ox) / area, alongO = (bx * py - by * px) / area;
    if (!(std::abs(alongB) <= Farthest && std::abs(alongO) <= Farthest))
        return predictMean(done, i, context);
    const double height =
        double(done[a]) + (alongB * (double(done[b]) - double(done[a])) + alongO * (double(done[o]) - double(done[a])));
    return std::int64_t(std::nearbyint(height));
}

} // namespace model::io
