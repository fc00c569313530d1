// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/analysis/facelinks.h"

namespace model {

/// The border edges that follow one another around one hole. At a vertex where the surface touches itself a loop stays
/// with its fan, so that it is what is left when the vertex is split.
struct BorderLoop
{
    std::vector<std::uint32_t> sides; ///< in the order of the loop, whichever way the faces are wound
    /// Where each of them starts, #sides. A loop that is not closed has its last end too.
    std::vector<std::uint32_t> vertices;
    /// It comes back to where it started. If not, crowded edges break it: then `sides` is all chains that end at the
    /// same ones, and `vertices` their vertices one chain after the other.
    bool isClosed = true;
};

/// All of them, in the order of their first sides; the loop runs along that side. Linear time.
std::vector<BorderLoop> findBorderLoops(const FaceLinks &links);

} // namespace model
