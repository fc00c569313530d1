// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/editing/editedmesh.h"

namespace model {

/// Four triangles in place of each, smoothed: every step of it is a mean of vertices, so it acts on all frames alike.
/// Polygons become fans first. Edges with other than two faces stay sharp, as borders do.
/// Source: C. Loop: Smooth Subdivision Surfaces Based on Triangles, 1987; borders as H. Hoppe et al.: Piecewise Smooth
/// Surface Reconstruction, 1994.
EditedMesh subdivide(const Faces &faces);

struct Smoothing
{
    unsigned rounds = 10; ///< each keeps the volume, nearly
    bool keepBorders = true;
};

/// The positions of one frame after smoothing; faces and their number stay, so it goes for each frame by itself.
/// \param positions  #V
/// Source: G. Taubin: A Signal Processing Approach to Fair Surface Design, 1995 (lambda | mu, uniform weights).
std::vector<Vec3f> smooth(const Faces &faces, std::span<const Vec3f> positions, const Smoothing &smoothing = {});

} // namespace model
