// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace bench {

/// Bits per frame and vertex, KG error in per cent.
using RatePoint = std::pair<double, double>;

struct RateLine
{
    std::string codec;
    std::vector<RatePoint> points;
};

struct RatePanel
{
    std::string title;
    std::vector<RateLine> lines;
};

/// Size against error, both axes logarithmic and the same in every panel, as SVG. A codec has one colour throughout.
std::string ratePlot(const std::vector<RatePanel> &panels);

} // namespace bench
