// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tinarrays.h"

namespace model::terrain {

/// A vertex near any point, to begin a search from: a grid of about one cell for two vertices, each with one of its
/// vertices. It is a hint, not part of the TIN's state: a cell may name a vertex that has gone, which is noticed when
/// it is asked, and nothing that a TIN computes depends on it.
class HintGrid
{
public:
    /// Covers `domain` anew with cells for the vertices there are.
    void build(const TinArrays &tin, const Rectangle &domain);
    /// True if there are many more vertices than the grid was built for.
    bool isTooCoarse(const TinArrays &tin) const { return tin.totals.vertices > 8 * mCells.size() + 64; }

    void note(VertexId v, Point2 p) { mCells[cellOf(p)] = v; }
    /// Where `gone`, at `p`, was named, names `other`.
    void replace(VertexId gone, Point2 p, VertexId other)
    {
        if (VertexId &cell = mCells[cellOf(p)]; cell == gone)
            cell = other;
    }
    /// A vertex near `p`.
    VertexId near(const TinArrays &tin, Point2 p) const;

    std::size_t byteSize() const { return mCells.byteSize(); }

private:
    std::size_t cellOf(Point2 p) const;
    bool isGood(const TinArrays &tin, std::size_t cell) const;

    Point2 mLow;
    double mScaleX = 0, mScaleY = 0; ///< cells for a metre
    std::uint32_t mColumns = 1, mRows = 1;
    FlatArray<VertexId> mCells;
};

} // namespace model::terrain
