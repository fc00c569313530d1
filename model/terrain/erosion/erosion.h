// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/terrain/erosion/activelist.h"
#include "model/terrain/erosion/patch.h"

#include <functional>
#include <limits>
#include <optional>

namespace model::terrain {

/// When a run() ends although material still moves. Transfers and sweeps make the same terrain everywhere; a time does
/// not: what slides when it is short depends on the machine. An undo, a redo and a recovery are exact all the same, as
/// they go by what was written.
///
/// With a time, what is active takes turns, a lot of some thousand triangles at a time: all that a run() does, writing
/// back too, and all that others do afterwards with what it changed, is bounded by the time and not by how much slides
/// elsewhere. Where there is more than the time allows, the sand slides slower.
struct ErosionBudget
{
    std::uint64_t transfers = std::numeric_limits<std::uint64_t>::max();
    double milliseconds = std::numeric_limits<double>::infinity();
};

struct ErosionStatistics
{
    std::uint64_t sweeps = 0;
    std::uint64_t visits = 0;    ///< triangles looked at
    std::uint64_t transfers = 0; ///< of them, those that moved material
    double movedVolume = 0;      ///< cubic metres that lie elsewhere now
    std::uint32_t addedVertices = 0, removedVertices = 0;
    bool isAtRest = false;
};

/// Lets material slide until it rests, or for a while. Changes heights and layers through a TinEdit, keeps the volume,
/// moves no bedrock and no void, and nothing beyond the border. The same terrain, settings and calls give the same
/// bytes, with one thread or many.
///
/// Keep one for a terrain: it remembers what may still move, and memory of four bytes for a vertex.
/// Source: terrain.md's face rule (Slider); V. Purchart, master's thesis on sand, 2009, for the edge rule.
class Erosion
{
public:
    /// \param materials  those of the terrain; the TIN says which layer is which
    /// \error BadSetting  a setting or parameter (see check()) that erosion could not work with
    static Result<Erosion> create(const ErosionSettings &settings, std::span<const Material> materials);

    const ErosionSettings &settings() const { return mSettings; }

    /// Puts on the list of what may move: everything that an edit changed; everything there is; some triangles.
    void activate(const Tin &tin, const Edit &edit);
    void activateAll(const Tin &tin);
    void activate(std::span<const TriangleId> triangles);
    /// Nothing is on the list. True does not say that nothing could slide, but that nobody reported it.
    bool isAtRest() const { return mActive.isEmpty(); }
    std::size_t activeCount() const { return mActive.size(); }
    std::vector<TriangleId> activeTriangles() const { return mActive.triangles(); }

    /// Lets what is on the list slide for `seconds` of simulated time, at most within the budget. What is left of a
    /// sweep counts next time.
    /// \error BadSetting  seconds below 0 or no number
    /// \error BadValue    a layer of a material that create() was not given; nothing is changed
    Result<ErosionStatistics> run(TinEdit &edit, double seconds, const ErosionBudget &budget = {});

    /// Lets everything slide until no triangle is steeper than its critical angle by more than RestTolerance, where
    /// there is material to move. Whether it is on the list does not matter, and none is left on it. \error BadValue as
    /// for run() \error Cancelled  within 100 ms; the edit may hold vertices that were split and has to be rolled back
    Result<ErosionStatistics> settle(TinEdit &edit, const Progress &progress = Progress());

    /// Degrees.
    static constexpr double RestTolerance = 0.05;
    /// Vertices that one call may add by splitting edges.
    static constexpr std::uint32_t LargestAddition = 4000000;

private:
    struct Manner
    {
        SweepRule rule;
        double longestEdge;                               ///< 0: none is split
        bool isBrief;                                     ///< no more than a few sweeps
        std::uint32_t mostAdded;                          ///< vertices, by splitting edges
        std::function<bool(const SweepCount &)> isEnough; ///< asked after each sweep
    };

    Erosion(const ErosionSettings &settings, std::span<const Material> materials);
    Result<void> checkLayers(const Tin &tin) const;
    const SlopeTable &slopesOf(const LayerTable &layers);
    std::vector<ActiveTriangle> slide(TinEdit &edit, std::vector<ActiveTriangle> start, const Manner &manner,
                                      const Progress &progress, ErosionStatistics &statistics);
    void slideAll(TinEdit &edit, const SweepRule &rule, const ErosionBudget &budget, ErosionStatistics &statistics);
    void slideInTurns(TinEdit &edit, const SweepRule &rule, const ErosionBudget &budget, ErosionStatistics &statistics);
    void slideCoarsely(TinEdit &edit, std::span<const ActiveTriangle> steep, const Progress &progress,
                       ErosionStatistics &statistics);
    std::vector<ActiveTriangle> steepTriangles(const Tin &tin, const Progress &progress);
    void noteReached(std::span<const VertexId> vertices);
    std::vector<VertexId> takeReached();
    void simplify(TinEdit &edit, const Progress &progress, ErosionStatistics &statistics);

    ErosionSettings mSettings;
    std::vector<Material> mMaterials;
    ActiveList mActive;
    double mTimeLeft = 0;       ///< that no sweep has used, in sweeps
    std::size_t mRoundLeft = 0; ///< entries of the list that have not had their turn in this round ...
    double mRoundSweeps = 0;    ///< ... in which each is swept that often
    std::optional<SlopeTable> mSlopes;
    LayerTable mSlopesOf; ///< the layers that mSlopes was made for
    SlotMarks mReached;   ///< vertices that slid since the last simplify()
    std::size_t mReachedCount = 0;
    Patch::Ids mIds;
};

} // namespace model::terrain
