// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/mesh/analysis/borderloops.h"
#include "model/mesh/editing/editerror.h"

namespace model {

struct HoleFilling
{
    /// Adds vertices so that the lid's triangles are about as large as those around it, and bends it to go on smoothly.
    /// Without: the loop's vertices alone.
    bool isSmooth = true;
};

/// Closes boundary loops by lids of triangles, wound as the faces around them. The lid's shape is found on `positions`;
/// its new vertices are means of the vertices around the hole, so that in other frames of an animation it moves along.
/// \param positions  #V
/// \param holes      of findBorderLoops(); ones that are not closed or have fewer than three vertices are left open
/// \error Cancelled
/// Source: triangulation and refinement as P. Liepa: Filling Holes in Meshes, 2003, by CGAL; bending: fairing.h.
EditResult fillHoles(const Faces &faces, std::span<const Vec3f> positions, std::span<const BorderLoop> holes,
                     const HoleFilling &filling = {}, const Progress &progress = Progress());

} // namespace model
