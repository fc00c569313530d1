// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/query/hintgrid.h"

#include <algorithm>
#include <cmath>

namespace model::terrain {

namespace {

constexpr double VerticesPerCell = 2;

std::uint32_t clampedIndex(double position, std::uint32_t count)
{
    return position >= count ? count - 1 : position > 0 ? std::uint32_t(position) : 0;
}

} // namespace

void HintGrid::build(const TinArrays &tin, const Rectangle &domain)
{
    const double width = domain.high.x - domain.low.x, height = domain.high.y - domain.low.y;
    const double cells = std::max(1.0, tin.totals.vertices / VerticesPerCell);
    // Square cells, but never more columns or rows than cells: a domain may be a thin strip.
    const double columns = std::clamp(std::sqrt(cells * (width / height)), 1.0, cells);
    mColumns = std::uint32_t(columns);
    mRows = std::uint32_t(std::max(1.0, cells / columns));
    mLow = domain.low;
    mScaleX = mColumns / width;
    mScaleY = mRows / height;
    mCells.resize(std::size_t(mColumns) * mRows);
    std::fill(mCells.data(), mCells.data() + mCells.size(), None);
    for (VertexId v = 0; v < tin.vertexSlots(); ++v)
        if (tin.isVertex(v))
            note(v, tin.points[v]);
    // Empty cells point to where the cells before them do: first along the rows, then from row to row.
    for (std::uint32_t y = 0; y < mRows; ++y) {
        VertexId *const row = mCells.data() + std::size_t(y) * mColumns;
        for (std::uint32_t x = 1; x < mColumns; ++x)
            if (row[x] == None)
                row[x] = row[x - 1];
        for (std::uint32_t x = mColumns - 1; x > 0; --x)
            if (row[x - 1] == None)
                row[x - 1] = row[x];
        if (row[0] == None && y > 0)
            std::copy(row - mColumns, row, row);
    }
    for (std::uint32_t y = mRows - 1; y > 0; --y) {
        VertexId *const row = mCells.data() + std::size_t(y) * mColumns;
        if (row[0] != None && row[-std::int64_t(mColumns)] == None)
            std::copy(row, row + mColumns, row - mColumns);
    }
}

std::size_t HintGrid::cellOf(Point2 p) const
{
    return std::size_t(clampedIndex((p.y - mLow.y) * mScaleY, mRows)) * mColumns +
           clampedIndex((p.x - mLow.x) * mScaleX, mColumns);
}

bool HintGrid::isGood(const TinArrays &tin, std::size_t cell) const
{
    const VertexId v = mCells[cell];
    return v != None && tin.isVertex(v) && cellOf(tin.points[v]) == cell;
}

VertexId HintGrid::near(const TinArrays &tin, Point2 p) const
{
    const std::size_t cell = cellOf(p);
    if (isGood(tin, cell))
        return mCells[cell];
    // The cells around it; then whatever this one names, wherever it is.
    const std::uint32_t column = std::uint32_t(cell % mColumns), row = std::uint32_t(cell / mColumns);
    for (std::uint32_t y = row > 0 ? row - 1 : 0; y <= std::min(row + 1, mRows - 1); ++y)
        for (std::uint32_t x = column > 0 ? column - 1 : 0; x <= std::min(column + 1, mColumns - 1); ++x)
            if (isGood(tin, std::size_t(y) * mColumns + x))
                return mCells[std::size_t(y) * mColumns + x];
    if (mCells[cell] != None && tin.isVertex(mCells[cell]))
        return mCells[cell];
    // Vertices come and go, the domain's corners stay.
    return 0;
}

} // namespace model::terrain
