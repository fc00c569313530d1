// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/query/disc.h"

#include <algorithm>
#include <cassert>

namespace model::terrain {

namespace {

double squaredDistance(Point2 a, Point2 b)
{
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// From `p` to the nearest point of the segment a-b.
double squaredDistance(Point2 p, Point2 a, Point2 b)
{
    const double along = ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / squaredDistance(a, b);
    const double t = std::clamp(along, 0.0, 1.0);
    return squaredDistance(p, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
}

} // namespace

void DiscSearch::search(const Tin &tin, Point2 centre, double radius, VertexId near)
{
    assert(radius >= 0);
    const TinArrays &arrays = tin.arrays();
    mTriangles.clear();
    mVertices.clear();
    mLookedAt.clear();
    mTriangleMarks.resize(arrays.triangleSlots());
    mVertexMarks.resize(arrays.vertexSlots());
    // The part of the disc inside the domain is convex: its triangles hang together by edges that touch it, and the
    // point of the domain nearest to the centre is in it if it is not empty.
    const Rectangle &domain = tin.domain();
    const Point2 start{std::clamp(centre.x, domain.low.x, domain.high.x),
                       std::clamp(centre.y, domain.low.y, domain.high.y)};
    const double squaredRadius = radius * radius;
    if (squaredDistance(start, centre) > squaredRadius)
        return;
    const TriangleId first = tin.triangleAt(start, near);
    mTriangleMarks.set(first);
    mTriangles.push_back(first);
    for (std::size_t done = 0; done < mTriangles.size(); ++done) {
        for (Corner c = cornerOf(mTriangles[done], 0); c <= cornerOf(mTriangles[done], 2); ++c) {
            const VertexId v = arrays.vertex(c);
            if (mVertexMarks.set(v)) {
                mLookedAt.push_back(v);
                if (squaredDistance(arrays.points[v], centre) <= squaredRadius)
                    mVertices.push_back(v);
            }
            const Corner o = arrays.opposite(c);
            if (o == NoCorner || mTriangleMarks.isSet(triangleOf(o)))
                continue;
            const Point2 a = arrays.pointAt(next(c)), b = arrays.pointAt(previous(c));
            if (squaredDistance(a, centre) <= squaredRadius || squaredDistance(centre, a, b) <= squaredRadius) {
                mTriangleMarks.set(triangleOf(o));
                mTriangles.push_back(triangleOf(o));
            }
        }
    }
    for (const TriangleId t : mTriangles)
        mTriangleMarks.clear(t);
    for (const VertexId v : mLookedAt)
        mVertexMarks.clear(v);
}

} // namespace model::terrain
