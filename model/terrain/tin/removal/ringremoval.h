// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tinwriter.h"

namespace model::terrain {

/// What lies inside a ring of edges, and whether it can go all at once.
class RingInside
{
public:
    /// Up to this many vertices of a ring: ears are looked for among all of them.
    static constexpr std::size_t LargestRing = 512;

    /// Looks at what `ring` encloses, counter-clockwise. Nothing goes unless each of its sides is a constrained edge
    /// that it passes once, and inside there is no void, no constrained edge and no vertex with a constraint.
    RingInside(const TinArrays &tin, std::span<const VertexId> ring);

    /// The vertices inside; empty if not all of them can go.
    std::span<const VertexId> vertices() const { return mVertices; }

    /// Takes vertices() away and triangulates the ring. The same as removing one after the other, at the cost of the
    /// ring instead of that of each vertex' neighbours.
    void remove(TinWriter &writer);

private:
    struct Side
    {
        VertexId from;
        Corner outer; ///< beyond the edge to the next one, with its constrained bit
        std::uint32_t before, after;
    };

    bool collect(const TinArrays &tin);
    void fill(TinWriter &writer);
    bool isEar(const TinArrays &tin, std::uint32_t side) const;

    std::vector<Side> mSides;
    std::vector<TriangleId> mTriangles;
    std::vector<VertexId> mVertices;
};

} // namespace model::terrain
