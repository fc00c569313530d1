// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: V. Purchart, master's thesis on sand, 2009, 3.4: tools as two rings of constrained edges.
// Differs: the rim holds exactly what was dug out, edges of older stamps are released, and edges without a wall go.
#include "model/terrain/tools/imprint.h"

#include "model/terrain/tin/constraintlists.h"

#include <algorithm>
#include <cmath>

namespace model::terrain {

namespace {

// Parts of the radius.
constexpr double SoleTolerance = 1e-3;   ///< vertices that near the sole's height count as at it
constexpr double FollowTolerance = 0.02; ///< an edge of the outline leaves the ground by no more, or is divided
constexpr int MostHalvings = 3;          ///< of an edge of the outline
constexpr double SnapInGaps = 0.25;      ///< vertices nearer than this many gaps are used instead of new ones
constexpr double NarrowestRim = 0.15, WidestRim = 1;
constexpr double RimSnap = 0.3;  ///< the same for the rim's vertices, in its widths
constexpr double RimPitch = 0.6; ///< between the rim's vertices along the outline, at most

/// Less of the material than this is not worth pushing backwards.
constexpr double LeastAhead = 0.03;

constexpr int MostGapHalvings = 8;

double squaredDistance(Point2 a, Point2 b)
{
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

bool isOwned(const TinArrays &tin, Corner c, OwnerId owner)
{
    return tin.isConstrained(c) && findRecord(tin, tin.vertex(next(c)), tin.vertex(previous(c)), owner) != None;
}

bool hasOwner(const TinArrays &tin, VertexId v, OwnerId owner)
{
    for (std::uint32_t r = tin.constraints[v]; r != None; r = nextRecord(tin, r, v))
        if (tin.records[r].owner == owner)
            return true;
    return false;
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

Result<ImprintStroke> ImprintStroke::prepare(const Imprint &tool)
{
    if (!(tool.radius > 0))
        return fail(ErrorCode::BadSetting, "radius", std::to_string(tool.radius), "above 0");
    for (const Result<void> &checked :
         {checkSetting("radius", tool.radius, 0, LargestSetting), checkSetting("depth", tool.depth, 0, LargestSetting),
          checkSetting("level", tool.level.value_or(0), -LargestSetting, LargestSetting),
          checkSetting("gap", tool.gap, 1e-3, 0.5), checkSetting("spacing", tool.spacing, 0.01, 100),
          checkSetting("rotation", tool.rotation, -360000, 360000),
          checkSetting("critical angle", tool.rim.criticalAngle, 1, 89),
          checkSetting("compressibility", tool.rim.compressibility, 0, 1),
          checkSetting("crest", tool.rim.crest, 0.05, 0.95),
          checkSetting("directed speed", tool.rim.directedSpeed, 1e-9, LargestSetting), tool.mask.check()})
        if (!checked)
            return fail(checked.error());
    // Where the tool is narrower than two gaps, a narrower gap.
    const std::span<const Point2> outline = tool.outline.points();
    double gap = tool.gap;
    for (int i = 0; i < MostGapHalvings; ++i, gap /= 2) {
        std::vector<Point2> sole = insetOf(outline, gap);
        const bool isWithin = std::all_of(sole.begin(), sole.end(), [&](Point2 p) { return isInside(outline, p); });
        if (isWithin && isSimple(sole) && doubleAreaOf(sole) > 0) {
            Imprint fitted = tool;
            fitted.gap = gap;
            return ImprintStroke(fitted, std::move(sole));
        }
    }
    return fail(ErrorCode::BadSetting, "outline", "too narrow", "an outline wide enough for the gap");
}

double ImprintStroke::soleAt(const Tin &tin, const StampPose &pose) const
{
    if (mTool.level)
        return *mTool.level;
    const Rectangle &domain = tin.domain();
    const Point2 p{std::clamp(pose.at.x, domain.low.x, domain.high.x),
                   std::clamp(pose.at.y, domain.low.y, domain.high.y)};
    return tin.heightAt(p) - mTool.depth * (mTool.doesPressureScaleDepth ? pose.pressure : 1);
}

std::vector<Point2> ImprintStroke::place(std::span<const Point2> outline, const StampPose &pose) const
{
    double angle = mTool.rotation * M_PI / 180;
    if (pose.isMirrored)
        angle = -angle;
    if (mTool.doesFollowDirection && (pose.direction.x != 0 || pose.direction.y != 0))
        angle += std::atan2(pose.direction.y, pose.direction.x);
    const double c = mTool.radius * std::cos(angle), s = mTool.radius * std::sin(angle);
    std::vector<Point2> placed;
    for (const Point2 p : outline) {
        const double y = pose.isMirrored ? -p.y : p.y;
        placed.push_back({pose.at.x + (c * p.x - s * y), pose.at.y + (s * p.x + c * y)});
    }
    if (pose.isMirrored)
        std::reverse(placed.begin(), placed.end());
    return placed;
}

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

double ImprintStroke::snap() const
{
    return SnapInGaps * mTool.gap * mTool.radius;
}

double ImprintStroke::aheadWeight(const StampPose &pose, Point2 outwards) const
{
    const double cosine = pose.direction.x * outwards.x + pose.direction.y * outwards.y;
    if (pose.direction.x == 0 && pose.direction.y == 0)
        return 1;
    const double directed = pose.speed / (pose.speed + mTool.rim.directedSpeed);
    const double weight = std::pow(std::max(0.0, (1 + cosine) / 2), 1 + 3 * directed);
    return weight < LeastAhead ? 0 : weight;
}

bool ImprintStroke::isInEarlierStamp(Point2 p) const
{
    return std::any_of(mNearEarlier.begin(), mNearEarlier.end(), [&](const Placed *placed) {
        return squaredDistance(placed->centre, p) < mReach * mReach && isInside(placed->outline, p);
    });
}

/// Older constraints where a rim is heaped: vertices that stand closer than any that a stamp puts there go.
void ImprintStroke::thinOut(TinEdit &edit, std::span<const VertexId> vertices, OwnerId owner) const
{
    const TinArrays &tin = edit.tin().arrays();
    for (const VertexId v : vertices) {
        if (!tin.isVertex(v) || tin.constraints[v] == None || hasOwner(tin, v, owner) || hasOwner(tin, v, VoidOwner))
            continue;
        bool isCrowded = false;
        forEachCornerAround(tin, v, [&](Corner c) {
            isCrowded = isCrowded || squaredDistance(tin.pointAt(next(c)), tin.points[v]) < snap() * snap();
        });
        if (!isCrowded)
            continue;
        while (tin.constraints[v] != None) {
            const ConstraintRecord record = tin.records[tin.constraints[v]];
            edit.release(record.a, record.b, record.owner);
        }
        if (edit.canRemove(v))
            edit.remove(v);
    }
}

/// Pushes what the surface lost since the stamp began, `dug`, out around the outline.
void ImprintStroke::heap(TinEdit &edit, const StampPose &pose, std::span<const Point2> outline, OwnerId owner,
                         double dug, ToolMemory &memory)
{
    const Tin &tin = edit.tin();
    const TinArrays &arrays = tin.arrays();
    const Rim &rim = mTool.rim;
    const bool isMoving = pose.direction.x != 0 || pose.direction.y != 0;
    double perimeter = 0;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++)
        perimeter += std::sqrt(squaredDistance(outline[i], outline[j]));
    // A heap of triangular cross-section whose outside has the critical angle; half of the outline gets it all if the
    // tool moves.
    const double crossSection = dug * (1 - rim.compressibility) / (isMoving ? perimeter / 2 : perimeter);
    const double width = std::clamp(
        std::sqrt(std::max(0.0, 2 * crossSection / ((1 - rim.crest) * std::tan(rim.criticalAngle * M_PI / 180)))),
        NarrowestRim * mTool.radius, WidestRim * mTool.radius);
    mNearEarlier.clear();
    for (const Placed &placed : mEarlier)
        if (squaredDistance(placed.centre, pose.at) < (2 * mReach + width) * (2 * mReach + width))
            mNearEarlier.push_back(&placed);

    const double reach = mReach * (1 + 1e-6);
    memory.disc.search(tin, pose.at, mReach + width);
    mRim.assign(memory.disc.vertices().begin(), memory.disc.vertices().end());
    mRim.erase(std::remove_if(mRim.begin(), mRim.end(),
                              [&](VertexId v) {
                                  const Point2 p = arrays.points[v];
                                  const bool isNear = squaredDistance(p, pose.at) <= reach * reach;
                                  return hasOwner(arrays, v, owner) || (isNear && isInside(outline, p)) ||
                                         isInEarlierStamp(p);
                              }),
               mRim.end());
    thinOut(edit, mRim, owner);
    mRim.erase(std::remove_if(mRim.begin(), mRim.end(), [&](VertexId v) { return !arrays.isVertex(v); }), mRim.end());

    VertexId near = mRim.empty() ? None : mRim.front();
    const auto put = [&](Point2 from, Point2 outwards, double distance) {
        const Point2 p{from.x + distance * outwards.x, from.y + distance * outwards.y};
        if (!tin.domain().contains(p) || isInside(outline, p) || isInEarlierStamp(p))
            return;
        const double length = std::hypot(outwards.x, outwards.y);
        if (aheadWeight(pose, {outwards.x / length, outwards.y / length}) == 0)
            return;
        const TriangleId t = tin.triangleAt(p, near);
        near = arrays.vertex(cornerOf(t, 0));
        if (arrays.isVoid(t))
            return;
        const std::uint32_t before = tin.vertexCount();
        near = putVertex(edit, p, near, RimSnap * width);
        if (tin.vertexCount() > before)
            mRim.push_back(near);
    };
    const std::vector<Point2> offset = insetOf(outline, -1);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = i + 1 == outline.size() ? 0 : i + 1;
        const Point2 p = outline[i], q = outline[j];
        const double length = std::sqrt(squaredDistance(p, q));
        if (length == 0)
            continue;
        const Point2 corner{offset[i].x - p.x, offset[i].y - p.y}, normal{(q.y - p.y) / length, -(q.x - p.x) / length};
        const auto parts = int(std::clamp(std::ceil(length / (RimPitch * mTool.radius)), 1.0, 64.0));
        for (int k = 0; k < parts; ++k) {
            const double t = double(k) / parts;
            const Point2 from{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
            for (const double distance : {rim.crest * width, width})
                put(from, k == 0 ? corner : normal, distance);
        }
    }

    std::size_t kept = 0;
    mWeights.clear();
    for (const VertexId v : mRim) {
        if (!(arrays.isVertex(v) && isOnGround(arrays, v)))
            continue;
        const Point2 p = arrays.points[v], q = nearestOnBorder(outline, p);
        const double distance = std::sqrt(squaredDistance(p, q)), t = distance / width;
        if (!(distance > 0) || t >= 1)
            continue;
        const double profile = t < rim.crest ? t / rim.crest : (1 - t) / (1 - rim.crest);
        const double weight = profile * aheadWeight(pose, {(p.x - q.x) / distance, (p.y - q.y) / distance});
        if (weight > 0) {
            mRim[kept++] = v;
            mWeights.push_back(weight);
        }
    }
    mRim.resize(kept);
    edit.giveBack(mRim, mWeights);
}

void ImprintStroke::stamp(TinEdit &edit, const StampPose &pose, double sole, OwnerId owner, ToolMemory &memory)
{
    const Tin &tin = edit.tin();
    const TinArrays &arrays = tin.arrays();
    if (mTool.doesPressureScaleDepth && !(pose.pressure > 0))
        return;
    const std::vector<Point2> whole = place(mTool.outline.points(), pose);
    const std::vector<Point2> outline = clippedTo(tin.domain(), whole);
    const std::vector<Point2> soleOutline = clippedTo(tin.domain(), place(mSoleOutline, pose));
    if (outline.size() < 3 || soleOutline.size() < 3 || !(doubleAreaOf(soleOutline) > 0))
        return;
    VertexId near = arrays.vertex(tin.locate(outline.front()).corner);
    const bool isAboveBorder =
        std::all_of(outline.begin(), outline.end(), [&](Point2 p) { return tin.heightAt(p, near) <= sole; });
    if (isAboveBorder) { // then it may still meet a hill in the middle
        memory.disc.search(tin, pose.at, mReach);
        const std::span<const VertexId> under = memory.disc.vertices();
        if (std::all_of(under.begin(), under.end(), [&](VertexId v) { return arrays.heights[v] <= sole; }))
            return;
    }
    const double before = edit.leak();

    std::vector<VertexId> corners;
    for (const Point2 p : outline)
        corners.push_back(near = putVertex(edit, p, near, snap()));
    std::vector<VertexId> chain;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        chain.push_back(corners[i]);
        follow(edit, corners[i], corners[i + 1 == corners.size() ? 0 : i + 1], MostHalvings, chain);
    }
    Ring outer = constrain(edit, std::move(chain), owner, Crossing::Split);
    corners.clear();
    for (const Point2 p : soleOutline)
        corners.push_back(near = putVertex(edit, p, near, snap()));
    Ring inner = constrain(edit, std::move(corners), owner, Crossing::Release);

    collectInside(arrays, inner, owner, soleOutline, pose.at);
    const std::vector<VertexId> inSole = mInside;
    collectInside(arrays, outer, owner, outline, pose.at);
    const std::vector<VertexId> inWall = mInside;
    releaseOlder(edit);
    for (const VertexId v : inner.vertices)
        if (arrays.heights[v] > sole)
            edit.displace(v, sole);
    clearSole(edit, inner, inSole, sole);
    for (const VertexId v : inWall)
        if (arrays.isVertex(v) && edit.canRemove(v))
            edit.remove(v);
    // Where a void stopped an edge, its ends were vertices like any others.
    for (Ring *ring : {&outer, &inner})
        ring->vertices.erase(std::remove_if(ring->vertices.begin(), ring->vertices.end(),
                                            [&](VertexId v) { return !arrays.isVertex(v); }),
                             ring->vertices.end());
    dropFlatEdges(edit, outer, inner, sole, owner);

    const double dug = before - edit.leak();
    mReport.dug += dug;
    ++mReport.stamps;
    if (mTool.rim.compressibility > 0 && dug > 0) {
        edit.bookLeak(-dug * mTool.rim.compressibility);
        mReport.compressed += dug * mTool.rim.compressibility;
    }
    heap(edit, pose, whole, owner, dug, memory);
    const double left = edit.leak() - before;
    if (std::abs(left) > 1e-9 * std::abs(dug)) {
        edit.bookLeak(left);
        mReport.lost -= left;
    } else if (dug > 0) {
        edit.bookMoved(dug * (1 - mTool.rim.compressibility));
    }
    constexpr std::size_t MostEarlier = 256;
    if (mEarlier.size() == MostEarlier)
        mEarlier.erase(mEarlier.begin());
    mEarlier.push_back({pose.at, whole});
}

} // namespace model::terrain
