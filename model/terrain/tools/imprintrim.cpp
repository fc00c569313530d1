// SPDX-License-Identifier: GPL-3.0-or-later
// The rim of an imprint: where what was dug out comes to lie.
#include "model/terrain/material/material.h"
#include "model/terrain/tools/imprintparts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace model::terrain {

namespace {

constexpr double NarrowestRim = 0.15, WidestRim = 1; ///< radii
constexpr double RimSnap = 0.3;  ///< vertices nearer than this many widths of the rim are used instead of new ones
constexpr double RimPitch = 0.6; ///< radii between the rim's vertices along the outline, at most
/// Of the height that a rim of even vertices would have.
constexpr double MostOfRimHeight = 3;
/// Of what was dug: so much less or more in the rim is not seen.
constexpr double SmallPart = 0.1;
/// Of the differences in height around a stamp: no more than that can have come from edges that run otherwise.
constexpr double MostLevelling = 0.5;
/// Less of the material than this is not worth pushing backwards.
constexpr double LeastAhead = 0.03;

} // namespace

Rim rimOf(const Material &material, Rim rim)
{
    rim.criticalAngle = material.outsideSlope;
    rim.compressibility = material.compression;
    return rim;
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

/// Pushes `dug` out around the outline. \param leak  before the stamp: if what the surface owes since then is nearly
/// what was dug, the rim takes all of it
void ImprintStroke::heap(TinEdit &edit, const StampPose &pose, std::span<const Point2> outline, OwnerId owner,
                         double dug, double leak, ToolMemory &memory)
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
    double pushed = dug * (1 - rim.compressibility);
    if (const double owed = leak - edit.leak(); std::abs(owed - pushed) < SmallPart * pushed)
        pushed = owed;
    // Where few and small vertices make the rim they do not take it all: it would be a tower.
    edit.giveBackVolume(mRim, pushed, mWeights, MostOfRimHeight * 2 * crossSection / width);
    mRimWidth = width;
}

/// Spreads `volume`, which the surface gained because edges run otherwise now, over the ground around the stamp, by
/// area: on the rim alone, which may be a ten thousandth of the triangles that an edge divided, it would dig or heap
/// far more than the tool does, and the next stamp yet more.
void ImprintStroke::levelOut(TinEdit &edit, const StampPose &pose, std::span<const Point2> outline, OwnerId owner,
                             double volume, ToolMemory &memory)
{
    const TinArrays &arrays = edit.tin().arrays();
    const double reach = mReach * (1 + 1e-6);
    mVertexMarks.resize(arrays.vertexSlots());
    memory.disc.search(edit.tin(), pose.at, mReach + mRimWidth);
    mRim.clear();
    mLookedAt.clear();
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const TriangleId t : memory.disc.triangles())
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
            const VertexId v = arrays.vertex(c);
            if (!mVertexMarks.set(v))
                continue;
            mLookedAt.push_back(v);
            lowest = std::min(lowest, arrays.heights[v]);
            highest = std::max(highest, arrays.heights[v]);
            const Point2 p = arrays.points[v];
            const bool isNear = squaredDistance(p, pose.at) <= reach * reach;
            if (!isOnGround(arrays, v) || hasOwner(arrays, v, owner) || (isNear && isInside(outline, p)) ||
                isInEarlierStamp(p))
                continue;
            mRim.push_back(v);
        }
    for (const VertexId v : mLookedAt)
        mVertexMarks.clear(v);
    edit.giveBackVolume(mRim, -volume, {}, MostLevelling * std::max(0.0, highest - lowest));
}

} // namespace model::terrain
