// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/erosion/patch.h"

namespace model::terrain {

/// Moves the bulk of material of one kind where it will come to rest, on a coarse grid over the patch, so that sweeps
/// over the vertices themselves have only details left to do: each sweep carries material over one triangle.
///
/// Nodes of the grid have bilinear hat functions psi_g. Areas and volumes are those that the hats weigh,
/// A_g = sum A_v psi_g(v) and V_g = sum A_v z_v psi_g(v); the grid settles (by the same pass, if it is large itself),
/// and what its heights change by is interpolated: z_v += sum psi_g(v) dz_g. As sum A_g dz_g = 0, the volume under the
/// vertices stays what it was.
///
/// \param reach  the radius of the heap that all the material would make
/// Nothing happens where a vertex would sink below its floor, to a patch too small to profit, or without a uniform
/// slope. Precondition: no void lies within the patch's bounds.
void coarsePass(std::span<PatchVertex> vertices, std::span<const double> floors, double slope, double reach, Team &team,
                const Progress &progress, SweepCount &count);

} // namespace model::terrain
