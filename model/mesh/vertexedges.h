// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/trianglemesh.h"

#include <array>
#include <span>
#include <vector>

namespace model {

/// Two vertices, the smaller index first.
using Edge = std::array<std::uint32_t, 2>;

/// The edges of a mesh, each once, and which of them meet at each vertex. Any input: an edge of many triangles is one
/// edge, a triangle's edge from a vertex to itself is none.
class VertexEdges
{
public:
    explicit VertexEdges(const Connectivity &connectivity);

    std::uint32_t vertexCount() const { return std::uint32_t(mFirst.size() - 1); }
    /// In ascending order.
    std::span<const Edge> edges() const { return mEdges; }
    /// Indices into edges() of those at a vertex, ascending.
    std::span<const std::uint32_t> at(std::uint32_t vertex) const
    {
        return std::span(mAtVertex).subspan(mFirst[vertex], mFirst[vertex + 1] - mFirst[vertex]);
    }
    std::uint32_t otherEnd(std::uint32_t edge, std::uint32_t vertex) const
    {
        return mEdges[edge][mEdges[edge][0] == vertex ? 1 : 0];
    }

private:
    std::vector<Edge> mEdges;
    std::vector<std::size_t> mFirst;      ///< #V + 1, into mAtVertex
    std::vector<std::uint32_t> mAtVertex; ///< 2 #E
};

/// The edges at a vertex and at each of its neighbours: indices into edges(), ascending, each once.
/// \param found  is filled; a parameter so that its memory is used again
void findEdgesAround(const VertexEdges &edges, std::uint32_t vertex, std::vector<std::uint32_t> &found);

} // namespace model
