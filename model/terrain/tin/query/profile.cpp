// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/query/profile.h"

#include "model/terrain/tin/predicates.h"

#include <algorithm>
#include <cmath>

namespace model::terrain {

namespace {

double cross(Point2 a, Point2 b, Point2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// A directed line that meets no vertex: those that lie on it count as on one of its sides, as if it had been moved a
/// little to the other one.
struct Line
{
    Point2 from, to;
    bool isOnLeft; ///< where vertices on the line are taken to be

    bool isLeft(Point2 p) const
    {
        const int side = orientation(from, to, p);
        return side != 0 ? side > 0 : isOnLeft;
    }
    /// The corner whose edge the line leaves the triangle `t` by; NoCorner if it does not pass the triangle.
    Corner exitOf(const TinArrays &tin, TriangleId t) const
    {
        for (std::uint32_t i = 0; i < 3; ++i)
            if (const Corner c = cornerOf(t, i); !isLeft(tin.pointAt(next(c))) && isLeft(tin.pointAt(previous(c))))
                return c;
        return NoCorner;
    }
};

/// The exit of a triangle that holds `from` and that the line passes, before `from` or after it.
Corner startOf(const TinArrays &tin, const Line &line, const Location &at)
{
    Corner found = NoCorner;
    const auto attempt = [&](TriangleId t) {
        if (found == NoCorner)
            found = line.exitOf(tin, t);
    };
    attempt(triangleOf(at.corner));
    if (at.kind == Location::Kind::Edge && tin.opposite(at.corner) != NoCorner)
        attempt(triangleOf(tin.opposite(at.corner)));
    if (at.kind == Location::Kind::Vertex)
        forEachCornerAround(tin, tin.vertex(at.corner), [&](Corner c) { attempt(triangleOf(c)); });
    return found;
}

/// The part of a-b within the domain. Source: Y. Liang, B. Barsky, A New Concept and Method for Line Clipping, 1984.
std::optional<std::pair<Point2, Point2>> clipped(const Rectangle &domain, Point2 a, Point2 b)
{
    double first = 0, last = 1;
    const auto clip = [&](double from, double way, double low, double high) {
        if (way == 0)
            return from >= low && from <= high;
        const double enters = (way > 0 ? low - from : high - from) / way;
        const double leaves = (way > 0 ? high - from : low - from) / way;
        first = std::max(first, enters);
        last = std::min(last, leaves);
        return first < last;
    };
    if (!clip(a.x, b.x - a.x, domain.low.x, domain.high.x) || !clip(a.y, b.y - a.y, domain.low.y, domain.high.y))
        return std::nullopt;
    const auto at = [&](double share) {
        const Point2 p = share <= 0 ? a : share >= 1 ? b : Point2{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
        return Point2{std::clamp(p.x, domain.low.x, domain.high.x), std::clamp(p.y, domain.low.y, domain.high.y)};
    };
    return std::pair(at(first), at(last));
}

} // namespace

std::vector<ProfilePoint> profile(const Tin &surface, Point2 a, Point2 b)
{
    const auto part = clipped(surface.domain(), a, b);
    if (!part || part->first == part->second)
        return {};
    const TinArrays &tin = surface.arrays();
    const auto [from, to] = *part;
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const Point2 ahead{(b.x - a.x) / length, (b.y - a.y) / length};
    const auto distanceOf = [&](Point2 p) { return (p.x - a.x) * ahead.x + (p.y - a.y) * ahead.y; };
    std::vector<ProfilePoint> points{{std::max(0.0, distanceOf(from)), surface.heightAt(from)}};
    const double end = std::min(length, distanceOf(to));

    // Along the border, only a line moved inwards passes any triangle.
    const Location start = surface.locate(from);
    Line line{from, to, true};
    Corner exit = startOf(tin, line, start);
    if (exit == NoCorner) {
        line.isOnLeft = false;
        exit = startOf(tin, line, start);
    }
    while (exit != NoCorner) {
        points.back().isVoidAfter = tin.isVoid(triangleOf(exit));
        const VertexId right = tin.vertex(next(exit)), left = tin.vertex(previous(exit));
        const Point2 r = tin.points[right], l = tin.points[left];
        if (orientation(r, l, to) >= 0)
            break; // the line ends before this edge
        const int rightSide = orientation(from, to, r), leftSide = orientation(from, to, l);
        const double rightArea = rightSide == 0 ? 0 : std::abs(cross(from, to, r));
        const double leftArea = leftSide == 0 ? 0 : std::abs(cross(from, to, l));
        const double sum = rightArea + leftArea;
        const double share = sum > 0 ? rightArea / sum : 0.5; // of the left one
        const Point2 p = leftSide == 0    ? l
                         : rightSide == 0 ? r
                                          : Point2{r.x + share * (l.x - r.x), r.y + share * (l.y - r.y)};
        const double height = leftSide == 0    ? tin.heights[left]
                              : rightSide == 0 ? tin.heights[right]
                                               : tin.heights[right] + share * (tin.heights[left] - tin.heights[right]);
        if (const double distance = distanceOf(p); distance > points.back().distance && distance < end)
            points.push_back({distance, height});
        const Corner entry = tin.opposite(exit);
        exit = entry == NoCorner ? NoCorner : line.exitOf(tin, triangleOf(entry));
    }
    points.push_back({end, surface.heightAt(to)});
    return points;
}

std::optional<double> heightAt(std::span<const ProfilePoint> profile, double distance)
{
    if (profile.empty() || !(distance >= profile.front().distance && distance <= profile.back().distance))
        return std::nullopt;
    const auto after = std::upper_bound(profile.begin(), profile.end(), distance,
                                        [](double d, const ProfilePoint &point) { return d < point.distance; });
    if (after == profile.end())
        return profile.back().height;
    const ProfilePoint &a = *std::prev(after), &b = *after;
    if (a.isVoidAfter)
        return std::nullopt;
    return a.height + (distance - a.distance) / (b.distance - a.distance) * (b.height - a.height);
}

} // namespace model::terrain
