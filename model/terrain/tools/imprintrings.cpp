// SPDX-License-Identifier: GPL-3.0-or-later
// The rings of an imprint: edges that follow the ground, what they enclose, what goes from it.
#include "model/terrain/tools/imprintparts.h"

#include <algorithm>
#include <cmath>

namespace model::terrain {

namespace {

// Parts of the radius.
constexpr double SoleTolerance = 1e-3;   ///< vertices that near the sole's height count as at it
constexpr double FollowTolerance = 0.02; ///< an edge of the outline leaves the ground by no more, or is divided

bool isOwned(const TinArrays &tin, Corner c, OwnerId owner)
{
    return tin.isConstrained(c) && findRecord(tin, tin.vertex(next(c)), tin.vertex(previous(c)), owner) != None;
}

/// The next vertex from `v` towards `to` along the edges of `owner`; None if there is none.
VertexId alongEdges(const TinArrays &tin, VertexId v, VertexId before, VertexId to, OwnerId owner)
{
    VertexId best = None;
    double bestCosine = 0;
    const Point2 p = tin.points[v], d{tin.points[to].x - p.x, tin.points[to].y - p.y};
    for (std::uint32_t r = tin.constraints[v]; r != None; r = nextRecord(tin, r, v)) {
        const VertexId other = tin.records[r].a == v ? tin.records[r].b : tin.records[r].a;
        if (tin.records[r].owner != owner || other == before)
            continue;
        if (other == to)
            return to;
        const Point2 e{tin.points[other].x - p.x, tin.points[other].y - p.y};
        const double cosine = (d.x * e.x + d.y * e.y) / std::hypot(e.x, e.y);
        if (cosine > bestCosine) {
            bestCosine = cosine;
            best = other;
        }
    }
    return best;
}

} // namespace

/// The vertex at `p`, or one so near that two would only pile up, or a new one.
VertexId ImprintStroke::putVertex(TinEdit &edit, Point2 p, VertexId near, double nearEnough) const
{
    const TinArrays &tin = edit.tin().arrays();
    const Location location = edit.tin().locate(p, near);
    if (location.kind == Location::Kind::Vertex)
        return tin.vertex(location.corner);
    double smallest = nearEnough * nearEnough;
    VertexId nearest = None;
    const TriangleId t = triangleOf(location.corner);
    for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c)
        if (const double squared = squaredDistance(tin.pointAt(c), p); squared < smallest) {
            smallest = squared;
            nearest = tin.vertex(c);
        }
    return nearest != None ? nearest : edit.insert(p, tin.vertex(cornerOf(t, 0)));
}

/// Adds to `chain` what has to lie between `a` and `b` for the edge to follow the ground.
void ImprintStroke::follow(TinEdit &edit, VertexId a, VertexId b, int halvings, std::vector<VertexId> &chain) const
{
    const TinArrays &tin = edit.tin().arrays();
    if (halvings == 0 || a == b)
        return;
    const Point2 from = tin.points[a], to = tin.points[b];
    const auto at = [&](double t) { return Point2{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)}; };
    double leaves = 0;
    for (const double t : {0.25, 0.5, 0.75}) {
        const double chord = tin.heights[a] + t * (tin.heights[b] - tin.heights[a]);
        leaves = std::max(leaves, std::abs(edit.tin().heightAt(at(t), a) - chord));
    }
    if (leaves <= FollowTolerance * mTool.radius)
        return;
    const VertexId middle = putVertex(edit, at(0.5), a, snap());
    if (middle == a || middle == b)
        return;
    follow(edit, a, middle, halvings - 1, chain);
    chain.push_back(middle);
    follow(edit, middle, b, halvings - 1, chain);
}

ImprintStroke::Ring ImprintStroke::constrain(TinEdit &edit, std::vector<VertexId> corners, OwnerId owner,
                                             Crossing crossing) const
{
    const TinArrays &tin = edit.tin().arrays();
    Ring ring;
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    while (corners.size() > 1 && corners.front() == corners.back())
        corners.pop_back();
    if (corners.size() < 3)
        return ring;
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (!edit.constrain(corners[i], corners[i + 1 == corners.size() ? 0 : i + 1], owner, crossing))
            ring.isClosed = false;
    // Edges may have got vertices of others on them.
    VertexId before = None;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const VertexId to = corners[i + 1 == corners.size() ? 0 : i + 1];
        for (VertexId v = corners[i]; v != to && v != None && ring.vertices.size() <= 64 * corners.size() + 1024;) {
            ring.vertices.push_back(v);
            const VertexId after = alongEdges(tin, v, before, to, owner);
            before = v;
            v = after;
        }
    }
    return ring;
}

