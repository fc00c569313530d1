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
#include <utility>

namespace model::terrain {

namespace {

/// What is begun with fewer triangles than this is swept by one thread: a brush is done before a second one has
/// started.
constexpr std::size_t SmallestForThreads = 16384;

/// Triangles that have their turn together where the time is short: copied, swept eight times and written back in one
/// or two milliseconds (sandreel-bench-stroke). Fewer would be a larger share of borders, where sliding stops for a
/// while.
constexpr std::size_t LotSize = 4096;
/// In a round of many lots: what copying costs is worth some sweeps, and more would let the lots drift apart.
constexpr double MostSweepsInTurn = 8;
/// Vertices that one lot may add by splitting edges.
constexpr std::uint32_t LargestAdditionInTurn = 256;

bool isSteeper(const TinArrays &tin, TriangleId t, double slope)
{
    const Gradient g = gradientOf(tin, t);
    return g.x * g.x + g.y * g.y > slope * slope;
}

class Clock
{
public:
    double milliseconds() const
    {
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - mBegan;
        return took.count();
    }

private:
    std::chrono::steady_clock::time_point mBegan = std::chrono::steady_clock::now();
};

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
        mActive.add({t, false});
}

void Erosion::activateAll(const Tin &tin)
{
    mActive.clear();
    mRoundLeft = 0;
    for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t)
        if (tin.arrays().isTriangle(t))
            mActive.add({t, false});
}

void Erosion::activate(const Tin &tin, const Edit &edit)
{
    const TinArrays &arrays = tin.arrays();
    for (const SlotRange range : edit.dirtyRanges(TinPart::Triangles))
        for (TriangleId t = range.first; t < range.first + range.count; ++t)
            if (arrays.isTriangle(t))
                mActive.add({t, false});
    for (const TinPart part : {TinPart::Heights, TinPart::Layers})
        for (const SlotRange range : edit.dirtyRanges(part))
            for (VertexId v = range.first; v < range.first + range.count; ++v)
                if (arrays.isVertex(v))
                    forEachCornerAround(arrays, v, [&](Corner c) { mActive.add({triangleOf(c), false}); });
}

const SlopeTable &Erosion::slopesOf(const LayerTable &layers)
{
    if (!mSlopes || !(mSlopesOf == layers)) {
        mSlopes.emplace(layers, mMaterials, mSettings.material);
        mSlopesOf = layers;
    }
    return *mSlopes;
}

