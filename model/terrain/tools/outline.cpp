// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/outline.h"

#include "model/terrain/tin/predicates.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace model::terrain {

namespace {

/// Keeps corners in numbers whose products are far from overflow.
constexpr double LargestOutlineCoordinate = 1e6;

/// Corners sharper than this are cut: they move by this many times the distance of the edges.
constexpr double LongestMiter = 4;

double squaredDistance(Point2 a, Point2 b)
{
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

bool isOnSegment(Point2 a, Point2 b, Point2 p)
{
    return orientation(a, b, p) == 0 && p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) &&
           p.y >= std::min(a.y, b.y) && p.y <= std::max(a.y, b.y);
}

bool doTouch(Point2 a, Point2 b, Point2 c, Point2 d)
{
    if (isOnSegment(a, b, c) || isOnSegment(a, b, d) || isOnSegment(c, d, a) || isOnSegment(c, d, b))
        return true;
    return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
}

/// The unit vector to the left of the edge a-b.
Point2 leftOf(Point2 a, Point2 b)
{
    const double length = std::sqrt(squaredDistance(a, b));
    return {-(b.y - a.y) / length, (b.x - a.x) / length};
}

} // namespace

Outline Outline::disc(std::uint32_t corners)
{
    assert(corners >= 3);
    std::vector<Point2> points;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * i / corners;
        points.push_back({std::cos(angle), std::sin(angle)});
    }
    return Outline(std::move(points));
}

Outline Outline::square()
{
    const double half = M_SQRT1_2;
    return Outline({{-half, -half}, {half, -half}, {half, half}, {-half, half}});
}

Outline Outline::wedge()
{
    return Outline({{-0.6, -0.8}, {1, 0}, {-0.6, 0.8}});
}

Result<Outline> Outline::polygon(std::vector<Point2> points)
{
    const auto refuse = [](const std::string &found, const char *wanted) {
        return fail(ErrorCode::BadSetting, "outline", found, wanted);
    };
    for (const Point2 p : points)
        if (!(std::abs(p.x) <= LargestOutlineCoordinate && std::abs(p.y) <= LargestOutlineCoordinate))
            return refuse("a corner too far away", "coordinates up to 1e6");
    points.erase(std::unique(points.begin(), points.end()), points.end());
    while (points.size() > 1 && points.front() == points.back())
        points.pop_back();
    if (points.size() < 3 || points.size() > LargestOutline)
        return refuse(std::to_string(points.size()) + " corners", "3 ... 512 corners");
    if (!isSimple(points))
        return refuse("crosses itself", "an outline that does not cross or touch itself");
    const double area = doubleAreaOf(points);
    if (!(std::abs(area) > 0))
        return refuse("no area", "an outline with an area");
    if (area < 0)
        std::reverse(points.begin(), points.end());
    return Outline(std::move(points));
}

double Outline::reach() const
{
    double squared = 0;
    for (const Point2 p : mPoints)
        squared = std::max(squared, p.x * p.x + p.y * p.y);
    return std::sqrt(squared);
}

double doubleAreaOf(std::span<const Point2> polygon)
{
    double sum = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += (polygon[i].x - polygon[0].x) * (polygon[i + 1].y - polygon[0].y) -
               (polygon[i].y - polygon[0].y) * (polygon[i + 1].x - polygon[0].x);
    return sum;
}

bool isInside(std::span<const Point2> polygon, Point2 p)
{
    bool isIn = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Point2 a = polygon[i], b = polygon[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            isIn = !isIn;
    }
    return isIn;
}

Point2 nearestOnBorder(std::span<const Point2> polygon, Point2 p)
{
    Point2 nearest = polygon[0];
    double smallest = squaredDistance(p, nearest);
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Point2 a = polygon[j], b = polygon[i];
        const double along = (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
        if (along <= 0)
            continue; // a is nearest, and was looked at as the end of the edge before
        const double whole = squaredDistance(a, b);
        const double t = along < whole ? std::max(0.0, along / whole) : 1;
        const Point2 q{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
        if (const double squared = squaredDistance(p, q); squared < smallest) {
            smallest = squared;
            nearest = q;
        }
    }
    return nearest;
}

std::vector<Point2> insetOf(std::span<const Point2> polygon, double distance)
{
    std::vector<Point2> inset;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2 before = polygon[i == 0 ? polygon.size() - 1 : i - 1], p = polygon[i];
        const Point2 m = leftOf(before, p), n = leftOf(p, polygon[i + 1 == polygon.size() ? 0 : i + 1]);
        // Along m + n by so much that both edges move by the distance.
        const double miter = std::min(LongestMiter * LongestMiter / 2, 1 / std::max(1e-9, 1 + m.x * n.x + m.y * n.y));
        inset.push_back({p.x + distance * miter * (m.x + n.x), p.y + distance * miter * (m.y + n.y)});
    }
    return inset;
}

bool isSimple(std::span<const Point2> polygon)
{
    const std::size_t count = polygon.size();
    const auto at = [&](std::size_t i) { return polygon[i % count]; };
    for (std::size_t i = 0; i < count; ++i) {
        if (at(i) == at(i + 1))
            return false;
        // A neighbour may not fold back over the edge.
        if (isOnSegment(at(i), at(i + 1), at(i + 2)) || isOnSegment(at(i + 1), at(i + 2), at(i)))
            return false;
        for (std::size_t j = i + 2; j < count && j + 1 < i + count; ++j)
            if (doTouch(at(i), at(i + 1), at(j), at(j + 1)))
                return false;
    }
    return true;
}

std::vector<Point2> clippedTo(const Rectangle &domain, std::span<const Point2> polygon)
{
    std::vector<Point2> clipped(polygon.begin(), polygon.end());
    const auto clip = [&](double Point2::*axis, double bound, double sign) {
        std::vector<Point2> kept;
        double Point2::*const other = axis == &Point2::x ? &Point2::y : &Point2::x;
        for (std::size_t i = 0, j = clipped.size() - 1; i < clipped.size(); j = i++) {
            const Point2 a = clipped[j], b = clipped[i];
            const bool isAIn = sign * (a.*axis - bound) >= 0, isBIn = sign * (b.*axis - bound) >= 0;
            if (isAIn != isBIn) {
                Point2 p;
                p.*axis = bound;
                const double t = (bound - a.*axis) / (b.*axis - a.*axis);
                p.*other = a.*other + t * (b.*other - a.*other);
                kept.push_back(p);
            }
            if (isBIn)
                kept.push_back(b);
        }
        clipped = std::move(kept);
    };
    clip(&Point2::x, domain.low.x, 1);
    clip(&Point2::x, domain.high.x, -1);
    clip(&Point2::y, domain.low.y, 1);
    clip(&Point2::y, domain.high.y, -1);
    clipped.erase(std::unique(clipped.begin(), clipped.end()), clipped.end());
    while (clipped.size() > 1 && clipped.front() == clipped.back())
        clipped.pop_back();
    return clipped;
}

} // namespace model::terrain
