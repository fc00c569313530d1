// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: docs of the face rule in slider.h. Over-relaxation: D. M. Young, Iterative Methods for Solving Partial
// Difference Equations of Elliptic Type, 1954.
#include "model/terrain/erosion/erosion.h"

#include "model/base/numbertext.h"
#include "model/terrain/erosion/coarsepass.h"
#include "model/terrain/erosion/refine.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace model::terrain {

namespace {

/// What is begun with fewer triangles than this is swept by one thread: a brush is done before a second one has
/// started.
constexpr std::size_t SmallestForThreads = 16384;

} // namespace

Erosion::Erosion(const ErosionSettings &settings, std::span<const Material> materials)
    : mSettings(settings)
    , mMaterials(materials.begin(), materials.end())
{}

Result<Erosion> Erosion::create(const ErosionSettings &settings, std::span<const Material> materials)
{
    if (const auto checked = check(settings); !checked)
        return fail(checked.error());
    for (std::size_t i = 0; i < materials.size(); ++i)
        if (auto checked = check(materials[i]); !checked) {
            checked.error().args[0].insert(0, "materials[" + std::to_string(i) + "].");
            return fail(std::move(checked.error()));
        }
    return Erosion(settings, materials);
}

Result<void> Erosion::checkLayers(const Tin &tin) const
{
    const LayerTable &layers = tin.arrays().totals.layers;
    for (std::uint32_t l = 0; l < layers.count; ++l)
        if (layers.materials[l] >= mMaterials.size())
            return fail(ErrorCode::BadValue, "material of layer " + std::to_string(l),
                        std::to_string(layers.materials[l]), "below " + std::to_string(mMaterials.size()));
    return {};
}

void Erosion::activate(std::span<const TriangleId> triangles)
{
    for (const TriangleId t : triangles)
        mActive.push_back({t, false});
}

void Erosion::activateAll(const Tin &tin)
{
    mActive.clear();
    for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t)
        if (tin.arrays().isTriangle(t))
            mActive.push_back({t, false});
}

void Erosion::activate(const Tin &tin, const Edit &edit)
{
    const TinArrays &arrays = tin.arrays();
    for (const SlotRange range : edit.dirtyRanges(TinPart::Triangles))
        for (TriangleId t = range.first; t < range.first + range.count; ++t)
            if (arrays.isTriangle(t))
                mActive.push_back({t, false});
    for (const TinPart part : {TinPart::Heights, TinPart::Layers})
        for (const SlotRange range : edit.dirtyRanges(part))
            for (VertexId v = range.first; v < range.first + range.count; ++v)
                if (arrays.isVertex(v))
                    forEachCornerAround(arrays, v, [&](Corner c) { mActive.push_back({triangleOf(c), false}); });
}

/// Sweeps from what is active until it rests or it is enough, and leaves on the list what still slides. Where sliding
/// comes to long edges, they are split before it goes on.
void Erosion::slide(TinEdit &edit, std::vector<Active> start, const Manner &manner, const Progress &progress,
                    ErosionStatistics &statistics)
{
    const Tin &tin = edit.tin();
    const TinArrays &arrays = tin.arrays();
    const SlopeTable slopes(arrays.totals.layers, mMaterials, mSettings.material);
    std::vector<TriangleId> tooLong;
    if (manner.longestEdge > 0)
        for (const Active &active : start)
            tooLong.push_back(active.triangle);
    for (bool isDone = false; !isDone;) {
        if (!tooLong.empty())
            for (const TriangleId t :
                 splitLongEdges(edit, tooLong, manner.longestEdge, LargestAddition, statistics.addedVertices, progress))
                start.push_back({t, false});
        tooLong.clear();
        Patch patch(tin, slopes, mSettings.material, mIds);
        if (statistics.addedVertices < LargestAddition)
            patch.watchForLongEdges(manner.longestEdge);
        for (const Active &active : start) {
            if (progress.isCancelled())
                return;
            if (arrays.isTriangle(active.triangle))
                patch.add(active.triangle, active.isMoving);
        }
        const bool isSmall = manner.isBrief && patch.triangleCount() < SmallestForThreads;
        const auto lead = [&](Team &team) {
            while (!isDone && tooLong.empty()) {
                if (patch.isAtRest() || progress.isCancelled()) {
                    isDone = true;
                    break;
                }
                const SweepCount count = patch.sweep(team, manner.rule, progress);
                ++statistics.sweeps;
                statistics.visits += count.visits;
                statistics.transfers += count.transfers;
                isDone = manner.isEnough(count);
                tooLong.assign(patch.longTriangles().begin(), patch.longTriangles().end());
            }
        };
        Team::run(lead, isSmall ? 1 : threadCount());
        if (progress.isCancelled())
            return;
        statistics.movedVolume += patch.writeBack(edit);
        if (mSettings.flatError > 0)
            mReached.insert(mReached.end(), patch.ids().begin(), patch.ids().end());
        start.clear();
        for (const auto &[triangle, isMoving] : patch.slidingTriangles(manner.rule))
            start.push_back({triangle, isMoving});
    }
    mActive = std::move(start);
}