/// Sweeps from `start` until it rests or it is enough, and returns what still slides. Where sliding comes to long
/// edges, they are split before it goes on.
std::vector<ActiveTriangle> Erosion::slide(TinEdit &edit, std::vector<ActiveTriangle> start, const Manner &manner,
                                           const Progress &progress, ErosionStatistics &statistics)
{
    const Tin &tin = edit.tin();
    const TinArrays &arrays = tin.arrays();
    const SlopeTable &slopes = slopesOf(arrays.totals.layers);
    const double leastSlope = slopes.lowest();
    const std::uint32_t mostAdded =
        statistics.addedVertices + std::min(manner.mostAdded, LargestAddition - statistics.addedVertices);
    std::vector<TriangleId> tooLong;
    if (manner.longestEdge > 0)
        for (const ActiveTriangle &active : start)
            tooLong.push_back(active.triangle);
    for (bool isDone = false; !isDone;) {
        if (!tooLong.empty())
            for (const TriangleId t :
                 splitLongEdges(edit, tooLong, manner.longestEdge, mostAdded, statistics.addedVertices, progress))
                start.push_back({t, false});
        tooLong.clear();
        Patch patch(tin, slopes, mSettings.material, mIds);
        if (statistics.addedVertices < mostAdded)
            patch.watchForLongEdges(manner.longestEdge);
        for (const ActiveTriangle &active : start) {
            if (progress.isCancelled())
                return {};
            const TriangleId t = active.triangle;
            if (arrays.isTriangle(t) && (active.isMoving || isSteeper(arrays, t, leastSlope)))
                patch.add(t, active.isMoving);
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
            return {};
        statistics.movedVolume += patch.writeBack(edit, progress);
        if (mSettings.flatError > 0)
            noteReached(patch.ids());
        start.clear();
        for (const auto &[triangle, isMoving] : patch.slidingTriangles(manner.rule, progress))
            start.push_back({triangle, isMoving});
    }
    return start;
}

/// All that is on the list at once, each sweep over all of it.
void Erosion::slideAll(TinEdit &edit, const SweepRule &rule, const ErosionBudget &budget, ErosionStatistics &statistics)
{
    const Manner manner{rule, mSettings.longestEdge, true, LargestAddition, [&](const SweepCount &) {
                            mTimeLeft -= 1;
                            return mTimeLeft < 1 || statistics.transfers >= budget.transfers;
                        }};
    mRoundLeft = 0;
    for (const ActiveTriangle active : slide(edit, mActive.take(mActive.size()), manner, Progress(), statistics))
        mActive.add(active);
}

/// Lot by lot from the head of the list, with what still slides going to its end, as long as another lot fits into the
/// time.
void Erosion::slideInTurns(TinEdit &edit, const SweepRule &rule, const ErosionBudget &budget,
                           ErosionStatistics &statistics)
{
    const Clock clock;
    double longest = 0;
    const auto isOver = [&] {
        return statistics.transfers >= budget.transfers || clock.milliseconds() >= budget.milliseconds;
    };
    do {
        mRoundLeft = std::min(mRoundLeft, mActive.size());
        if (mRoundLeft == 0) {
            if (mTimeLeft < 1)
                return;
            mRoundLeft = mActive.size();
            const double most = mRoundLeft > LotSize ? MostSweepsInTurn : mTimeLeft;
            mRoundSweeps = std::floor(std::min(mTimeLeft, most));
            mTimeLeft -= mRoundSweeps;
        }
        const double began = clock.milliseconds();
        const std::size_t count = std::min(mRoundLeft, LotSize);
        mRoundLeft -= count;
        double left = mRoundSweeps;
        const Manner manner{rule, mSettings.longestEdge, true, LargestAdditionInTurn,
                            [&](const SweepCount &) { return --left < 1 || isOver(); }};
        for (const ActiveTriangle active : slide(edit, mActive.take(count), manner, Progress(), statistics))
            mActive.add(active);
        longest = std::max(longest, clock.milliseconds() - began);
    } while (!mActive.isEmpty() && !isOver() && clock.milliseconds() + longest <= budget.milliseconds);
}

Result<ErosionStatistics> Erosion::run(TinEdit &edit, double seconds, const ErosionBudget &budget)
{
    if (!(seconds >= 0))
        return fail(ErrorCode::BadSetting, "seconds", numberText(seconds), "at least 0");
    if (const auto checked = checkLayers(edit.tin()); !checked)
        return fail(checked.error());
    ErosionStatistics statistics;
    // More time than a sweep a microsecond could use up is as good as for ever.
    mTimeLeft += std::min(seconds * mSettings.sweepsPerSecond, 1e12);
    const SweepRule rule{mSettings.rule, mSettings.relaxation, mSettings.startAngle, RestTolerance / 2};
    const bool isTimed = budget.milliseconds < std::numeric_limits<double>::infinity();
    if (!mActive.isEmpty() && (mTimeLeft >= 1 || mRoundLeft > 0))
        isTimed ? slideInTurns(edit, rule, budget, statistics) : slideAll(edit, rule, budget, statistics);
    // Time that was not to be had is not caught up with, but for what a round in turns may use.
    if (!isTimed || mActive.isEmpty() || mTimeLeft > MostSweepsInTurn)
        mTimeLeft = std::fmod(mTimeLeft, 1.0) + (isTimed && !mActive.isEmpty() ? MostSweepsInTurn : 0);
    statistics.isAtRest = mActive.isEmpty();
    if (statistics.isAtRest)
        simplify(edit, Progress(), statistics);
    return statistics;
}

/// All that are steeper than some material stands.
std::vector<ActiveTriangle> Erosion::steepTriangles(const Tin &tin, const Progress &progress)
{
    const TinArrays &arrays = tin.arrays();
    const double lowest = slopesOf(arrays.totals.layers).lowest();
    std::vector<ActiveTriangle> steep;
    for (TriangleId t = 0; t < arrays.triangleSlots(); ++t) {
        if (progress.isCancelled())
            break;
        if (arrays.isTriangle(t) && !arrays.isVoid(t) && isSteeper(arrays, t, lowest))
            steep.push_back({t, false});
    }
    return steep;
}

/// The coarse pass over all ground that material from steep ground may reach.
void Erosion::slideCoarsely(TinEdit &edit, std::span<const ActiveTriangle> steep, const Progress &progress,
                            ErosionStatistics &statistics)
{
    const Tin &tin = edit.tin();
    const TinArrays &arrays = tin.arrays();
    const SlopeTable &slopes = slopesOf(arrays.totals.layers);
    Patch patch(tin, slopes, mSettings.material, mIds);
    for (const ActiveTriangle &active : steep) {
        if (progress.isCancelled())
            return;
        patch.add(active.triangle);
    }
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
    for (VertexId v = 0; v < arrays.vertexSlots() && !progress.isCancelled(); ++v)
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
        statistics.movedVolume += patch.writeBack(edit, progress);
}

void Erosion::simplify(TinEdit &edit, const Progress &progress, ErosionStatistics &statistics)
{
    if (!(mSettings.flatError > 0) || mReachedCount == 0)
        return;
    statistics.removedVertices +=
        removeRedundant(edit, takeReached(), mSettings.flatError, mSettings.flatAngle, progress);
}

void Erosion::noteReached(std::span<const VertexId> vertices)
{
    for (const VertexId v : vertices) {
        mReached.resize(std::size_t(v) + 1);
        mReachedCount += mReached.set(v);
    }
}

/// Ascending; and forgets them.
std::vector<VertexId> Erosion::takeReached()
{
    std::vector<VertexId> reached;
    reached.reserve(std::exchange(mReachedCount, 0));
    mReached.forEachSet([&](std::size_t v) { reached.push_back(VertexId(v)); });
    for (const VertexId v : reached)
        mReached.clear(v);
    return reached;
}

Result<ErosionStatistics> Erosion::settle(TinEdit &edit, const Progress &progress)
{
    const Tin &tin = edit.tin();
    if (const auto checked = checkLayers(tin); !checked)
        return fail(checked.error());
    ErosionStatistics statistics;
    std::uint64_t most = 1;
    if (mSettings.hasCoarsePass && mSettings.rule == ErosionRule::Face)
        if (const std::vector<ActiveTriangle> steep = steepTriangles(tin, progress); !steep.empty())
            slideCoarsely(edit, steep, progress, statistics);
    // Again until nothing moves: vertices that were removed left other triangles.
    Manner manner{{mSettings.rule, mSettings.relaxation, RestTolerance, RestTolerance / 2},
                  mSettings.longestEdge,
                  false,
                  LargestAddition,
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
        takeReached();
    }
    mActive.clear();
    mRoundLeft = 0;
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    statistics.isAtRest = true;
    return statistics;
}

} // namespace model::terrain
