// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/faces.h"

namespace model {

// Numbers of each vertex, to be shown as colours. All take any mesh; polygons count as fans where areas and angles
// matter. NaN where a vertex has none, as without a face.

/// The edges at each vertex.
std::vector<float> valences(const Faces &faces);

struct Curvatures
{
    std::vector<float> mean;     ///< #V, 1/length; above zero where the surface bulges to the side that faces look to
    std::vector<float> gaussian; ///< #V, 1/area
};
/// Curvature at each vertex; NaN on borders and where more than two faces meet at an edge.
/// Source: M. Meyer, M. Desbrun, P. Schroeder, A. Barr: Discrete Differential-Geometry Operators for Triangulated
/// 2-Manifolds, 2003 (mixed areas, cotangents, angle defect).
/// \param positions  #V
Curvatures curvatures(const Faces &faces, std::span<const Vec3f> positions);

} // namespace model
