// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/terrain/tin/ids.h"

#include <cstdint>
#include <span>
#include <vector>

namespace model::terrain {

/// What a person painted to protect the ground from tools: a raster of bytes over the terrain's domain, 0 open ... 255
/// protected. It is no column of the TIN, so that painting adds no vertices and stamps, which replace them, do not blur
/// it.
class PaintMask
{
public:
    /// Cells along the longer side of a new mask.
    static constexpr std::uint32_t UsualCells = 512;
    static constexpr std::uint32_t MostCells = 4096;

    /// Nothing is protected. Precondition: the domain has an inside.
    explicit PaintMask(const Rectangle &domain);
    /// \param values  row by row from the lowest y
    /// \error BadValue  a number of cells outside 1 ... MostCells, or of values that is not their product
    static Result<PaintMask> restore(const Rectangle &domain, std::uint32_t columns, std::uint32_t rows,
                                     std::vector<std::uint8_t> values);

    std::uint32_t columns() const { return mColumns; }
    std::uint32_t rows() const { return mRows; }
    std::span<const std::uint8_t> values() const { return mValues; }
    /// Nothing is protected at all. Cost: O(cells).
    bool isEmpty() const;

    /// 0 open ... 1 protected: between the middles of cells as straight as can be; beyond the domain as at its border.
    double at(Point2 p) const;

    /// Protects a disc drawn from `from` to `to`, with a soft rim, at most up to `strength`; or opens it, at least down
    /// to 1 - strength. What is more protected (open) already stays.
    void paint(Point2 from, Point2 to, double radius, double strength, bool isOpening);
    void invert();

    friend bool operator==(const PaintMask &, const PaintMask &) = default;

private:
    PaintMask(const Rectangle &domain, std::uint32_t columns, std::uint32_t rows, std::vector<std::uint8_t> values);

    Rectangle mDomain;
    std::uint32_t mColumns, mRows;
    double mCellX, mCellY; ///< metres
    std::vector<std::uint8_t> mValues;
};

} // namespace model::terrain
