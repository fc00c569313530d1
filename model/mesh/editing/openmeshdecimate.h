// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/mesh/trianglemesh.h"

#include <optional>
#include <span>

namespace model {

/// The triangles that are left, over the vertices of before. The only door to OpenMesh.
/// Precondition: an oriented manifold, no triangle with a repeated index.
/// \returns nothing if OpenMesh did not take the triangles as they are, or if it was cancelled
std::optional<std::vector<Triangle>> decimatedTriangles(std::span<const Vec3f> positions,
                                                        std::span<const Triangle> triangles, std::uint32_t target,
                                                        const Progress &progress);

} // namespace model
