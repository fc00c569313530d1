// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/terrain/erosion/erosionsettings.h"
#include "model/terrain/erosion/team.h"
#include "model/terrain/tin/tinedit.h"

#include <array>
#include <limits>
#include <span>
#include <vector>

namespace model::terrain {

/// How steep materials stand, made for being asked often: the tangent of the critical angle at 1025 humidities for each
/// layer, straight lines in between.
class SlopeTable
{
public:
    /// Of a terrain without layers: `bare`. Precondition: all of them check().
    SlopeTable(const LayerTable &layers, std::span<const Material> materials, const Material &bare);

    double at(std::uint32_t layer, double humidity) const
    {
        const double place = humidity * Steps;
        const auto i = std::uint32_t(place < Steps - 1 ? place : Steps - 1);
        const std::array<double, Steps + 1> &curve = mCurves[layer];
        return curve[i] + (place - i) * (curve[i + 1] - curve[i]);
    }

    /// Of the weakest layer at its weakest.
    double lowest() const { return mLowest; }

private:
    static constexpr int Steps = 1024;
    std::vector<std::array<double, Steps + 1>> mCurves;
    double mLowest = std::numeric_limits<double>::infinity();
};

/// A vertex as sliding needs it, in one half of a cache line.
struct PatchVertex
{
    double x, y, z, inverseArea;
};

struct PatchTriangle
{
    std::uint32_t vertices[3];
    std::uint32_t tag; ///< twice its number in the TIN, and 1 if it is moving (hysteresis)

    TriangleId id() const { return tag >> 1; }
    bool isMoving() const { return tag & 1; }
    void setMoving(bool moving) { tag = (tag & ~1u) | std::uint32_t(moving); }
};

/// What one sweep goes by.
struct SweepRule
{
    ErosionRule rule = ErosionRule::Face;
    double relaxation = 1;
    double start = 0; ///< degrees above the critical angle from which resting material moves ...
    double stop = 0;  ///< ... and down to which what moves goes on
};

struct SweepCount
{
    std::uint64_t visits = 0, transfers = 0;

    void add(const SweepCount &other)
    {
        visits += other.visits;
        transfers += other.transfers;
    }
};

/// The part of a terrain where material slides, as a copy in an order of its own: it grows with what moves, is swept in
/// parallel, and is written back at the end.
///
/// Vertices are cut into cells of about a thousand by two grids, one shifted by half a cell. Triangles within a cell of
/// the first are swept first, those within a cell of the second then, the few others last and one by one: cells share
/// no vertex, so that no two threads meet, and the result is the same whatever their number.
class Patch
{
public:
    /// An empty one. `ids` is scratch memory that may be kept for the next patch of the same TIN.
    struct Ids
    {
        std::vector<std::uint32_t> vertices;
        std::vector<bool> triangles;
    };
    Patch(const Tin &tin, const SlopeTable &slopes, const Material &bare, Ids &ids);
    /// A mesh of its own, without layers and with nothing to write back to.
    Patch(std::span<const PatchVertex> vertices, std::span<const std::array<std::uint32_t, 3>> triangles, double slope);
    ~Patch();
    Patch(const Patch &) = delete;
    Patch &operator=(const Patch &) = delete;

    /// Adds a triangle unless it is void or there already.
    void add(TriangleId t, bool isMoving = false);
    bool isEmpty() const { return mTriangleCount == 0; }

    /// Notes triangles that are added by what moves, and have edges longer than this. 0: none.
    void watchForLongEdges(double longest) { mLongestEdge = longest; }
    std::span<const TriangleId> longTriangles() const { return mLongTriangles; }

    /// Goes once over all triangles that may move, and adds those around the vertices that did.
    SweepCount sweep(Team &team, const SweepRule &rule, const Progress &progress);
    /// Nothing can move by the rule of the last sweep.
    bool isAtRest() const;
    /// Has all triangles looked at again: the rule changes.
    void wake();

    /// Writes heights and layers of the vertices that moved. Returns the volume that did. Cancelled, it stops
    /// somewhere.
    double writeBack(TinEdit &edit, const Progress &progress) const;
    /// The triangles that are steeper than the rule allows, or on their way. Cancelled, some of them.
    std::vector<std::pair<TriangleId, bool>> slidingTriangles(const SweepRule &rule, const Progress &progress);

    /// The one critical angle (its tangent) if all material is alike, else 0.
    double uniformSlope() const { return mMode == Mode::Layered ? 0 : mSlope; }
    std::span<PatchVertex> vertices() { return mVertices; }
    /// Bedrock of each vertex; minus infinity without layers.
    std::span<const double> floors() const { return mFloors; }
    std::span<const VertexId> ids() const { return mIds; }
    std::size_t triangleCount() const { return mTriangleCount; }

private:
    friend class Slider;

    /// Alike: one layer of one humidity, or no layers at all.
    enum class Mode : std::uint8_t { Alike, Layered };

    struct List
    {
        std::vector<PatchTriangle> triangles;
        std::vector<std::uint32_t> pending; ///< vertices that moved and whose triangles are not all here
        SweepCount count;
        bool isDirty = false;
    };

    std::uint32_t addVertex(VertexId v);
    void appendColumn(VertexId v);
    void becomeLayered();
    void refreshSlope(std::uint32_t local);
    std::size_t cellOf(const PatchVertex &v, int grid) const;
    void wakeAround(std::size_t cell, int grid);
    void sweepGrid(int grid, Team &team, const SweepRule &rule, const Progress &progress, SweepCount &count);
    void grow(List &list);

    void makeCells(Point2 low, Point2 high, std::size_t vertices);
    void file(const PatchTriangle &triangle);

    const Tin *mTin = nullptr;
    const SlopeTable *mSlopes = nullptr;
    Ids *mScratch = nullptr;
    Mode mMode = Mode::Alike;
    double mSlope = 0;     ///< tangent of the critical angle, of material that is alike
    double mHumidity = -1; ///< of material that is alike; below 0: not seen yet
    std::uint32_t mLayers = 0;

    std::vector<PatchVertex> mVertices;
    std::vector<double> mFloors;
    std::vector<std::uint8_t> mIsWhole; ///< all triangles around the vertex are here
    std::vector<VertexId> mIds;
    std::vector<TriangleId> mTriangleIds; ///< for clearing the scratch memory
    // Of Mode::Layered: as in the TIN, and the tangent of the critical angle at the surface (infinity on bedrock).
    std::vector<double> mThicknesses;
    std::vector<float> mHumidities;
    std::vector<double> mSurfaceSlopes;

    Point2 mLow;
    double mCellsPerMetre = 0;
    std::size_t mColumns[2] = {}, mRows[2] = {};
    std::vector<List> mLists[2];
    List mRest;
    std::size_t mTriangleCount = 0;
    double mLongestEdge = 0;
    std::vector<TriangleId> mLongTriangles;
};

} // namespace model::terrain
