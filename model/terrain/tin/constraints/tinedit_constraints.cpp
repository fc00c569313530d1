// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/tinedit.h"

#include "model/terrain/tin/constraints/constraintlists.h"
#include "model/terrain/tin/constraints/segment.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace model::terrain {

namespace {

double cross(Point2 a, Point2 b, Point2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Where a-b crosses u-w, rounded, and within the box of u and w.
Point2 intersection(Point2 a, Point2 b, Point2 u, Point2 w)
{
    const double du = cross(a, b, u), dw = cross(a, b, w);
    const double s = du != dw ? std::clamp(du / (du - dw), 0.0, 1.0) : 0.5;
    return {std::clamp(u.x + s * (w.x - u.x), std::min(u.x, w.x), std::max(u.x, w.x)),
            std::clamp(u.y + s * (w.y - u.y), std::min(u.y, w.y), std::max(u.y, w.y))};
}

/// Pieces of lines that were split are rounded, and may cross others that the line did not. In a bundle of lines that
/// all but coincide that went on for ever, a rounding unit farther each time: after so many generations an edge in the
/// way is released, not split. tst_hostilestrokes presses one tool 1500 times near a spot.
constexpr std::uint32_t MostGenerations = 4;
/// A line that goes on less than this, of its length, before it is split again has not got on: far more than rounding,
/// far less than anybody sees.
constexpr double LeastStep = 1e-9;

bool doesGetOn(Point2 from, Point2 to, Point2 end)
{
    return std::hypot(to.x - from.x, to.y - from.y) > LeastStep * std::hypot(end.x - from.x, end.y - from.y);
}

} // namespace

bool TinEdit::isFreeOf(const Segment &segment, Crossing crossing, Corner &blocking) const
{
    const Obstacles obstacles = crossing == Crossing::Refuse ? Obstacles::Constraints : Obstacles::Voids;
    for (VertexId v = segment.a; v != segment.b;) {
        const SegmentStep step = stepTowards(mArrays, v, segment.b, obstacles);
        if (step.kind == SegmentStep::Kind::Blocked) {
            blocking = step.edge;
            return false;
        }
        v = step.end;
    }
    return true;
}

Result<void> TinEdit::constrain(VertexId a, VertexId b, OwnerId owner, Crossing crossing)
{
    assert(mIsOpen && a != b && owner != None);
    const auto refuse = [&](Corner edge) {
        return fail(ErrorCode::CrossingConstraints, std::to_string(a), std::to_string(b),
                    std::to_string(mArrays.vertex(next(edge))), std::to_string(mArrays.vertex(previous(edge))));
    };
    Corner blocking = NoCorner;
    if (!isFreeOf({a, b, owner}, crossing, blocking))
        return refuse(blocking);
    std::vector<Segment> segments{{a, b, owner}};
    std::vector<std::uint32_t> generations{0}; // of the segments: how often what they are a piece of was split
    const auto push = [&](const Segment &segment, std::uint32_t generation) {
        segments.push_back(segment);
        generations.push_back(generation);
    };
    while (!segments.empty()) {
        const Segment segment = segments.back();
        const std::uint32_t generation = generations.back();
        segments.pop_back();
        generations.pop_back();
        if (segment.a == segment.b)
            continue;
        const SegmentStep step = stepTowards(mArrays, segment.a, segment.b);
        switch (step.kind) {
        case SegmentStep::Kind::Blocked:
            if (crossing == Crossing::Release || generation >= MostGenerations) {
                const VertexId u = mArrays.vertex(next(step.edge)), w = mArrays.vertex(previous(step.edge));
                releaseAll(u, w);
                if (!hasRecord(mArrays, u, w)) // else it bounds a void: a rounded piece that touches one is left out
                    push(segment, generation);
            } else {
                const std::size_t rest = segments.size(); // where the line goes on beyond the edge
                split(step.edge, segments, segment);
                generations.resize(segments.size(), generation + 1);
                if (doesGetOn(mArrays.points[segment.a], mArrays.points[segments[rest].a], mArrays.points[segment.b]))
                    generations[rest] = generation;
            }
            break;
        case SegmentStep::Kind::Edge:
            constrainEdge(step.edge, segment.owner);
            push({step.end, segment.b, segment.owner}, generation);
            break;
        case SegmentStep::Kind::Crossing:
            constrainEdge(openSegment(mWriter, segment.a, step), segment.owner);
            push({step.end, segment.b, segment.owner}, generation);
            break;
        }
    }
    return {};
}

/// Puts a vertex where `segment` crosses the constrained edge of `c`, and leaves the four pieces to be constrained. The
/// vertex is rounded: the pieces of the older edge are not quite on its line, and go through the same steps as any
/// segment.
void TinEdit::split(Corner c, std::vector<Segment> &segments, const Segment &segment)
{
    const VertexId u = mArrays.vertex(next(c)), w = mArrays.vertex(previous(c));
    const std::vector<OwnerId> owners = terrain::ownersOf(mArrays, u, w);
    const Point2 p =
        intersection(mArrays.points[segment.a], mArrays.points[segment.b], mArrays.points[u], mArrays.points[w]);
    const VertexId v = insert(p, u);
    segments.push_back({v, segment.b, segment.owner});
    segments.push_back({segment.a, v, segment.owner});
    const Corner edge = cornerOfEdge(mArrays, u, w);
    if (v == u || v == w || edge == NoCorner)
        return; // it goes through an end of the edge, or has split it exactly
    releaseAll(u, w);
    for (const OwnerId owner : owners) {
        segments.push_back({u, v, owner});
        segments.push_back({v, w, owner});
    }
}

void TinEdit::constrainEdge(Corner c, OwnerId owner)
{
    if (!mArrays.isConstrained(c))
        mWriter.setConstrained(c, true);
    addRecord(mWriter, mArrays.vertex(next(c)), mArrays.vertex(previous(c)), owner);
}

/// Lets the edge of `c` be flipped, unless there is still a reason why not.
void TinEdit::unconstrain(Corner c)
{
    if (mArrays.opposite(c) == NoCorner || hasRecord(mArrays, mArrays.vertex(next(c)), mArrays.vertex(previous(c))))
        return;
    mWriter.setConstrained(c, false);
    mWriter.edges = {c};
    mWriter.restoreDelaunay();
}

void TinEdit::release(VertexId a, VertexId b, OwnerId owner)
{
    assert(mIsOpen && owner != VoidOwner);
    const std::uint32_t r = findRecord(mArrays, a, b, owner);
    if (r == None)
        return;
    removeRecord(mWriter, r);
    unconstrain(cornerOfEdge(mArrays, a, b));
}

void TinEdit::releaseAll(VertexId a, VertexId b)
{
    for (const OwnerId owner : terrain::ownersOf(mArrays, a, b))
        if (owner != VoidOwner)
            release(a, b, owner);
}

void TinEdit::releaseOwner(OwnerId owner)
{
    for (std::uint32_t r = 0; r < mArrays.records.size(); ++r)
        if (mArrays.records[r].a != None && mArrays.records[r].owner == owner)
            release(mArrays.records[r].a, mArrays.records[r].b, owner);
}

void TinEdit::setVoid(std::span<const TriangleId> triangles, bool isVoid)
{
    assert(mIsOpen);
    for (const TriangleId t : triangles) {
        if (mArrays.isVoid(t) == isVoid)
            continue;
        mWriter.touchTriangle(t);
        if (isVoid)
            mWriter.leak.add(-mWriter.volumeOf(t, 0));
        mArrays.triangleFlags[t] ^= VoidTriangle;
        if (!isVoid)
            mWriter.leak.add(mWriter.volumeOf(t, 0));
        for (std::uint32_t i = 0; i < 3; ++i)
            mWriter.noteVertex(mArrays.vertex(cornerOf(t, i)));
    }
    // First all borders of voids, so that no flip goes across one.
    std::vector<Corner> freed;
    for (const TriangleId t : triangles)
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
            const Corner o = mArrays.opposite(c);
            if (o == NoCorner)
                continue;
            const std::uint32_t r =
                findRecord(mArrays, mArrays.vertex(next(c)), mArrays.vertex(previous(c)), VoidOwner);
            const bool isEdge = mArrays.isVoid(triangleOf(o)) != isVoid;
            if (isEdge && r == None) {
                constrainEdge(c, VoidOwner);
            } else if (!isEdge && r != None) {
                removeRecord(mWriter, r);
                freed.push_back(c);
            }
        }
    // Flips renumber corners: what was freed is found by its bit, not by its place.
    for (const Corner c : freed)
        if (!hasRecord(mArrays, mArrays.vertex(next(c)), mArrays.vertex(previous(c))))
            mWriter.setConstrained(c, false);
    mWriter.edges = freed;
    mWriter.restoreDelaunay();
}

} // namespace model::terrain
