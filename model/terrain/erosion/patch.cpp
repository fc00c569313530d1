// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/erosion/patch.h"

#include "model/terrain/erosion/refine.h"
#include "model/terrain/erosion/slider.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace model::terrain {

namespace {

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Vertices in a cell: enough that few triangles cross its border (about one in fifteen), few enough for the first
/// levels of a processor's cache.
constexpr double VerticesInCell = 1024;

/// The layer that says how steep the surface stands has to be thicker than a film.
constexpr double Film = 1e-9;

} // namespace

SlopeTable::SlopeTable(const LayerTable &layers, std::span<const Material> materials, const Material &bare)
{
    const auto append = [&](const Material &material) {
        auto &curve = mCurves.emplace_back();
        for (int i = 0; i <= Steps; ++i)
            curve[std::size_t(i)] = std::tan(criticalAngleAt(material, double(i) / Steps) * M_PI / 180);
    };
    if (layers.count == 0)
        append(bare);
    for (std::uint32_t l = 0; l < layers.count; ++l)
        append(materials[layers.materials[l]]);
    for (const auto &curve : mCurves)
        mLowest = std::min(mLowest, *std::min_element(curve.begin(), curve.end()));
}

Patch::Patch(const Tin &tin, const SlopeTable &slopes, const Material &bare, Ids &ids)
    : mTin(&tin)
    , mSlopes(&slopes)
    , mScratch(&ids)
    , mSlope(slopes.at(0, bare.humidity))
    , mLayers(tin.arrays().layerCount())
{
    if (mLayers > 1)
        mMode = Mode::Layered;
    if (mScratch->vertices.size() < tin.arrays().vertexSlots())
        mScratch->vertices.resize(tin.arrays().vertexSlots(), None);
    if (mScratch->triangles.size() < tin.arrays().triangleSlots())
        mScratch->triangles.resize(tin.arrays().triangleSlots());
    makeCells(tin.domain().low, tin.domain().high, tin.vertexCount());
}

Patch::Patch(std::span<const PatchVertex> vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
             double slope)
    : mSlope(slope)
    , mVertices(vertices.begin(), vertices.end())
    , mFloors(vertices.size(), -Infinity)
    , mIsWhole(vertices.size(), 1)
{
    Point2 low{Infinity, Infinity}, high{-Infinity, -Infinity};
    for (const PatchVertex &v : vertices) {
        low = {std::min(low.x, v.x), std::min(low.y, v.y)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y)};
    }
    makeCells(low, high, vertices.size());
    for (const auto &v : triangles)
        file({{v[0], v[1], v[2]}, 0});
}

void Patch::makeCells(Point2 low, Point2 high, std::size_t vertices)
{
    mLow = low;
    const double width = high.x - low.x, height = high.y - low.y;
    const double cells = std::max(1.0, double(vertices) / VerticesInCell);
    // Of a domain that is all length and no breadth no more cells than vertices.
    mCellsPerMetre = std::min(std::sqrt(cells / (width * height)), cells / std::max(width, height));
    for (int grid = 0; grid < 2; ++grid) {
        mColumns[grid] = std::size_t(width * mCellsPerMetre) + 2;
        mRows[grid] = std::size_t(height * mCellsPerMetre) + 2;
        mLists[grid].resize(mColumns[grid] * mRows[grid]);
    }
}

Patch::~Patch()
{
    for (const VertexId v : mIds)
        mScratch->vertices[v] = None;
    for (const TriangleId t : mTriangleIds)
        mScratch->triangles[t] = false;
}

std::size_t Patch::cellOf(const PatchVertex &v, int grid) const
{
    const double shift = grid ? 0.5 : 0;
    const auto column = std::size_t(std::max(0.0, (v.x - mLow.x) * mCellsPerMetre + shift));
    const auto row = std::size_t(std::max(0.0, (v.y - mLow.y) * mCellsPerMetre + shift));
    return std::min(row, mRows[grid] - 1) * mColumns[grid] + std::min(column, mColumns[grid] - 1);
}

