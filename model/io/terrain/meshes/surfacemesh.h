// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/mesh/trianglemesh.h"
#include "model/terrain/tin/tin.h"

namespace model::io {

/// Owner of the edges of a mesh that was imported as a surface.
inline constexpr terrain::OwnerId SurfaceOwner = 0;

/// The mesh as a TIN over the box of its points: every triangle of it is one of the TIN, its edges are constrained for
/// SurfaceOwner, and what it does not cover is void. `positions` are #V x 3, z up, from the local origin.
/// \error NotASurface  args: where, and why: it has two heights there. Decided exactly
/// \error NoVertices, NonFinite, BadValue (no extent), Cancelled
Result<terrain::Tin> tinOfSurface(std::span<const terrain::Point3> positions, std::span<const Triangle> triangles,
                                  const Progress &progress = Progress());

} // namespace model::io
