// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: M. V. Anglada, An Improved Incremental Algorithm for Constructing Restricted Delaunay Triangulations, 1997.
// Differs: a stack instead of recursion; edges that have the polygon on both sides are linked through their twin.
#include "model/terrain/tin/constraints/segment.h"

#include "model/terrain/tin/query/locate.h"

#include <algorithm>
#include <cassert>

namespace model::terrain {

namespace {

/// One edge of a polygon, with the polygon on its left, seen from the triangles that the segment crosses.
struct Side
{
    VertexId from;
    Corner inner; ///< the corner in the crossed triangle whose edge it is
    Corner outer; ///< beyond, with the constrained bit
};

/// Fills the polygon on the left of the base from `sides.back()`'s end to `sides.front().from`.
class PolygonFiller
{
public:
    /// \param end        the last vertex of the polygon, where the sides end and the base begins
    /// \param triangles  taken from the back, one for each that is made
    PolygonFiller(TinWriter &writer, std::vector<Side> sides, VertexId end, std::vector<TriangleId> &triangles)
        : mWriter(writer)
        , mSides(std::move(sides))
        , mEnd(end)
        , mTriangles(triangles)
        , mLeafs(mSides.size(), NoCorner)
    {
        std::vector<std::pair<Corner, std::uint32_t>> inner;
        for (std::uint32_t i = 0; i < mSides.size(); ++i)
            inner.emplace_back(mSides[i].inner, i);
        std::sort(inner.begin(), inner.end());
        mTwins.resize(mSides.size(), None);
        for (std::uint32_t i = 0; i < mSides.size(); ++i) {
            const Corner outer = mSides[i].outer & ~ConstrainedBit;
            const auto twin = std::lower_bound(inner.begin(), inner.end(), std::pair(outer, 0u));
            if (twin != inner.end() && twin->first == outer)
                mTwins[i] = twin->second;
        }
    }

    /// \param base  what lies beyond the base; NoCorner: nothing yet
    /// \returns     the corner whose edge is the base
    Corner fill(Corner base)
    {
        Corner corner = NoCorner;
        std::vector<Span> stack{{0, std::uint32_t(mSides.size()), base}};
        while (!stack.empty()) {
            const Span span = stack.back();
            stack.pop_back();
            if (span.last == span.first + 1) {
                linkSide(span.first, span.base);
                continue;
            }
            const std::uint32_t apex = apexOf(span);
            const TriangleId t = mTriangles.back();
            mTriangles.pop_back();
            // Corner 0 faces the base.
            mWriter.setTriangle(t, vertexAt(apex), vertexAt(span.last), vertexAt(span.first));
            mWriter.setCornerOf(vertexAt(apex), cornerOf(t, 0));
            mWriter.setCornerOf(vertexAt(span.last), cornerOf(t, 1));
            mWriter.setCornerOf(vertexAt(span.first), cornerOf(t, 2));
            if (span.base != NoCorner)
                mWriter.link(cornerOf(t, 0), span.base);
            if (corner == NoCorner)
                corner = cornerOf(t, 0);
            stack.push_back({span.first, apex, cornerOf(t, 1)});
            stack.push_back({apex, span.last, cornerOf(t, 2)});
        }
        return corner;
    }

private:
    /// The part of the polygon from vertex `first` to vertex `last`; its base runs back from `last` to `first`.
    struct Span
    {
        std::uint32_t first, last;
        Corner base;
    };

    VertexId vertexAt(std::uint32_t i) const { return i < mSides.size() ? mSides[i].from : mEnd; }
    Point2 pointAt(std::uint32_t i) const { return mWriter.tin.points[vertexAt(i)]; }

