// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tinwriter.h"

namespace model::terrain {

/// What a straight line from one vertex to another meets first.
struct SegmentStep
{
    enum class Kind : std::uint8_t {
        Edge,     ///< it runs along an edge, to `end`
        Crossing, ///< it crosses edges that are not constrained, from `edge` on, and then meets the vertex `end`
        Blocked,  ///< it crosses the constrained edge `edge`
    };

    Kind kind;
    VertexId end = None; ///< the first vertex on the line
    Corner edge =
        NoCorner; ///< Edge: the corner of that edge. Crossing: the first edge crossed, its corner at the start
};

/// What a line may not cross.
enum class Obstacles : std::uint8_t { Constraints, Voids };

/// Walks from `a` towards `b` until the first vertex or obstacle. Exact.
/// \param obstacles  Constraints: every constrained edge; Voids: only edges between void and other triangles
SegmentStep stepTowards(const TinArrays &tin, VertexId a, VertexId b, Obstacles obstacles = Obstacles::Constraints);

/// Makes the line from `a` to `step.end` an edge, by filling the two polygons that the triangles along it leave on
/// either side. The edge is returned, by a corner, and not yet constrained. No other edge that obeyed the circle rule
/// is lost. Precondition: `step` is a Crossing, found from `a`. Cost: O(k log k) for k triangles on random ground,
/// O(k^2) at worst. Source: M. V. Anglada, An Improved Incremental Algorithm for Constructing Restricted Delaunay
/// Triangulations, 1997.
Corner openSegment(TinWriter &writer, VertexId a, const SegmentStep &step);

} // namespace model::terrain
