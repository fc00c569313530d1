// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tinarrays.h"

#include <QRgb>

#include <vector>

namespace views {

/// The constrained edges of a TIN, but for the border of its domain.
struct ConstraintLines
{
    std::vector<std::uint32_t> vertices; ///< two for each line
    std::vector<std::uint32_t> colors;   ///< of each line, 0xAABBGGRR
};

/// An edge with several owners is there for each. Cost: O(constraints).
ConstraintLines constraintLines(const model::terrain::TinArrays &tin, bool isByOwner);

/// The colour of an owner; those that follow each other differ clearly.
QRgb ownerColor(model::terrain::OwnerId owner);
inline constexpr QRgb ConstraintColor = 0xffe02424;

} // namespace views