    std::uint32_t apexOf(const Span &span) const
    {
        const Point2 a = pointAt(span.last), b = pointAt(span.first);
        std::uint32_t apex = span.first + 1;
        for (std::uint32_t i = apex + 1; i < span.last; ++i)
            if (vertexAt(i) != vertexAt(apex) && isInsideCircle(a, b, pointAt(apex), pointAt(i)))
                apex = i;
        assert(orientation(a, b, pointAt(apex)) > 0);
        return apex;
    }
    void linkSide(std::uint32_t i, Corner c)
    {
        if (mTwins[i] == None) {
            mWriter.link(c, mSides[i].outer);
            return;
        }
        mLeafs[i] = c;
        if (mLeafs[mTwins[i]] != NoCorner)
            mWriter.link(c, mLeafs[mTwins[i]] | (mSides[i].outer & ConstrainedBit));
    }

    TinWriter &mWriter;
    const std::vector<Side> mSides;
    const VertexId mEnd;
    std::vector<TriangleId> &mTriangles;
    std::vector<std::uint32_t> mTwins; ///< the side that is the same edge from the other side
    std::vector<Corner> mLeafs;        ///< what now has the side, where it has a twin
};

} // namespace

SegmentStep stepTowards(const TinArrays &tin, VertexId a, VertexId b, Obstacles obstacles)
{
    assert(a != b);
    const Point2 from = tin.points[a], to = tin.points[b];
    const Wedge wedge = wedgeTowards(tin, a, to);
    Corner c = wedge.corner;
    if (wedge.isAlongBorder)
        return {SegmentStep::Kind::Edge, tin.vertex(previous(c)), next(c)};
    if (tin.vertex(next(c)) == b || orientation(from, tin.pointAt(next(c)), to) == 0)
        return {SegmentStep::Kind::Edge, tin.vertex(next(c)), previous(c)};
    const Corner start = c;
    for (;;) {
        const Corner o = tin.opposite(c);
        if (tin.isConstrained(c) &&
            (obstacles == Obstacles::Constraints || tin.isVoid(triangleOf(c)) != tin.isVoid(triangleOf(o))))
            return {SegmentStep::Kind::Blocked, None, c};
        const int side = orientation(from, to, tin.pointAt(o));
        if (side == 0)
            return {SegmentStep::Kind::Crossing, tin.vertex(o), start};
        c = side > 0 ? next(o) : previous(o);
    }
}

Corner openSegment(TinWriter &writer, VertexId a, const SegmentStep &step)
{
    assert(step.kind == SegmentStep::Kind::Crossing);
    TinArrays &tin = writer.tin;
    const Point2 from = tin.points[a], to = tin.points[step.end];
    const double level = tin.heights[a];
    std::vector<TriangleId> triangles;
    std::vector<Side> left, right; // the left ones from the end back to a
    const auto sideOf = [&](Corner c) { return Side{tin.vertex(next(c)), c, tin.opposites[slotOf(c)]}; };
    Corner c = step.edge;
    triangles.push_back(triangleOf(c));
    left.push_back(sideOf(next(c)));
    right.push_back(sideOf(previous(c)));
    for (;;) {
        const Corner o = tin.opposite(c);
        triangles.push_back(triangleOf(o));
        if (tin.vertex(o) == step.end) {
            left.push_back(sideOf(previous(o)));
            right.push_back(sideOf(next(o)));
            break;
        }
        const bool isLeft = orientation(from, to, tin.pointAt(o)) > 0;
        if (isLeft)
            left.push_back(sideOf(previous(o)));
        else
            right.push_back(sideOf(next(o)));
        c = isLeft ? next(o) : previous(o);
    }
    std::reverse(left.begin(), left.end());
    const std::vector<TriangleId> all = triangles;
    for (const TriangleId t : all) {
        writer.touchTriangle(t);
        writer.leak.add(-writer.volumeOf(t, level));
        for (std::uint32_t i = 0; i < 3; ++i)
            writer.noteVertex(tin.vertex(cornerOf(t, i)));
    }
    const Corner leftBase = PolygonFiller(writer, std::move(left), a, triangles).fill(NoCorner);
    const Corner base = PolygonFiller(writer, std::move(right), step.end, triangles).fill(leftBase);
    assert(triangles.empty());
    for (const TriangleId t : all)
        writer.leak.add(writer.volumeOf(t, level));
    return base;
}

} // namespace model::terrain
