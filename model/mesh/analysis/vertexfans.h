// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/analysis/facelinks.h"

namespace model {

inline constexpr std::uint32_t NoFaceCorner = ~std::uint32_t(0);

/// How the faces at each vertex hang together. A *fan* are the corners of a vertex that are joined by edges at it,
/// also by crowded ones.
struct VertexFans
{
    /// A vertex of several fans: the surface touches itself there. Each fan is a list of corners, ascending.
    struct Split
    {
        std::uint32_t vertex;
        std::vector<std::vector<std::uint32_t>> fans;
    };

    std::vector<std::uint32_t> cornerAt; ///< #V, the last corner at each vertex; NoFaceCorner at an isolated one
    std::vector<Split> splits;           ///< by vertex, ascending
};

/// Linear time.
VertexFans findFans(const FaceLinks &links);

} // namespace model
