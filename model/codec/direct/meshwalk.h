// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/trianglemesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace model::codec {

/// The order in which `direct` codes the vertices of a frame, and what is known of each vertex's surroundings when its
/// turn comes. Follows from the connectivity alone; takes any triangles. FORMAT.md 11.2.
class MeshWalk
{
public:
    enum class Order : std::uint8_t {
        File,    ///< as the vertices are numbered
        Growing, ///< next is a vertex with the most neighbours already coded
    };
    /// Two known vertices a, b that share a triangle with the vertex, and the known one behind their edge: the vertex
    /// would complete a parallelogram at a + b - opposite.
    struct Parallelogram
    {
        std::uint32_t a, b, opposite;
    };

    MeshWalk(const Connectivity &connectivity, Order order);

    std::uint32_t vertexCount() const { return std::uint32_t(mOrder.size()); }
    /// The vertex whose turn is at `place`, 0 ... vertexCount() - 1.
    std::uint32_t vertex(std::size_t place) const { return mOrder[place]; }
    /// Its neighbours that are coded before it; the vertex before it in the order if it has none; none for the first.
    std::span<const std::uint32_t> known(std::size_t place) const
    {
        return {mKnown.data() + mFirstKnown[place], mFirstKnown[place + 1] - mFirstKnown[place]};
    }
    std::span<const Parallelogram> parallelograms(std::size_t place) const
    {
        return {mParallelograms.data() + mFirstParallelogram[place],
                mFirstParallelogram[place + 1] - mFirstParallelogram[place]};
    }
    std::size_t memoryBytes() const;

    /// Most bytes that building it takes, and that it keeps among them.
    static std::uint64_t neededBytes(std::uint64_t vertices, std::uint64_t triangles)
    {
        return 32 * vertices + 156 * triangles;
    }

private:
    std::vector<std::uint32_t> mOrder;
    std::vector<std::uint32_t> mFirstKnown; ///< #V + 1, into mKnown
    std::vector<std::uint32_t> mKnown;
    std::vector<std::uint32_t> mFirstParallelogram; ///< #V + 1, into mParallelograms
    std::vector<Parallelogram> mParallelograms;
};

} // namespace model::codec
