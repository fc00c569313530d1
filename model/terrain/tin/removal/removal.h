// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tinwriter.h"

namespace model::terrain {

/// Whether removeVertex() can take `v` away: it holds no constraint and is no corner of the domain.
bool canRemoveVertex(const TinArrays &tin, VertexId v);

/// Removes `v` and fills the hole. Precondition: canRemoveVertex(v).
/// Cost: O(d) for small degrees d, O(d log d) for large ones, and the flips of ties.
/// Source: O. Devillers, On Deletion in Delaunay Triangulations, 1999. Differs: the powers that order the ears are
/// computed in floating point; ears are checked exactly, so that the hole is filled in any case, and flips with the
/// exact circle test, on the edges inside the hole, then mend what a rounded power put in the wrong order, and apply
/// the tie rule.
void removeVertex(TinWriter &writer, VertexId v);

} // namespace model::terrain
