// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/codec/connectivity/symbolmodel.h"
#include "model/mesh/trianglemesh.h"

#include <array>
#include <optional>

namespace model::codec {

/// How EdgeBreaker sees a mesh: what it has to say to rebuild it, and where.
struct WalkStatistics
{
    std::array<std::uint64_t, 5> symbolCounts{}; ///< by Clers
    /// #T; nothing for the first triangle of a part without a border, which has no symbol.
    std::vector<std::optional<Clers>> symbolOf;
    /// How often one symbol follows another, by Clers and Clers.
    std::array<std::array<std::uint64_t, 5>, 5> followCounts{};
    std::vector<std::uint32_t> splits;       ///< triangles whose S parts the open edges in two: most of all S
    std::vector<std::uint32_t> handleSplits; ///< triangles whose S joins two loops again: one for each handle
    struct Hole
    {
        std::uint32_t length = 0;              ///< edges
        std::optional<std::uint32_t> triangle; ///< that reached it; none where a part starts with it
    };
    std::vector<Hole> holes;      ///< in the order of the walk
    std::uint32_t components = 0; ///< of the mesh as it is cut into manifolds
    std::uint32_t copies = 0;     ///< vertices that the cut added
    std::uint64_t bytes = 0;      ///< of the coded connectivity
    double bitsPerTriangle = 0;   ///< 0 without triangles
};

/// Encodes the connectivity and watches. Errors and cost as encodeConnectivity(), but O(S L) more for S symbols S and
/// loops of L open edges.
Result<WalkStatistics> walkStatistics(const Connectivity &connectivity, const Progress &progress = Progress());

} // namespace model::codec
