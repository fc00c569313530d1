// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/terrain/tin/tin.h"

#include <vector>

namespace model::io {

/// A line of one height on the surface, the higher ground on its left.
struct Contour
{
    double level = 0;
    bool isClosed = false; ///< then the first point is also the last
    std::vector<terrain::Point2> points;
};

/// The lines at every multiple of `interval` (plus `base`), exactly where the triangles have that height: a vertex just
/// at a level counts as above it. Lines end where the terrain or a void does. Ascending by level.
/// Precondition: interval above zero. \error LimitExceeded (more than a million levels), Cancelled
Result<std::vector<Contour>> contoursOf(const terrain::Tin &tin, double interval, double base = 0,
                                        const Progress &progress = Progress());

} // namespace model::io
