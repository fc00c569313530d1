// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/constraints/constraintlists.h"
#include "model/terrain/tools/imprint.h"

// What the files of ImprintStroke share.
namespace model::terrain {

inline constexpr int MostHalvings = 3; ///< of an edge of the outline that follows the ground

inline double squaredDistance(Point2 a, Point2 b)
{
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// Whether `owner` has a constraint at `v`.
inline bool hasOwner(const TinArrays &tin, VertexId v, OwnerId owner)
{
    for (std::uint32_t r = tin.constraints[v]; r != None; r = nextRecord(tin, r, v))
        if (tin.records[r].owner == owner)
            return true;
    return false;
}

} // namespace model::terrain
