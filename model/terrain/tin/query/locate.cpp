// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/query/locate.h"

#include "model/terrain/tin/predicates.h"

#include <algorithm>
#include <cassert>

namespace model::terrain {

Wedge wedgeTowards(const TinArrays &tin, VertexId q, Point2 p)
{
    const Point2 origin = tin.points[q];
    Corner c = tin.corners[q];
    if (orientation(origin, tin.pointAt(next(c)), p) >= 0) {
        while (orientation(origin, tin.pointAt(previous(c)), p) >= 0) {
            const Corner turned = tin.counterClockwise(c);
            if (turned == NoCorner)
                return {c, true};
            c = turned;
        }
        return {c, false};
    }
    do {
        c = tin.clockwise(c);
        assert(c != NoCorner && "the point lies outside the domain");
    } while (orientation(origin, tin.pointAt(next(c)), p) < 0);
    return {c, false};
}

Location locationIn(const TinArrays &tin, Point2 p, TriangleId t)
{
    Corner zero[3];
    int zeros = 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Corner c = cornerOf(t, i);
        const int side = orientation(tin.pointAt(next(c)), tin.pointAt(previous(c)), p);
        assert(side >= 0);
        if (side == 0)
            zero[zeros++] = c;
    }
    if (zeros == 0)
        return {Location::Kind::Triangle, cornerOf(t, 0)};
    if (zeros == 1) {
        const Corner o = tin.opposite(zero[0]);
        return {Location::Kind::Edge, std::min(zero[0], o)}; // NoCorner is larger than any
    }
    const Corner c = next(zero[0]) == zero[1] ? next(zero[1]) : next(zero[0]);
    return {Location::Kind::Vertex, tin.corners[tin.vertex(c)]};
}

Location locate(const TinArrays &tin, Point2 p, VertexId start)
{
    assert(tin.isVertex(start));
    for (VertexId q = start;;) {
        const Point2 origin = tin.points[q];
        if (origin == p)
            return {Location::Kind::Vertex, tin.corners[q]};
        // Invariant: the line from q to p leaves the triangle of c through its edge, next(c) on the right of the line
        // or on it, previous(c) on the left.
        const Wedge wedge = wedgeTowards(tin, q, p);
        Corner c = wedge.corner;
        if (wedge.isAlongBorder && orientation(tin.pointAt(next(c)), tin.pointAt(previous(c)), p) < 0) {
            q = tin.vertex(previous(c)); // the left end is on the line too: start again from there
            continue;
        }
        while (orientation(tin.pointAt(next(c)), tin.pointAt(previous(c)), p) < 0) {
            const Corner o = tin.opposite(c);
            assert(o != NoCorner && "the point lies outside the domain");
            c = orientation(origin, p, tin.pointAt(o)) > 0 ? next(o) : previous(o);
        }
        return locationIn(tin, p, triangleOf(c));
    }
}

} // namespace model::terrain
