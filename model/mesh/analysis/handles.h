// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/analysis/meshreport.h"

namespace model {

/// A handle, shown by two loops of edges that cross an odd number of times, nearly always once: one goes round the
/// handle, the other through its tunnel.
struct HandleReport
{
    struct Loop
    {
        std::vector<std::uint32_t> vertices; ///< in order, each once; the last is joined to the first
        double length = 0;
    };
    std::uint32_t component = 0;
    std::array<Loop, 2> loops; ///< the shorter first
};

/// The handles of all orientable manifold components. Holes are treated as closed by a lid, so a loop may touch them
/// and run along their border, but none only goes around a hole. Each loop is closed and simple, and cutting along it
/// (lids in place) leaves the component in one piece; all loops of a component together are a basis of its homology.
///
/// The loops are short, not proven shortest: each is the shortest through some vertex, for vertices that are chosen
/// where loops have been found before.
/// \param report  of the same mesh
/// \returns       genus of each component, by component, the handle of the shortest loop first
/// \error Cancelled
/// Cost: O(r n log n), for r = 1 to 4 genus roots, fewer in large components.
/// Source: J. Erickson, K. Whittlesey: Greedy Optimal Homotopy and Homology Generators, 2005; see handles.cpp.
Result<std::vector<HandleReport>> findHandles(const Faces &faces, std::span<const Vec3f> positions,
                                              const MeshReport &report, const Progress &progress = Progress());

} // namespace model
