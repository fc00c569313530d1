// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tin.h"

#include <span>

namespace model::terrain {

/// A constraint as a file holds it.
struct ConstrainedEdge
{
    VertexId a = None, b = None;
    OwnerId owner = None;

    friend constexpr bool operator==(const ConstrainedEdge &, const ConstrainedEdge &) = default;
};

/// Makes a TIN of a triangulation that is known, without searching or flipping: from a file, or from whoever worked on
/// arrays of his own. What follows from the rest is computed here: corners, constrained bits, records and their lists,
/// dual areas, counts, hint grid.
///
/// \param arrays       points, heights, layers (and which they are, in the totals), triangleVertices, opposites and
/// triangleFlags of slots that are all in
///                     use; bits of `opposites` that say "constrained", the other arrays and the counts are ignored.
///                     Vertices 0 to 3 are the corners of `domain`
/// \param constraints  edges of the triangulation, a and b in any order; those of VoidOwner are ignored: they are
///                     found again where void and other triangles meet
/// \param start        Kept: the ledger is that of `arrays`; Anew: it begins with the volume there is
/// \error BrokenTerrain  a rule of validate.h that does not hold: the arrays may come from anybody. All are checked
///                       but those of the lists and areas made here
/// Cost: O(n), on all threads.
enum class LedgerStart : std::uint8_t { Anew, Kept };
Result<Tin> restoreTin(TinArrays arrays, const Rectangle &domain, std::span<const ConstrainedEdge> constraints,
                       LedgerStart start = LedgerStart::Anew);

/// The constraints of a TIN, VoidOwner's left out, in the order of their records; a < b.
std::vector<ConstrainedEdge> constrainedEdges(const TinArrays &tin);

} // namespace model::terrain
