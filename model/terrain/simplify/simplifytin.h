// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/terrain/tin/tin.h"

namespace model::terrain {

/// A TIN through some of the vertices of `tin`, whose height nowhere differs by more than `maxError` from that of
/// `tin`: not at its vertices, and not between them, where the edges of the two cross. Constrained edges, voids and
/// their vertices stay; so do the layers of the vertices that are left. The ledger begins anew. \param loose  an owner
/// whose edges are not kept for their own sake, but only where the error needs them \error Cancelled Cost: O((n + m)
/// log m) expected for m vertices left of n. Source: M. Garland, P. S. Heckbert, Fast Polygonal Approximation of
/// Terrains and Height Fields, 1995. Differs: the samples are a TIN, and its edges are looked at too: a Delaunay edge
/// whose ends are both left is an edge again, so that adding ends, or constraining what was constrained, mends every
/// crossing.
Result<Tin> simplifyTin(const Tin &tin, double maxError, OwnerId loose = None, const Progress &progress = Progress());

} // namespace model::terrain