/// The triangles and vertices that the ring encloses; the constraints of others on the way go to mOlder.
void ImprintStroke::collectInside(const TinArrays &tin, const Ring &ring, OwnerId owner,
                                  std::span<const Point2> outline, Point2 centre)
{
    mTriangleMarks.resize(tin.triangleSlots());
    mVertexMarks.resize(tin.vertexSlots());
    mTriangles.clear();
    mInside.clear();
    mLookedAt.clear();
    const double reach = mReach * (1 + 1e-6) + snap();
    const auto enter = [&](TriangleId t) {
        if (tin.isVoid(t) || mTriangleMarks.isSet(t))
            return;
        Point2 middle{};
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
            const Point2 p = tin.pointAt(c);
            if (squaredDistance(p, centre) > reach * reach)
                return; // out through a gap in the ring
            middle.x += p.x / 3;
            middle.y += p.y / 3;
        }
        if (!ring.isClosed && !isInside(outline, middle))
            return;
        mTriangleMarks.set(t);
        mTriangles.push_back(t);
    };
    for (std::size_t i = 0; i < ring.vertices.size(); ++i) {
        const VertexId a = ring.vertices[i], b = ring.vertices[i + 1 == ring.vertices.size() ? 0 : i + 1];
        const Corner c = cornerOfEdge(tin, a, b);
        if (c != NoCorner && tin.vertex(next(c)) == a && isOwned(tin, c, owner))
            enter(triangleOf(c));
    }
    for (std::size_t done = 0; done < mTriangles.size(); ++done)
        for (Corner c = cornerOf(mTriangles[done], 0); c <= cornerOf(mTriangles[done], 2); ++c) {
            const VertexId v = tin.vertex(c);
            if (mVertexMarks.set(v)) {
                mLookedAt.push_back(v);
                if (tin.constraints[v] == None || !hasOwner(tin, v, owner))
                    mInside.push_back(v);
            }
            const Corner o = tin.opposite(c);
            const bool isFree = !tin.isConstrained(c);
            if (!isFree) {
                const VertexId a = tin.vertex(next(c)), b = tin.vertex(previous(c));
                bool isOurs = false;
                forEachRecord(tin, a, b, [&](std::uint32_t r) {
                    if (tin.records[r].owner == owner)
                        isOurs = true;
                    else if (tin.records[r].owner != VoidOwner)
                        mOlder.push_back(r);
                });
                if (isOurs || o == NoCorner)
                    continue;
            }
            if (o != NoCorner)
                enter(triangleOf(o));
        }
    for (const TriangleId t : mTriangles)
        mTriangleMarks.clear(t);
    for (const VertexId v : mLookedAt)
        mVertexMarks.clear(v);
}

void ImprintStroke::releaseOlder(TinEdit &edit)
{
    const TinArrays &tin = edit.tin().arrays();
    std::sort(mOlder.begin(), mOlder.end());
    mOlder.erase(std::unique(mOlder.begin(), mOlder.end()), mOlder.end());
    for (const std::uint32_t r : mOlder)
        edit.release(tin.records[r].a, tin.records[r].b, tin.records[r].owner);
    mOlder.clear();
}

/// Forces what was collected inside the sole down to it, and takes away what is then superfluous.
void ImprintStroke::clearSole(TinEdit &edit, const Ring &ring, std::span<const VertexId> inside, double sole)
{
    const TinArrays &tin = edit.tin().arrays();
    const double deep = sole - SoleTolerance * mTool.radius;
    const bool hasDeep = std::any_of(inside.begin(), inside.end(), [&](VertexId v) { return tin.heights[v] < deep; });
    if (!hasDeep && ring.isClosed && edit.removeInside(ring.vertices))
        return;
    for (const VertexId v : inside) {
        bool isNeeded = tin.heights[v] < deep || !edit.canRemove(v);
        if (!isNeeded && hasDeep)
            forEachCornerAround(tin, v,
                                [&](Corner c) { isNeeded = isNeeded || tin.heights[tin.vertex(next(c))] < deep; });
        // A vertex that goes need not be lowered first: its volume is the same either way.
        if (!isNeeded)
            edit.remove(v);
        else if (tin.heights[v] > sole)
            edit.displace(v, sole);
    }
}

/// Edges of the rings beside which the ground is as deep as the sole keep up no wall; their vertices are superfluous.
void ImprintStroke::dropFlatEdges(TinEdit &edit, const Ring &outer, const Ring &inner, double sole, OwnerId owner)
{
    const TinArrays &tin = edit.tin().arrays();
    const double high = sole + SoleTolerance * mTool.radius, deep = sole - SoleTolerance * mTool.radius;
    mFlat.clear();
    const auto each = [&](const Ring &ring, auto isFlat) {
        for (std::size_t i = 0; i < ring.vertices.size(); ++i) {
            const VertexId a = ring.vertices[i], b = ring.vertices[i + 1 == ring.vertices.size() ? 0 : i + 1];
            if (a != b && isFlat(a, b))
                mFlat.emplace_back(a, b);
        }
    };
    each(outer, [&](VertexId a, VertexId b) { return tin.heights[a] <= high && tin.heights[b] <= high; });
    if (mFlat.empty())
        return;
    each(inner, [&](VertexId a, VertexId b) {
        const Corner c = cornerOfEdge(tin, b, a);
        return c == NoCorner || tin.vertex(next(c)) != b || tin.heights[tin.vertex(c)] <= high;
    });
    for (const auto &[a, b] : mFlat)
        edit.release(a, b, owner);
    for (const auto &[a, b] : mFlat)
        for (const VertexId v : {a, b}) {
            if (!tin.isVertex(v) || tin.heights[v] > high || tin.heights[v] < deep || !edit.canRemove(v))
                continue;
            bool isNeeded = false;
            forEachCornerAround(tin, v, [&](Corner c) {
                isNeeded = isNeeded || std::abs(tin.heights[tin.vertex(next(c))] - sole) > high - sole;
            });
            if (!isNeeded)
                edit.remove(v);
        }
}

} // namespace model::terrain
