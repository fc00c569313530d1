// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/cornertable.h"

namespace model {

/// A triangle list cut into oriented 2-manifolds with border: each edge has at most two triangles, in opposite
/// directions, and the triangles at a vertex are one fan or one ring. Welding the vertices again and turning the
/// flipped triangles gives exactly the triangles that were there.
struct ManifoldCut
{
    /// Triangle t is triangle t of the input: its corners in their order, or with the second and third exchanged if it
    /// is flipped. Vertices below inputVertexCount are those of the input (some may have no triangle); the others are
    /// copies.
    CornerTable corners;
    std::uint32_t inputVertexCount = 0;
    std::vector<std::uint32_t> copied; ///< the input vertex that vertex inputVertexCount + i is a copy of
    std::vector<bool> flipped;         ///< #T, or empty if no triangle is

    std::uint32_t inputVertex(std::uint32_t vertex) const
    {
        return vertex < inputVertexCount ? vertex : copied[vertex - inputVertexCount];
    }
    bool isFlipped(std::uint32_t triangle) const { return !flipped.empty() && flipped[triangle]; }
};

/// Cuts any triangle list. Few cuts are wanted, as each copy of a vertex costs bits:
/// - Where two triangles share an edge in the same direction, one of them is flipped, as far as that can be done for a
///   whole part; a one-sided surface keeps a seam. In each part, the smaller number of triangles is flipped.
/// - Of more than two triangles at an edge, those of opposite directions are linked in pairs, in their order.
/// - A triangle with a repeated index is a part of its own.
/// Precondition: indices below vertexCount, 3 T < 2^32. Linear time, but for vertices of very many triangles.
ManifoldCut cutIntoManifold(const Connectivity &connectivity);

} // namespace model
