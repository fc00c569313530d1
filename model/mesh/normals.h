// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/trianglemesh.h"

#include <span>

namespace model {

/// Smooth vertex normals: the area-weighted mean of the triangles around each vertex, of length 1; (0, 0, 1) for a
/// vertex without a triangle of positive area.
/// \param positions  #V x 3
/// \param triangles  #T x 3, indices into positions
/// \param normals    #V x 3, written
void computeVertexNormals(std::span<const Vec3f> positions, std::span<const Triangle> triangles,
                          std::span<Vec3f> normals);

} // namespace model