std::uint32_t Patch::addVertex(VertexId v)
{
    std::uint32_t &local = mScratch->vertices[v];
    if (local != None)
        return local;
    local = std::uint32_t(mVertices.size());
    const TinArrays &tin = mTin->arrays();
    mVertices.push_back({tin.points[v].x, tin.points[v].y, tin.heights[v], 1 / dualArea(tin, v)});
    mIds.push_back(v);
    mIsWhole.push_back(0);
    mFloors.push_back(mLayers > 0 ? tin.bedrock(v) : -Infinity);
    if (mMode == Mode::Layered) {
        appendColumn(v);
    } else if (mLayers == 1 && tin.thicknesses[v] > 0) {
        const auto humidity = double(tin.humidities[v]);
        if (mHumidity < 0) {
            mHumidity = humidity;
            mSlope = mSlopes->at(0, humidity);
        } else if (humidity != mHumidity) {
            becomeLayered();
        }
    }
    return mScratch->vertices[v];
}

void Patch::appendColumn(VertexId v)
{
    const TinArrays &tin = mTin->arrays();
    for (std::uint32_t l = 0; l < mLayers; ++l) {
        mThicknesses.push_back(tin.sample(v, l).thickness);
        mHumidities.push_back(tin.sample(v, l).humidity);
    }
    mSurfaceSlopes.push_back(0);
    refreshSlope(std::uint32_t(mSurfaceSlopes.size() - 1));
}

/// From one humidity to many: the columns get what has moved meanwhile.
void Patch::becomeLayered()
{
    mMode = Mode::Layered;
    for (std::size_t i = 0; i < mIds.size(); ++i) {
        const bool isNew = i + 1 == mIds.size();
        mThicknesses.push_back(isNew ? mTin->arrays().thicknesses[mIds[i]]
                                     : std::max(0.0, mVertices[i].z - mFloors[i]));
        const bool isDry = !(mTin->arrays().thicknesses[mIds[i]] > 0);
        mHumidities.push_back(isDry ? float(std::max(0.0, mHumidity)) : mTin->arrays().humidities[mIds[i]]);
        mSurfaceSlopes.push_back(0);
        refreshSlope(std::uint32_t(i));
    }
}

void Patch::refreshSlope(std::uint32_t local)
{
    const std::size_t at = std::size_t(local) * mLayers;
    mSurfaceSlopes[local] = Infinity;
    for (std::uint32_t l = mLayers; l-- > 0;)
        if (mThicknesses[at + l] > Film) {
            mSurfaceSlopes[local] = mSlopes->at(l, double(mHumidities[at + l]));
            return;
        }
}

void Patch::add(TriangleId t, bool isMoving)
{
    const TinArrays &tin = mTin->arrays();
    if (tin.isVoid(t) || mScratch->triangles[t])
        return;
    mScratch->triangles[t] = true;
    mTriangleIds.push_back(t);
    PatchTriangle triangle{{}, 2 * t + isMoving};
    for (std::uint32_t i = 0; i < 3; ++i)
        triangle.vertices[i] = addVertex(tin.vertex(cornerOf(t, i)));
    file(triangle);
}

/// Puts a triangle into the list it belongs to.
void Patch::file(const PatchTriangle &triangle)
{
    ++mTriangleCount;
    List *list = &mRest;
    for (int grid = 0; grid < 2 && list == &mRest; ++grid) {
        const std::size_t cell = cellOf(mVertices[triangle.vertices[0]], grid);
        if (cellOf(mVertices[triangle.vertices[1]], grid) == cell &&
            cellOf(mVertices[triangle.vertices[2]], grid) == cell)
            list = &mLists[grid][cell];
    }
    list->triangles.push_back(triangle);
    list->isDirty = true;
}

void Patch::grow(List &list)
{
    for (const std::uint32_t local : list.pending)
        forEachCornerAround(mTin->arrays(), mIds[local], [&](Corner c) {
            const TriangleId t = triangleOf(c);
            if (mLongestEdge > 0 && !mScratch->triangles[t] && !mTin->arrays().isVoid(t) &&
                hasLongEdge(mTin->arrays(), t, mLongestEdge))
                mLongTriangles.push_back(t);
            add(t);
        });
    list.pending.clear();
}

/// The lists of the other grid that share vertices with a cell.
void Patch::wakeAround(std::size_t cell, int grid)
{
    mRest.isDirty = true;
    const std::size_t column = cell % mColumns[grid], row = cell / mColumns[grid];
    const int other = 1 - grid;
    for (int i = 0; i < 4; ++i) {
        // A cell of the first grid lies under its own number and the next of the second.
        const std::size_t c = grid == 0 ? column + (i & 1) : column - (i & 1),
                          r = grid == 0 ? row + (i >> 1) : row - (i >> 1);
        if (c < mColumns[other] && r < mRows[other])
            mLists[other][r * mColumns[other] + c].isDirty = true;
    }
}

