// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/geometry/vec.h"

#include <span>

namespace model {

/// The largest distance between two of the points, in double and exact up to its rounding; 0 for fewer than two.
///
/// Cost: about O(n log n) for surfaces; pairs of boxes that cannot hold a longer distance are never looked into.
/// A cancel through `progress` ends it early with a distance that is too short.
double diameter(std::span<const Vec3f> points, const Progress &progress = Progress());

} // namespace model
