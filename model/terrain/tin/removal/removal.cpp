// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: O. Devillers, On Deletion in Delaunay Triangulations, 1999.
// Differs: see removal.h. That ears by power are right for constrained triangulations too, whose lifted surface is
// convex along each ray from v up to the edge of the hole, is worked out in README.md.
#include "model/terrain/tin/removal/removal.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <queue>

namespace model::terrain {

namespace {

/// Up to this many ears the best is looked for, above it is kept in a queue.
constexpr std::size_t LargestScan = 24;

constexpr double NoEar = std::numeric_limits<double>::infinity();

/// The polygon that is left of the hole, counter-clockwise, as a ring of nodes.
class Hole
{
public:
    Hole(TinWriter &writer, VertexId v)
        : mWriter(writer)
        , mCentre(writer.tin.points[v])
    {
        const TinArrays &tin = writer.tin;
        mNodes.clear();
        mTriangles.clear();
        const Corner first = tin.firstAround(v);
        Corner c = first, last = first;
        do {
            const VertexId w = tin.vertex(next(c));
            const Corner outer = tin.opposites[slotOf(c)];
            // What the steps below read of it would otherwise be waited for piece by piece.
            prefetch(&tin.points[w]);
            prefetch(&tin.heights[w]);
            prefetch(&tin.corners[w]);
            if (outer != BorderOpposite) {
                prefetch(&tin.opposites[slotOf(outer & ~ConstrainedBit)]);
                prefetch(&tin.triangleVertices[slotOf(outer & ~ConstrainedBit)]);
            }
            mNodes.push_back({w, outer, 0, 0, NoEar, 0, false});
            mTriangles.push_back(triangleOf(c));
            last = c;
            c = tin.counterClockwise(c);
        } while (c != NoCorner && c != first);
        if (c == NoCorner) // the far end of a fan at the border, and the border edge that closes the hole
            mNodes.push_back({tin.vertex(previous(last)), BorderOpposite, 0, 0, NoEar, 0, false});
        const auto count = std::uint32_t(mNodes.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            mNodes[i].before = i == 0 ? count - 1 : i - 1;
            mNodes[i].after = i + 1 == count ? 0 : i + 1;
        }
    }

    const std::vector<TriangleId> &triangles() const { return mTriangles; }

    /// Vertices whose corner lies in the hole get one outside, or, between two edges of the border, wait for the first
    /// triangle that they get. Precondition: the triangles of the hole still have the vertex that goes.
    void moveCornersOut()
    {
        const TinArrays &tin = mWriter.tin;
        for (Node &node : mNodes) {
            const Corner corner = tin.corners[node.vertex];
            const TriangleId t = triangleOf(corner);
            if (std::find(mTriangles.begin(), mTriangles.end(), t) == mTriangles.end())
                continue;
            const Corner before = mNodes[node.before].outer;
            if (node.outer != BorderOpposite)
                mWriter.setCornerOf(node.vertex, previous(node.outer & ~ConstrainedBit));
            else if (before != BorderOpposite)
                mWriter.setCornerOf(node.vertex, next(before & ~ConstrainedBit));
            else
                node.isWithoutCorner = true;
        }
    }

    void fill()
    {
        for (std::uint32_t i = 0; i < mNodes.size(); ++i)
            rate(i);
        std::uint32_t some = 0;
        for (std::size_t left = mNodes.size(); left > 3; --left) {
            const std::uint32_t ear = bestEar(some, left);
            some = mNodes[ear].before;
            cut(ear);
        }
        Node &b = mNodes[some];
        Node &a = mNodes[b.before];
        Node &c = mNodes[b.after];
        const TriangleId t = makeTriangle(a, b, c);
        mWriter.link(cornerOf(t, 2), a.outer);
        mWriter.link(cornerOf(t, 0), b.outer);
        mWriter.link(cornerOf(t, 1), c.outer);
    }
    /// Triangles of the hole that filling it did not use; those that it did are the ones before.
    std::size_t usedTriangles() const { return mUsed; }

private:
    struct Node
    {
        VertexId vertex;
        Corner outer; ///< beyond the edge to the next node, with its constrained bit
        std::uint32_t before, after;
        double power; ///< how high the plane of the ear, lifted, passes over v; NoEar if the node is none
        std::uint32_t version;
        bool isWithoutCorner;
    };
    struct Queued
    {
        double power;
        std::uint32_t node, version;
        bool operator<(const Queued &other) const
        {
            return power != other.power ? power > other.power : node > other.node;
        }
    };

