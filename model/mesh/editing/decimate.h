// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/mesh/editing/editerror.h"

namespace model {

/// Fewer triangles of about the same shape: edges are drawn together into one of their ends, those first that change
/// the surface least. Vertices that stay are where they were, so all frames of an animation keep one connectivity; the
/// shape that counts is that of `positions`. Topology stays: no handle, hole or component comes or goes. Polygons
/// become fans. \param target  triangles to stop at; more may stay where no edge can go \error NotManifold  what a
/// half-edge structure cannot hold: repair it first \error Cancelled Source: M. Garland, P. Heckbert: Surface
/// Simplification Using Quadric Error Metrics, 1997, as OpenMesh 9.0 has it.
EditResult decimate(const Faces &faces, std::span<const Vec3f> positions, std::uint32_t target,
                    const Progress &progress = Progress());

} // namespace model
