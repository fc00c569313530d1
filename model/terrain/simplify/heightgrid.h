// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/ids.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace model::terrain {

/// Heights at the nodes of a regular grid, the first one at the origin of the local frame; NaN where there is none.
struct HeightGrid
{
    std::uint32_t columns = 0, rows = 0;
    double stepX = 1, stepY = 1; ///< metres between nodes, above zero
    std::vector<double> heights; ///< #rows x #columns, from the south; NaN: void

    std::size_t index(std::uint32_t i, std::uint32_t j) const { return std::size_t(j) * columns + i; }
    double height(std::uint32_t i, std::uint32_t j) const { return heights[index(i, j)]; }
    /// Where node (i, j) lies. Files count on the product being rounded just so.
    Point2 point(std::uint32_t i, std::uint32_t j) const { return {double(i) * stepX, double(j) * stepY}; }
    /// True if the square between the nodes (i, j) and (i + 1, j + 1) is ground: all its corners have a height.
    bool isGround(std::uint32_t i, std::uint32_t j) const
    {
        return !std::isnan(height(i, j) + height(i + 1, j) + height(i, j + 1) + height(i + 1, j + 1));
    }
    Rectangle domain() const { return {{0, 0}, point(columns - 1, rows - 1)}; }
};

/// The nodes (i, j) of a square's corner that begin and end a straight piece of the border between ground and void.
struct GridSegment
{
    std::uint32_t fromColumn = 0, fromRow = 0, toColumn = 0, toRow = 0;
};

/// The border between ground and void squares, the grid's own border left out, as straight pieces: each as long as it
/// can be without passing a node where it could turn.
std::vector<GridSegment> voidBorder(const HeightGrid &grid);

} // namespace model::terrain
