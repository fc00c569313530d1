// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/simplify/heightgrid.h"

namespace model::terrain {

namespace {

/// -1: no border; else whether the ground is on the far side.
int kindOf(bool before, bool after)
{
    return before == after ? -1 : after ? 1 : 0;
}

} // namespace

std::vector<GridSegment> voidBorder(const HeightGrid &grid)
{
    std::vector<GridSegment> segments;
    const std::uint32_t squaresX = grid.columns - 1, squaresY = grid.rows - 1;
    for (std::uint32_t j = 1; j < squaresY; ++j) {
        int running = -1;
        for (std::uint32_t i = 0; i < squaresX; ++i) {
            const int kind = kindOf(grid.isGround(i, j - 1), grid.isGround(i, j));
            if (kind >= 0 && kind != running)
                segments.push_back({i, j, i + 1, j});
            else if (kind >= 0)
                segments.back().toColumn = i + 1;
            running = kind;
        }
    }
    for (std::uint32_t i = 1; i < squaresX; ++i) {
        int running = -1;
        for (std::uint32_t j = 0; j < squaresY; ++j) {
            const int kind = kindOf(grid.isGround(i - 1, j), grid.isGround(i, j));
            if (kind >= 0 && kind != running)
                segments.push_back({i, j, i, j + 1});
            else if (kind >= 0)
                segments.back().toRow = j + 1;
            running = kind;
        }
    }
    return segments;
}

} // namespace model::terrain
