// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tinarrays.h"

namespace model::terrain {

/// How the surface rises: metres up for a metre east (x) and north (y).
struct Gradient
{
    double x = 0, y = 0;
};

/// The height of the triangle `t` above `p`. Between those of its vertices for any `p` in it, however thin it is.
double heightIn(const TinArrays &tin, TriangleId t, Point2 p);
/// The same of the edge of `c`, for a point on it: a thin triangle would not say it well.
double heightOn(const TinArrays &tin, Corner c, Point2 p);
/// Of which vertices a point of the surface is the mean, and with which weights. They add up to 1.
struct Weights
{
    VertexId vertices[3] = {None, None, None};
    double weights[3] = {1, 0, 0};
};
Weights weightsIn(const TinArrays &tin, TriangleId t, Point2 p);
Weights weightsOn(const TinArrays &tin, Corner c, Point2 p);
/// Of a triangle, positive.
inline double areaOf(const TinArrays &tin, TriangleId t)
{
    const VertexId *const v = tin.triangleVertices.data() + 3 * std::size_t(t);
    const Point2 a = tin.points[v[0]], b = tin.points[v[1]], c = tin.points[v[2]];
    return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}
/// The dual area of `v`: a third of its triangles, void ones left out, added up in their order.
double dualArea(const TinArrays &tin, VertexId v);
/// Whether any triangle of `v` is no void one.
bool isOnGround(const TinArrays &tin, VertexId v);
Gradient gradientOf(const TinArrays &tin, TriangleId t);
/// The angle between the triangle and the horizontal plane, in radians.
double slopeOf(const TinArrays &tin, TriangleId t);

} // namespace model::terrain
