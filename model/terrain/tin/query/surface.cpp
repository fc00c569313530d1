// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/query/surface.h"

#include <algorithm>
#include <cmath>

namespace model::terrain {

namespace {

/// Twice the signed area of a-b-c.
double cross(Point2 a, Point2 b, Point2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// How far along the edge of `c` a point on it lies, 0 ... 1.
double shareOn(const TinArrays &tin, Corner c, Point2 p)
{
    const Point2 a = tin.pointAt(next(c)), b = tin.pointAt(previous(c));
    const bool isFlat = std::abs(b.x - a.x) > std::abs(b.y - a.y);
    return std::clamp(isFlat ? (p.x - a.x) / (b.x - a.x) : (p.y - a.y) / (b.y - a.y), 0.0, 1.0);
}

} // namespace

double heightIn(const TinArrays &tin, TriangleId t, Point2 p)
{
    const VertexId *const v = tin.triangleVertices.data() + 3 * std::size_t(t);
    const Point2 a = tin.points[v[0]], b = tin.points[v[1]], c = tin.points[v[2]];
    const double wa = std::max(0.0, cross(b, c, p)), wb = std::max(0.0, cross(c, a, p)),
                 wc = std::max(0.0, cross(a, b, p));
    const double za = tin.heights[v[0]], zb = tin.heights[v[1]], zc = tin.heights[v[2]];
    const double sum = wa + wb + wc;
    return sum > 0 ? za + (wb * (zb - za) + wc * (zc - za)) / sum : za;
}

double heightOn(const TinArrays &tin, Corner c, Point2 p)
{
    const double from = tin.heights[tin.vertex(next(c))], to = tin.heights[tin.vertex(previous(c))];
    return from + shareOn(tin, c, p) * (to - from);
}

Weights weightsIn(const TinArrays &tin, TriangleId t, Point2 p)
{
    const VertexId *const v = tin.triangleVertices.data() + 3 * std::size_t(t);
    const Point2 a = tin.points[v[0]], b = tin.points[v[1]], c = tin.points[v[2]];
    const double wa = std::max(0.0, cross(b, c, p)), wb = std::max(0.0, cross(c, a, p)),
                 wc = std::max(0.0, cross(a, b, p));
    const double sum = wa + wb + wc;
    if (!(sum > 0))
        return {{v[0], v[1], v[2]}, {1, 0, 0}};
    return {{v[0], v[1], v[2]}, {wa / sum, wb / sum, wc / sum}};
}

Weights weightsOn(const TinArrays &tin, Corner c, Point2 p)
{
    const double share = shareOn(tin, c, p);
    return {{tin.vertex(next(c)), tin.vertex(previous(c)), None}, {1 - share, share, 0}};
}

double dualArea(const TinArrays &tin, VertexId v)
{
    double sum = 0;
    forEachCornerAround(tin, v, [&](Corner c) {
        if (!tin.isVoid(triangleOf(c)))
            sum += areaOf(tin, triangleOf(c));
    });
    return sum / 3;
}

bool isOnGround(const TinArrays &tin, VertexId v)
{
    if (!tin.isVoid(triangleOf(tin.corners[v])))
        return true;
    bool isThere = false;
    forEachCornerAround(tin, v, [&](Corner c) { isThere = isThere || !tin.isVoid(triangleOf(c)); });
    return isThere;
}

Gradient gradientOf(const TinArrays &tin, TriangleId t)
{
    const VertexId *const v = tin.triangleVertices.data() + 3 * std::size_t(t);
    const Point2 a = tin.points[v[0]], b = tin.points[v[1]], c = tin.points[v[2]];
    const double zb = tin.heights[v[1]] - tin.heights[v[0]], zc = tin.heights[v[2]] - tin.heights[v[0]];
    const double doubleArea = cross(a, b, c);
    return {(zb * (c.y - a.y) - zc * (b.y - a.y)) / doubleArea, (zc * (b.x - a.x) - zb * (c.x - a.x)) / doubleArea};
}

double slopeOf(const TinArrays &tin, TriangleId t)
{
    const Gradient gradient = gradientOf(tin, t);
    return std::atan(std::hypot(gradient.x, gradient.y));
}

} // namespace model::terrain
