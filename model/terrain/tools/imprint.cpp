// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: V. Purchart, master's thesis on sand, 2009, 3.4: tools as two rings of constrained edges.
// Differs: the rim holds exactly what was dug out, edges of older stamps are released, and edges without a wall go.
#include "model/terrain/tools/imprintparts.h"

#include <algorithm>
#include <cmath>

namespace model::terrain {

namespace {

constexpr double SnapInGaps = 0.25; ///< vertices nearer than this many gaps are used instead of new ones
constexpr int MostGapHalvings = 8;

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

double ImprintStroke::soleAt(const StampPose &pose, double ground) const
{
    return mTool.level.value_or(ground - mTool.depth * (mTool.doesPressureScaleDepth ? pose.pressure : 1));
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

double ImprintStroke::snap() const
{
    return SnapInGaps * mTool.gap * mTool.radius;
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
    // What comes now is dug. Until here, and from the rings' release on, the ground was only divided anew.
    const double undug = edit.leak();
    for (const VertexId v : inner.vertices)
        if (arrays.heights[v] > sole)
            edit.displace(v, sole);
    clearSole(edit, inner, inSole, sole);
    for (const VertexId v : inWall)
        if (arrays.isVertex(v) && edit.canRemove(v))
            edit.remove(v);
    const double dug = undug - edit.leak();
    // Where a void stopped an edge, its ends were vertices like any others.
    for (Ring *ring : {&outer, &inner})
        ring->vertices.erase(std::remove_if(ring->vertices.begin(), ring->vertices.end(),
                                            [&](VertexId v) { return !arrays.isVertex(v); }),
                             ring->vertices.end());
    dropFlatEdges(edit, outer, inner, sole, owner);

    mReport.dug += dug;
    ++mReport.stamps;
    if (mTool.rim.compressibility > 0 && dug > 0) {
        edit.bookPressed(dug * mTool.rim.compressibility);
        mReport.compressed += dug * mTool.rim.compressibility;
    }
    const double rounding = 1e-9 * std::abs(dug);
    heap(edit, pose, whole, owner, std::max(0.0, dug), before, memory);
    if (const double gained = edit.leak() - before; std::abs(gained) > rounding)
        levelOut(edit, pose, whole, owner, gained, memory);
    const double left = edit.leak() - before;
    if (std::abs(left) > rounding) {
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
