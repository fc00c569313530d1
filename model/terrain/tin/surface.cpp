// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/surface.h"

#include <algorithm>
#include <cmath>

namespace model::terrain {

namespace {

/// Twice the signed area of a-b-c.
double cross(Point2 a, Point2 b, Point2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
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
    const VertexId u = tin.vertex(next(c)), w = tin.vertex(previous(c));
    const Point2 a = tin.points[u], b = tin.points[w];
    const bool isFlat = std::abs(b.x - a.x) > std::abs(b.y - a.y);
    const double along = isFlat ? (p.x - a.x) / (b.x - a.x) : (p.y - a.y) / (b.y - a.y);
    return tin.heights[u] + std::clamp(along, 0.0, 1.0) * (tin.heights[w] - tin.heights[u]);
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
