// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/analysis/meshreport.h"

namespace model {

/// Pairs of faces that meet elsewhere than at corners and edges that they share, the smaller first, ascending: what
/// ProblemKind::SelfIntersection holds. Corners are shared where they are at exactly the same place, so that a seam of
/// unwelded vertices does not count. Exact: no rounding decides. Faces that repeat an earlier one, and triangles
/// without area, are passed by: they are problems of their own. Polygons are looked at as fans. \param limit  stops
/// after about so many pairs \error Cancelled Cost: O((n + k) log n) for k pairs whose boxes meet. In parallel.
Result<std::vector<ProblemIds>> findSelfIntersections(const Faces &faces, std::span<const Vec3f> positions,
                                                      const Progress &progress = Progress(),
                                                      std::size_t limit = 1'000'000);

} // namespace model
