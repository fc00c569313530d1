// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/groundray.h"

#include "model/terrain/tin/predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace views {

using namespace model::terrain;

namespace {

/// The part of a ray above the domain.
struct Span
{
    double enter = 0, leave = std::numeric_limits<double>::infinity();

    bool clip(double origin, double direction, double low, double high)
    {
        if (direction == 0)
            return origin >= low && origin <= high;
        const double a = (low - origin) / direction, b = (high - origin) / direction;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
        return enter <= leave;
    }
};

Point3 at(const GroundRay &ray, double t)
{
    return {ray.origin.x + t * ray.direction.x, ray.origin.y + t * ray.direction.y, ray.origin.z + t * ray.direction.z};
}

Point2 nearestInside(const Rectangle &domain, double x, double y)
{
    return {std::clamp(x, domain.low.x, domain.high.x), std::clamp(y, domain.low.y, domain.high.y)};
}

/// How far the ray is above the plane of a triangle, as `height + t * fall`.
struct Clearance
{
    double height, fall;
};

Clearance clearanceOf(const TinArrays &tin, TriangleId t, const GroundRay &ray)
{
    const VertexId v = tin.vertex(cornerOf(t, 0));
    const Gradient g = gradientOf(tin, t);
    const Point2 p = tin.points[v];
    return {ray.origin.z - tin.heights[v] - g.x * (ray.origin.x - p.x) - g.y * (ray.origin.y - p.y),
            ray.direction.z - g.x * ray.direction.x - g.y * ray.direction.y};
}

/// Where the line leaves a triangle: the corner opposite to that edge. The edge runs from the line's right to its left.
/// NoCorner: the line does not go on.
Corner exitOf(const TinArrays &tin, TriangleId t, Point2 from, Point2 to)
{
    int sides[3];
    for (std::uint32_t i = 0; i < 3; ++i)
        sides[i] = orientation(from, to, tin.pointAt(cornerOf(t, i))) >= 0 ? 1 : -1;
    for (std::uint32_t i = 0; i < 3; ++i)
        if (sides[(i + 1) % 3] < 0 && sides[(i + 2) % 3] > 0)
            return cornerOf(t, i);
    return NoCorner;
}

/// The ray parameter where the line crosses the edge of a corner.
double crossing(const TinArrays &tin, Corner c, const GroundRay &ray)
{
    const Point2 a = tin.pointAt(next(c)), b = tin.pointAt(previous(c));
    const double ex = b.x - a.x, ey = b.y - a.y;
    const double across = ray.direction.x * ey - ray.direction.y * ex;
    return ((a.x - ray.origin.x) * ey - (a.y - ray.origin.y) * ex) / across;
}

} // namespace

double nearestHeight(const Tin &tin, Point2 p)
{
    return tin.heightAt(nearestInside(tin.domain(), p.x, p.y));
}

std::optional<Point3> hitOf(const Tin &tin, const GroundRay &ray)
{
    const TinArrays &arrays = tin.arrays();
    const Rectangle &domain = tin.domain();
    Span span;
    if (!span.clip(ray.origin.x, ray.direction.x, domain.low.x, domain.high.x) ||
        !span.clip(ray.origin.y, ray.direction.y, domain.low.y, domain.high.y))
        return std::nullopt;
    const auto groundPoint = [&](double t) {
        const Point3 p = at(ray, t);
        const Point2 inside = nearestInside(domain, p.x, p.y);
        return Point3{inside.x, inside.y, tin.heightAt(inside)};
    };
    if (!std::isfinite(span.leave)) { // straight down
        const TriangleId t = tin.triangleAt({ray.origin.x, ray.origin.y});
        const Point3 hit = groundPoint(0);
        return arrays.isVoid(t) || ray.direction.z >= 0 || hit.z > ray.origin.z ? std::nullopt : std::optional(hit);
    }
    const Point3 first = at(ray, span.enter), last = at(ray, span.leave);
    const Point2 from = nearestInside(domain, first.x, first.y), to = nearestInside(domain, last.x, last.y);
    TriangleId t = tin.triangleAt(from);
    double enter = span.enter;
    for (std::uint32_t steps = arrays.triangleSlots(); steps > 0; --steps) {
        const Corner exit = from == to ? NoCorner : exitOf(arrays, t, from, to);
        const double leave = exit == NoCorner ? span.leave : std::clamp(crossing(arrays, exit, ray), enter, span.leave);
        if (!arrays.isVoid(t)) {
            const Clearance c = clearanceOf(arrays, t, ray);
            // The way in may be below by rounding alone; from below there is no hit.
            const double slack = 1e-9 * (std::abs(c.height) + std::abs(c.fall * leave));
            if (c.height + c.fall * enter >= -slack && c.height + c.fall * leave <= 0 && c.fall < 0)
                return groundPoint(std::clamp(-c.height / c.fall, enter, leave));
        }
        if (exit == NoCorner || arrays.opposite(exit) == NoCorner || leave >= span.leave)
            return std::nullopt;
        t = triangleOf(arrays.opposite(exit));
        enter = leave;
    }
    return std::nullopt;
}

std::optional<Point3> hitBeyond(const Tin &tin, const GroundRay &ray)
{
    if (ray.direction.z >= 0)
        return std::nullopt;
    // The level depends on the place, and the place on the level: a few rounds settle it, as borders are gentle beside
    // lines of sight.
    double level = nearestHeight(tin, {ray.origin.x, ray.origin.y});
    Point3 p;
    for (int round = 0; round < 8; ++round) {
        p = at(ray, (level - ray.origin.z) / ray.direction.z);
        const double height = nearestHeight(tin, {p.x, p.y});
        if (height == level)
            break;
        level = height;
    }
    p.z = level;
    if ((level - ray.origin.z) / ray.direction.z < 0)
        return std::nullopt;
    return p;
}

} // namespace views
