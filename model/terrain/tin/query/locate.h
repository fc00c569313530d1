// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tinarrays.h"

namespace model::terrain {

/// Where a point lies in a TIN. It depends on the point and the TIN alone, not on where the search began.
struct Location
{
    enum class Kind : std::uint8_t { Vertex, Edge, Triangle };

    Kind kind = Kind::Triangle;
    /// Vertex: the vertex' own corner. Edge: the corner whose edge it is, in the triangle with the smaller number.
    /// Triangle: corner 0.
    Corner corner = NoCorner;

    friend constexpr bool operator==(const Location &, const Location &) = default;
};

/// Walks from `start` along the straight line to `p` through the triangles between them. Exact; ends in any
/// triangulation, which a walk by visibility does not in a constrained one.
///
/// Precondition: `p` lies in the domain; `start` is a vertex.
/// Cost: one orientation for each triangle passed and one or two for each edge looked at.
/// Source: O. Devillers, S. Pion, M. Teillaud, Walking in a Triangulation, 2002. Differs: vertices on the line count as
/// on its right, and along the border the walk starts again from the vertex it meets.
Location locate(const TinArrays &tin, Point2 p, VertexId start);

/// What locate() returns if `p` lies in the triangle `t`, or on its border.
Location locationIn(const TinArrays &tin, Point2 p, TriangleId t);

/// The corner at `q` whose triangle the ray from `q` to `p` enters: next(corner) on the right of the ray or on it,
/// previous(corner) on the left. If the ray runs along the border with the TIN on its right, there is no such triangle:
/// then it is the last one, with previous(corner) on the ray, and `isAlongBorder` is set.
/// Precondition: `p` lies in the domain and is not the point of `q`.
struct Wedge
{
    Corner corner;
    bool isAlongBorder;
};
Wedge wedgeTowards(const TinArrays &tin, VertexId q, Point2 p);

} // namespace model::terrain
