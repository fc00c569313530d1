// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/analysis/facelinks.h"

namespace model {

/// Which faces hang together by edges, and how they are wound.
struct MeshParts
{
    std::vector<std::uint32_t> componentOf; ///< #F; components are numbered in the order of their first faces
    /// #F, 1 where a face is wound against most of those that it hangs together with over edges of two sides. Where
    /// there is no consistent winding, that of a walk from the first face.
    std::vector<std::uint8_t> isTurned;
    std::vector<std::uint8_t> isOrientable; ///< #components: looking at edges of two sides only
    std::uint32_t componentCount() const { return std::uint32_t(isOrientable.size()); }
};

/// Linear time.
MeshParts findParts(const FaceLinks &links);

} // namespace model
