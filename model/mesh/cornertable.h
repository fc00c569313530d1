// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/trianglemesh.h"

#include <span>
#include <vector>

namespace model {

/// A corner is one vertex of one triangle: corners 3t, 3t + 1, 3t + 2 of triangle t, counter-clockwise.
using Corner = std::uint32_t;
inline constexpr Corner NoCorner = ~Corner(0);

/// Which triangles are neighbours: for each corner its vertex (V) and the corner opposite to it across the edge that it
/// faces (O), NoCorner at a border. 24 bytes for a triangle.
///
/// Invariants: O is its own inverse; two linked triangles name their common edge in opposite directions.
/// Source: J. Rossignac, A. Safonova, A. Szymczak: 3D Compression Made Simple: Edgebreaker on a Corner-Table, 2001.
class CornerTable
{
public:
    CornerTable() = default;
    /// Takes both tables as they are. Precondition: same sizes, a multiple of 3; the invariants above.
    CornerTable(std::uint32_t vertexCount, std::vector<std::uint32_t> vertices, std::vector<Corner> opposites);

    /// The table of any triangle list. Linked are the edges that exactly two triangles share, in opposite directions,
    /// neither of them with a repeated index; all others become border. cutIntoManifold() links more.
    /// Linear time, but for vertices of very many triangles, whose edges are sorted.
    static CornerTable of(const Connectivity &connectivity);

    std::uint32_t vertexCount() const { return mVertexCount; }
    std::uint32_t triangleCount() const { return std::uint32_t(mVertices.size() / 3); }
    std::uint32_t cornerCount() const { return std::uint32_t(mVertices.size()); }
    std::span<const std::uint32_t> vertices() const { return mVertices; }
    std::span<const Corner> opposites() const { return mOpposites; }

    std::uint32_t vertex(Corner c) const { return mVertices[c]; }
    Corner opposite(Corner c) const { return mOpposites[c]; }
    /// The other corners of the same triangle.
    static Corner next(Corner c) { return c % 3 == 2 ? c - 2 : c + 1; }
    static Corner previous(Corner c) { return c % 3 == 0 ? c + 2 : c - 1; }
    /// The neighbour's corner across the edge on the right or left, seen from `c` with its triangle below.
    Corner right(Corner c) const { return mOpposites[next(c)]; }
    Corner left(Corner c) const { return mOpposites[previous(c)]; }
    /// The corner of the same vertex in the next triangle counter-clockwise or clockwise; NoCorner at a border.
    Corner counterClockwise(Corner c) const { return across(mOpposites[next(c)], &CornerTable::next); }
    Corner clockwise(Corner c) const { return across(mOpposites[previous(c)], &CornerTable::previous); }

private:
    static Corner across(Corner opposite, Corner (*step)(Corner))
    {
        return opposite == NoCorner ? NoCorner : step(opposite);
    }

    std::uint32_t mVertexCount = 0;
    std::vector<std::uint32_t> mVertices;
    std::vector<Corner> mOpposites;
};

/// What a corner table is like, as topology counts it.
struct TopologyCounts
{
    std::uint32_t vertices = 0; ///< those that a triangle uses
    std::uint32_t edges = 0;
    std::uint32_t triangles = 0;
    std::uint32_t components = 0; ///< of triangles that are linked
    std::uint32_t borders = 0;    ///< closed loops of border edges

    std::int64_t euler() const { return std::int64_t(vertices) - edges + triangles; }
    /// Of all components together; each handle counts one. Precondition: a manifold, as cutIntoManifold() makes it.
    std::int64_t genus() const { return (2 * std::int64_t(components) - borders - euler()) / 2; }
};
TopologyCounts topologyOf(const CornerTable &table);

/// The border edge after that of `border` along its loop; the triangles lie on the left. Both are corners opposite to
/// border edges. Precondition: the table is a manifold.
Corner nextBorder(const CornerTable &table, Corner border);

} // namespace model