    void rate(std::uint32_t i)
    {
        Node &node = mNodes[i];
        const Point2 a = pointOf(node.before), b = pointOf(i), c = pointOf(node.after);
        node.power = NoEar;
        ++node.version;
        if (orientation(a, b, c) > 0 && orientation(a, c, mCentre) >= 0) {
            const double ax = a.x - mCentre.x, ay = a.y - mCentre.y, bx = b.x - mCentre.x, by = b.y - mCentre.y,
                         cx = c.x - mCentre.x, cy = c.y - mCentre.y;
            const double circle = (ax * ax + ay * ay) * (bx * cy - by * cx) +
                                  (bx * bx + by * by) * (cx * ay - cy * ax) + (cx * cx + cy * cy) * (ax * by - ay * bx);
            const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
            // Rounding may leave no area of a sliver, and its power undefined: it goes last.
            const double power = circle / area;
            node.power = power < std::numeric_limits<double>::max() ? power : std::numeric_limits<double>::max();
            if (mNodes.size() > LargestScan)
                mQueue.push({node.power, i, node.version});
        }
    }
    std::uint32_t bestEar(std::uint32_t some, std::size_t left)
    {
        if (mNodes.size() > LargestScan) {
            while (mQueue.top().version != mNodes[mQueue.top().node].version)
                mQueue.pop();
            const std::uint32_t ear = mQueue.top().node;
            mQueue.pop();
            return ear;
        }
        std::uint32_t best = some;
        for (std::uint32_t i = mNodes[some].after; --left > 0; i = mNodes[i].after)
            if (mNodes[i].power < mNodes[best].power)
                best = i;
        assert(mNodes[best].power != NoEar);
        return best;
    }
    TriangleId makeTriangle(Node &a, Node &b, Node &c)
    {
        const TriangleId t = mTriangles[mUsed++];
        mWriter.setTriangle(t, a.vertex, b.vertex, c.vertex);
        std::uint32_t i = 0;
        for (Node *node : {&a, &b, &c}) {
            if (node->isWithoutCorner)
                mWriter.setCornerOf(node->vertex, cornerOf(t, i));
            node->isWithoutCorner = false;
            ++i;
        }
        return t;
    }
    void cut(std::uint32_t i)
    {
        Node &ear = mNodes[i];
        Node &a = mNodes[ear.before];
        Node &c = mNodes[ear.after];
        const TriangleId t = makeTriangle(a, ear, c);
        mWriter.link(cornerOf(t, 2), a.outer);
        mWriter.link(cornerOf(t, 0), ear.outer);
        a.outer = cornerOf(t, 1);
        mWriter.edges.push_back(cornerOf(t, 1));
        const std::uint32_t before = ear.before, after = ear.after;
        a.after = after;
        c.before = before;
        ++mNodes[i].version;
        rate(before);
        rate(after);
    }
    // Kept from one removal to the next: nothing is allocated.
    static std::vector<Node> &keptNodes()
    {
        static thread_local std::vector<Node> nodes;
        return nodes;
    }
    static std::vector<TriangleId> &keptTriangles()
    {
        static thread_local std::vector<TriangleId> triangles;
        return triangles;
    }
    Point2 pointOf(std::uint32_t node) const { return mWriter.tin.points[mNodes[node].vertex]; }

    TinWriter &mWriter;
    const Point2 mCentre;
    std::vector<Node> &mNodes = keptNodes();
    std::vector<TriangleId> &mTriangles = keptTriangles();
    std::size_t mUsed = 0;
    std::priority_queue<Queued> mQueue;
};

} // namespace

bool canRemoveVertex(const TinArrays &tin, VertexId v)
{
    if (tin.constraints[v] != None)
        return false;
    const Corner first = tin.firstAround(v);
    if (tin.clockwise(first) != NoCorner)
        return true;
    Corner last = first;
    for (Corner c = first; c != NoCorner; c = tin.counterClockwise(c))
        last = c;
    return orientation(tin.pointAt(next(first)), tin.points[v], tin.pointAt(previous(last))) == 0;
}

void removeVertex(TinWriter &writer, VertexId v)
{
    assert(canRemoveVertex(writer.tin, v));
    Hole hole(writer, v);
    const double level = writer.tin.heights[v];
    for (const TriangleId t : hole.triangles()) {
        writer.touchTriangle(t);
        writer.leak.add(-writer.volumeOf(t, level));
        for (std::uint32_t i = 0; i < 3; ++i)
            writer.noteVertex(writer.tin.vertex(cornerOf(t, i)));
    }
    writer.edges.clear();
    hole.moveCornersOut();
    hole.fill();
    for (std::size_t i = 0; i < hole.triangles().size(); ++i) {
        if (i < hole.usedTriangles())
            writer.leak.add(writer.volumeOf(hole.triangles()[i], level));
        else
            writer.freeTriangle(hole.triangles()[i]);
    }
    writer.freeVertex(v);
    writer.restoreDelaunay();
}

} // namespace model::terrain
