// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sculpt/tooloutline.h"

#include "views/sculpt/toolvalues.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace views {

using namespace model::terrain;

namespace {

constexpr int CircleCorners = 64;
/// The second outline is never smaller than this part of the first.
constexpr double SmallestInner = 0.2;
constexpr double MarkPixels = 6;
constexpr QColor AxisColor(0x7f, 0xd6, 0xc2, 0xc0);

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

/// How far a coordinate can go by `step` until it leaves a range.
double wayOut(double from, double step, double low, double high)
{
    if (step == 0)
        return std::numeric_limits<double>::infinity();
    return ((step > 0 ? high : low) - from) / step;
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

std::vector<GroundLine> axesOf(const Symmetry &symmetry, const Rectangle &domain)
{
    std::vector<GroundLine> lines;
    const Point2 centre = symmetry.centre;
    if (symmetry.kind == Symmetry::Kind::Off || !domain.contains(centre))
        return lines;
    const auto add = [&](Point2 from, Point2 to) {
        GroundLine line;
        line.points = {from, to};
        line.color = AxisColor;
        line.isDashed = true;
        lines.push_back(std::move(line));
    };
    if (symmetry.kind == Symmetry::Kind::MirrorX || symmetry.kind == Symmetry::Kind::MirrorBoth)
        add({centre.x, domain.low.y}, {centre.x, domain.high.y});
    if (symmetry.kind == Symmetry::Kind::MirrorY || symmetry.kind == Symmetry::Kind::MirrorBoth)
        add({domain.low.x, centre.y}, {domain.high.x, centre.y});
    if (symmetry.kind == Symmetry::Kind::Radial)
        for (std::uint32_t i = 0; i < symmetry.count(); ++i) {
            const double angle = M_PI / 2 + 2 * M_PI * i / symmetry.count();
            const double x = std::cos(angle), y = std::sin(angle);
            // To the border.
            const double along = std::min(wayOut(centre.x, x, domain.low.x, domain.high.x),
                                          wayOut(centre.y, y, domain.low.y, domain.high.y));
            add(centre, {std::clamp(centre.x + along * x, domain.low.x, domain.high.x),
                         std::clamp(centre.y + along * y, domain.low.y, domain.high.y)});
        }
    return lines;
}

} // namespace views