void Patch::sweepGrid(int grid, Team &team, const SweepRule &rule, const Progress &progress, SweepCount &count)
{
    std::vector<std::size_t> dirty;
    for (std::size_t cell = 0; cell < mLists[grid].size(); ++cell)
        if (mLists[grid][cell].isDirty)
            dirty.push_back(cell);
    const Slider slider(*this, rule);
    const std::function<void(std::size_t)> body = [&](std::size_t i) {
        if (!progress.isCancelled())
            slider.sweep(mLists[grid][dirty[i]]);
    };
    team.forEach(dirty.size(), body);
    for (const std::size_t cell : dirty) {
        List &list = mLists[grid][cell];
        list.isDirty = list.count.transfers > 0;
        if (list.isDirty)
            wakeAround(cell, grid);
        count.add(std::exchange(list.count, {}));
    }
    for (const std::size_t cell : dirty)
        if (!progress.isCancelled())
            grow(mLists[grid][cell]);
}

SweepCount Patch::sweep(Team &team, const SweepRule &rule, const Progress &progress)
{
    SweepCount count;
    sweepGrid(0, team, rule, progress, count);
    sweepGrid(1, team, rule, progress, count);
    if (mRest.isDirty) {
        Slider(*this, rule).sweep(mRest);
        mRest.isDirty = mRest.count.transfers > 0;
        if (mRest.isDirty)
            for (const PatchTriangle &triangle : mRest.triangles)
                if (triangle.isMoving())
                    for (const std::uint32_t v : triangle.vertices)
                        for (int grid = 0; grid < 2; ++grid)
                            mLists[grid][cellOf(mVertices[v], grid)].isDirty = true;
        count.add(std::exchange(mRest.count, {}));
        grow(mRest);
    }
    return count;
}

bool Patch::isAtRest() const
{
    bool isDirty = mRest.isDirty;
    for (const auto &lists : mLists)
        for (const List &list : lists)
            isDirty |= list.isDirty;
    return !isDirty;
}

void Patch::wake()
{
    mRest.isDirty = true;
    for (auto &lists : mLists)
        for (List &list : lists)
            list.isDirty = !list.triangles.empty();
}

double Patch::writeBack(TinEdit &edit, const Progress &progress) const
{
    CompensatedSum moved;
    for (std::size_t i = 0; i < mIds.size() && !progress.isCancelled(); ++i) {
        const TinArrays &tin = mTin->arrays();
        const VertexId v = mIds[i];
        const double z = mVertices[i].z, before = tin.heights[v];
        if (mMode == Mode::Layered) {
            const std::size_t at = i * mLayers;
            const bool isSame = std::equal(mThicknesses.data() + at, mThicknesses.data() + at + mLayers,
                                           tin.thicknesses.data() + tin.layerSlot(v, 0)) &&
                                std::equal(mHumidities.data() + at, mHumidities.data() + at + mLayers,
                                           tin.humidities.data() + tin.layerSlot(v, 0));
            if (isSame)
                continue;
            edit.place(v, z, mThicknesses.data() + at, mHumidities.data() + at);
        } else if (z != before) {
            const double thickness = std::max(0.0, z - mFloors[i]);
            const float humidity = mHumidity >= 0 ? float(mHumidity) : 0;
            edit.place(v, z, &thickness, &humidity);
        }
        if (z < before)
            moved.add((before - z) / mVertices[i].inverseArea);
    }
    edit.bookMoved(moved.value());
    return moved.value();
}

std::vector<std::pair<TriangleId, bool>> Patch::slidingTriangles(const SweepRule &rule, const Progress &progress)
{
    std::vector<std::pair<TriangleId, bool>> sliding;
    const Slider slider(*this, rule);
    const auto collect = [&](const List &list) {
        if (list.isDirty && !progress.isCancelled())
            for (const PatchTriangle &triangle : list.triangles)
                if (slider.isSliding(triangle))
                    sliding.push_back({triangle.id(), triangle.isMoving()});
    };
    for (const auto &lists : mLists)
        for (const List &list : lists)
            collect(list);
    collect(mRest);
    return sliding;
}

} // namespace model::terrain
