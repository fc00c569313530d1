// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sculpt/tooloutline.h"

#include "views/sculpt/toolvalues.h"

#include <algorithm>
#include <cmath>

namespace views {

using namespace model::terrain;

namespace {

constexpr int CircleCorners = 64;
/// The second outline is never smaller than this part of the first.
constexpr double SmallestInner = 0.2;
constexpr double MarkPixels = 6;

QColor colorOf(const Tool &tool)
{
    if (std::holds_alternative<Lower>(tool) || std::holds_alternative<Scoop>(tool))
        return QColor(0xff, 0xb0, 0x5c);
    if (std::holds_alternative<Smooth>(tool) || std::holds_alternative<Restore>(tool))
        return QColor(0x8c, 0xd0, 0xff);
    return Qt::white;
}

GroundLine circle(Point2 centre, double radius, QColor color)
{
    GroundLine line;
    for (int i = 0; i < CircleCorners; ++i) {
        const double angle = 2 * M_PI * i / CircleCorners;
        line.points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    line.isClosed = true;
    line.color = color;
    return line;
}

GroundLine polygon(const Imprint &tool, Point2 centre, double scale, QColor color)
{
    GroundLine line;
    const double angle = tool.rotation * M_PI / 180, c = scale * std::cos(angle), s = scale * std::sin(angle);
    for (const Point2 p : tool.outline.points())
        line.points.push_back({centre.x + c * p.x - s * p.y, centre.y + s * p.x + c * p.y});
    line.isClosed = true;
    line.color = color;
    return line;
}

GroundLine dashed(GroundLine line)
{
    line.isDashed = true;
    line.width = 1;
    line.color.setAlphaF(0.7f);
    return line;
}

} // namespace

std::vector<GroundLine> outlineOf(const Tool &tool, Point2 at, double metresPerPixel)
{
    const QColor color = colorOf(tool);
    const double radius = radiusOf(tool);
    if (!(radius > 0))
        return {circle(at, MarkPixels * metresPerPixel, color)};
    const double inner = amountKindOf(tool) == AmountKind::Metres
                             ? std::clamp(radius - std::abs(amountOf(tool)), SmallestInner * radius, radius)
                             : radius / 2;
    if (const auto *imprint = std::get_if<Imprint>(&tool))
        return {polygon(*imprint, at, radius, color), dashed(polygon(*imprint, at, inner, color))};
    return {circle(at, radius, color), dashed(circle(at, inner, color))};
}

GroundLine pathOf(const Tool &tool, std::span<const PathPoint> path)
{
    GroundLine line;
    line.width = 2;
    if (path.empty())
        return line;
    if (std::holds_alternative<Ramp>(tool)) {
        line.points = {path.front().at, path.back().at};
        return line;
    }
    for (const PathPoint &p : path)
        line.points.push_back(p.at);
    return line;
}

} // namespace views
