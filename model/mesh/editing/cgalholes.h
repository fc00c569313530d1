// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/geometry/vec3d.h"
#include "model/mesh/trianglemesh.h"

#include <span>

namespace model {

/// A lid over a loop of points: triangles over the loop's points 0..n-1, in the order of the loop, and new ones after.
struct HolePatch
{
    std::vector<Triangle> triangles;
    std::vector<Vec3d> added;
};

/// Triangulates a closed loop so that dihedral angles and area are small, and adds points so that lengths of edges go
/// over from those at the border, if `refine`. The only door to CGAL's polygon mesh processing.
/// \param loop  at least 3 points
/// \returns     no triangles if CGAL finds none, as where points coincide
HolePatch triangulateLoop(std::span<const Vec3d> loop, bool refine);

} // namespace model
