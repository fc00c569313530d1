// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/mesh/trianglemesh.h"

#include <vector>

namespace model::io {

/// Makes one vertex of those that are at exactly the same place in every frame; the vertices that stay keep their
/// order, the triangles theirs.
/// \param positions  #F*V, frame after frame; changed, as is `connectivity`
/// \error Cancelled  both are then of no use
/// Cost: O(F V).
Result<void> weldTrajectories(Connectivity &connectivity, std::vector<Vec3f> &positions,
                              const Progress &progress = Progress());

} // namespace model::io
