// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/direct/prediction.h"
#include "model/geometry/vec.h"

namespace model::codec {

class FrameStack;

/// Cubic cells in the box around all frames: a position becomes the cell that it lies in, and then that cell's middle,
/// which is at most half a diagonal of a cell away. FORMAT.md 11.1.
struct CellGrid
{
    /// The grid with `resolution` cells along the longest side, centred in the box along the other ones, so that what
    /// is flat stays where it is.
    static CellGrid around(const FrameStack &frames, std::uint32_t resolution);

    Cell cellOf(Vec3f position) const;
    Vec3f middleOf(const Cell &cell) const;

    std::array<double, 3> origin{}; ///< middle of the first cell
    double cell = 0;                ///< side of a cell; 0: all vertices are in one place
    std::uint32_t resolution = 1;
};

} // namespace model::codec
