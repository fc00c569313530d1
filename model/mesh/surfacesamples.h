// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/vertexedges.h"

namespace model {

/// How many samples fall on each edge and triangle of a frame: as many per length and area everywhere.
struct SampleCounts
{
    std::vector<std::uint32_t> onEdge;     ///< #E, without its ends
    std::vector<std::uint32_t> onTriangle; ///< #T
};

/// Spreads `samplesPerTriangle` * #T samples over the area, none if there is no area; edges get the square root of that
/// density, per length.
SampleCounts countSamples(std::span<const Vec3f> positions, std::span<const Triangle> triangles,
                          std::span<const Edge> edges, double samplesPerTriangle);

/// Barycentric coordinates of the index-th of any number of samples of a triangle. Evenly spread for every number; the
/// same for every triangle.
std::array<double, 3> triangleSample(std::uint32_t index);

} // namespace model
