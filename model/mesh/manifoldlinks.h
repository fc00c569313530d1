// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/cornertable.h"

#include <optional>

namespace model {

/// Which corners are opposite to each other in a clean mesh.
struct ManifoldLinks
{
    std::vector<Corner> opposites; ///< #C
    /// Whether the triangles at some vertex are more than one fan or ring.
    bool hasManyFans = false;
};

/// The links of a mesh whose edges all have one triangle, or two in opposite directions, none with a repeated index,
/// and whose vertices have at most 32; nothing for any other. In such a mesh forEachEdge() finds the same links, in
/// twice the time.
/// Precondition: indices below vertexCount, 3 T < 2^32. Linear time, 14 bytes for a triangle beside the result.
std::optional<ManifoldLinks> manifoldLinks(const Connectivity &connectivity);

} // namespace model