Result<ErosionStatistics> Erosion::run(TinEdit &edit, double seconds, const ErosionBudget &budget)
{
    if (!(seconds >= 0))
        return fail(ErrorCode::BadSetting, "seconds", numberText(seconds), "at least 0");
    if (const auto checked = checkLayers(edit.tin()); !checked)
        return fail(checked.error());
    const auto began = std::chrono::steady_clock::now();
    ErosionStatistics statistics;
    // More time than a sweep a microsecond could use up is as good as for ever.
    mTimeLeft += std::min(seconds * mSettings.sweepsPerSecond, 1e12);
    const SweepRule rule{mSettings.rule, mSettings.relaxation, mSettings.startAngle, RestTolerance / 2};
    const Manner manner{
        rule, mSettings.longestEdge, true, [&](const SweepCount &) {
            const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - began;
            mTimeLeft -= 1;
            return mTimeLeft < 1 || statistics.transfers >= budget.transfers || took.count() >= budget.milliseconds;
        }};
    if (!mActive.empty() && mTimeLeft >= 1)
        slide(edit, std::move(mActive), manner, Progress(), statistics);
    // Time that was not to be had is not caught up with.
    mTimeLeft = std::fmod(mTimeLeft, 1.0);
    statistics.isAtRest = mActive.empty();
    if (statistics.isAtRest)
        simplify(edit, Progress(), statistics);
    return statistics;
}

/// All that are steeper than some material stands.
std::vector<Erosion::Active> Erosion::steepTriangles(const Tin &tin, const Progress &progress) const
{
    const TinArrays &arrays = tin.arrays();
    const double lowest = SlopeTable(arrays.totals.layers, mMaterials, mSettings.material).lowest();
    std::vector<Active> steep;
    for (TriangleId t = 0; t < arrays.triangleSlots(); ++t) {
        if (progress.isCancelled())
            break;
        if (!arrays.isTriangle(t) || arrays.isVoid(t))
            continue;
        const Gradient g = gradientOf(arrays, t);
        if (g.x * g.x + g.y * g.y > lowest * lowest)
            steep.push_back({t, false});
    }
    return steep;
}

/// The coarse pass over all ground that material from steep ground may reach.
void Erosion::slideCoarsely(TinEdit &edit, std::span<const Active> steep, const Progress &progress,
                            ErosionStatistics &statistics)
{
    const Tin &tin = edit.tin();
    const TinArrays &arrays = tin.arrays();
    const SlopeTable slopes(arrays.totals.layers, mMaterials, mSettings.material);
    Patch patch(tin, slopes, mSettings.material, mIds);
    for (const Active &active : steep)
        patch.add(active.triangle);
    const double slope = patch.uniformSlope();
    if (!(slope > 0))
        return;
    // What is above the lowest of it makes a heap of that radius around the steep ground, at most.
    Rectangle bounds{tin.domain().high, tin.domain().low};
    double bottom = std::numeric_limits<double>::infinity();
    for (const PatchVertex &v : patch.vertices()) {
        bounds.low = {std::min(bounds.low.x, v.x), std::min(bounds.low.y, v.y)};
        bounds.high = {std::max(bounds.high.x, v.x), std::max(bounds.high.y, v.y)};
        bottom = std::min(bottom, v.z);
    }
    CompensatedSum volume;
    for (VertexId v = 0; v < arrays.vertexSlots(); ++v)
        if (bounds.contains(arrays.points[v]))
            volume.add(dualArea(arrays, v) * std::max(0.0, arrays.heights[v] - bottom));
    const double reach = std::cbrt(3 * volume.value() / (M_PI * slope));
    const Rectangle around{{bounds.low.x - reach, bounds.low.y - reach},
                           {bounds.high.x + reach, bounds.high.y + reach}};
    for (TriangleId t = 0; t < arrays.triangleSlots(); ++t) {
        if (progress.isCancelled())
            return;
        if (!arrays.isTriangle(t) || !around.contains(arrays.pointAt(cornerOf(t, 0))))
            continue;
        if (arrays.isVoid(t))
            return; // the grid does not know what lies between its nodes
        patch.add(t);
    }
    SweepCount count;
    Team::run([&](Team &team) {
        coarsePass(patch.vertices(), patch.floors(), patch.uniformSlope(), reach, team, progress, count);
    });
    statistics.visits += count.visits;
    statistics.transfers += count.transfers;
    if (!progress.isCancelled())
        statistics.movedVolume += patch.writeBack(edit);
}

void Erosion::simplify(TinEdit &edit, const Progress &progress, ErosionStatistics &statistics)
{
    if (!(mSettings.flatError > 0) || mReached.empty())
        return;
    std::sort(mReached.begin(), mReached.end());
    mReached.erase(std::unique(mReached.begin(), mReached.end()), mReached.end());
    statistics.removedVertices += removeRedundant(edit, mReached, mSettings.flatError, mSettings.flatAngle, progress);
    mReached.clear();
}

Result<ErosionStatistics> Erosion::settle(TinEdit &edit, const Progress &progress)
{
    const Tin &tin = edit.tin();
    if (const auto checked = checkLayers(tin); !checked)
        return fail(checked.error());
    ErosionStatistics statistics;
    std::uint64_t most = 1;
    if (mSettings.hasCoarsePass && mSettings.rule == ErosionRule::Face)
        if (const std::vector<Active> steep = steepTriangles(tin, progress); !steep.empty())
            slideCoarsely(edit, steep, progress, statistics);
    // Again until nothing moves: vertices that were removed left other triangles.
    Manner manner{{mSettings.rule, mSettings.relaxation, RestTolerance, RestTolerance / 2},
                  mSettings.longestEdge,
                  false,
                  [&](const SweepCount &count) {
                      most = std::max(most, count.transfers);
                      progress.report(1 - double(count.transfers) / double(most));
                      return false;
                  }};
    for (bool isFirst = true, hasMoved = true; hasMoved && !progress.isCancelled(); isFirst = false) {
        const std::uint64_t before = statistics.transfers;
        slide(edit, steepTriangles(tin, progress), manner, progress, statistics);
        manner.longestEdge = 0;
        hasMoved = statistics.transfers != before;
        if (isFirst && !progress.isCancelled())
            simplify(edit, progress, statistics);
        mReached.clear();
    }
    mActive.clear();
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    statistics.isAtRest = true;
    return statistics;
}

} // namespace model::terrain
