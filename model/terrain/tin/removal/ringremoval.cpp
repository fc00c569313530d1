// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: G. H. Meisters, Polygons Have Ears, 1975, for a first filling; flips then make it Delaunay.
#include "model/terrain/tin/removal/ringremoval.h"

#include <algorithm>
#include <cassert>

namespace model::terrain {

namespace {

/// Which triangles and vertices were seen. Kept from one ring to the next: nothing is allocated.
struct Marks
{
    SlotMarks triangles, vertices;

    static Marks &kept()
    {
        static thread_local Marks marks;
        return marks;
    }
};

} // namespace

RingInside::RingInside(const TinArrays &tin, std::span<const VertexId> ring)
{
    const auto count = std::uint32_t(ring.size());
    if (count < 3 || count > LargestRing)
        return;
    std::vector<VertexId> sorted(ring.begin(), ring.end());
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
        return;
    for (std::uint32_t i = 0; i < count; ++i) {
        const VertexId a = ring[i], b = ring[i + 1 == count ? 0 : i + 1];
        const Corner inner = cornerOfEdge(tin, a, b);
        if (inner == NoCorner || tin.vertex(next(inner)) != a || !tin.isConstrained(inner))
            return;
        mTriangles.push_back(triangleOf(inner));
        mSides.push_back({a, tin.opposites[slotOf(inner)], i == 0 ? count - 1 : i - 1, i + 1 == count ? 0 : i + 1});
    }
    Marks &marks = Marks::kept();
    marks.triangles.resize(tin.triangleSlots());
    marks.vertices.resize(tin.vertexSlots());
    for (const VertexId v : ring)
        marks.vertices.set(v);
    const bool canGo = collect(tin);
    for (const TriangleId t : mTriangles)
        marks.triangles.clear(t);
    for (const VertexId v : mVertices)
        marks.vertices.clear(v);
    for (const VertexId v : ring)
        marks.vertices.clear(v);
    if (!canGo)
        mVertices.clear();
}

/// Everything that hangs together with the ring's triangles without crossing a constrained edge: the ring's own sides
/// are constrained, so that is its inside.
bool RingInside::collect(const TinArrays &tin)
{
    Marks &marks = Marks::kept();
    mTriangles.erase(
        std::remove_if(mTriangles.begin(), mTriangles.end(), [&](TriangleId t) { return !marks.triangles.set(t); }),
        mTriangles.end());
    std::size_t sides = 0;
    for (std::size_t done = 0; done < mTriangles.size(); ++done) {
        const TriangleId t = mTriangles[done];
        if (tin.isVoid(t))
            return false;
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
            if (const VertexId v = tin.vertex(c); marks.vertices.set(v)) {
                mVertices.push_back(v);
                if (tin.constraints[v] != None)
                    return false;
            }
            if (tin.isConstrained(c))
                ++sides;
            else if (const TriangleId across = triangleOf(tin.opposite(c)); marks.triangles.set(across))
                mTriangles.push_back(across);
        }
    }
    return sides == mSides.size(); // no constrained edge hangs into the inside, or crosses it
}

void RingInside::remove(TinWriter &writer)
{
    assert(!mVertices.empty());
    const double level = writer.tin.heights[mSides.front().from];
    for (const TriangleId t : mTriangles) {
        writer.touchTriangle(t);
        writer.leak.add(-writer.volumeOf(t, level));
    }
    for (const Side &side : mSides)
        writer.noteVertex(side.from);
    const std::size_t made = mSides.size() - 2;
    assert(mTriangles.size() >= made);
    fill(writer);
    for (std::size_t i = 0; i < mTriangles.size(); ++i) {
        if (i < made)
            writer.leak.add(writer.volumeOf(mTriangles[i], level));
        else
            writer.freeTriangle(mTriangles[i]);
    }
    for (const VertexId v : mVertices)
        writer.freeVertex(v);
    writer.restoreDelaunay();
}

bool RingInside::isEar(const TinArrays &tin, std::uint32_t side) const
{
    const std::uint32_t before = mSides[side].before, after = mSides[side].after;
    const auto pointOf = [&](std::uint32_t s) { return tin.points[mSides[s].from]; };
    const Point2 a = pointOf(before), b = pointOf(side), c = pointOf(after);
    if (orientation(a, b, c) <= 0)
        return false;
    for (std::uint32_t s = mSides[after].after; s != before; s = mSides[s].after) {
        const Point2 p = pointOf(s);
        if (orientation(c, a, p) >= 0 && orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0)
            return false;
    }
    return true;
}

void RingInside::fill(TinWriter &writer)
{
    TinArrays &tin = writer.tin;
    writer.edges.clear();
    std::size_t made = 0;
    const auto makeTriangle = [&](const Side &a, const Side &b, const Side &c) {
        const TriangleId t = mTriangles[made++];
        writer.setTriangle(t, a.from, b.from, c.from);
        std::uint32_t i = 0;
        for (const Side *side : {&a, &b, &c})
            writer.setCornerOf(side->from, cornerOf(t, i++));
        writer.link(cornerOf(t, 2), a.outer);
        writer.link(cornerOf(t, 0), b.outer);
        return t;
    };
    // Around and around, every other vertex where that is an ear: fewer slivers, and flips, than a fan would give.
    std::uint32_t at = 0;
    for (std::size_t left = mSides.size(); left > 3; --left) {
        while (!isEar(tin, at))
            at = mSides[at].after;
        const Side ear = mSides[at];
        Side &a = mSides[ear.before];
        const TriangleId t = makeTriangle(a, ear, mSides[ear.after]);
        a.outer = cornerOf(t, 1);
        a.after = ear.after;
        mSides[ear.after].before = ear.before;
        writer.edges.push_back(cornerOf(t, 1));
        at = mSides[ear.after].after;
    }
    const Side &b = mSides[at];
    const TriangleId t = makeTriangle(mSides[b.before], b, mSides[b.after]);
    writer.link(cornerOf(t, 1), mSides[b.after].outer);
}

} // namespace model::terrain
