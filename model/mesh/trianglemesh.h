// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/geometry/vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace model {

/// Three indices into a mesh's vertices, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// What all frames of an animation share. Takes dirty input as it is: degenerate, duplicate and non-manifold
/// triangles and isolated vertices stay. Invariant kept by every reader: each index is below vertexCount.
struct Connectivity
{
    std::uint32_t vertexCount = 0;
    std::vector<Triangle> triangles; ///< #T x 3

    friend bool operator==(const Connectivity &, const Connectivity &) = default;
};

/// One mesh: positions #V x 3 and how they connect. positions.size() == connectivity.vertexCount.
struct TriangleMesh
{
    std::vector<Vec3f> positions;
    Connectivity connectivity;
};

} // namespace model
