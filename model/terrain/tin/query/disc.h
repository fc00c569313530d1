// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/slotmarks.h"
#include "model/terrain/tin/tin.h"

#include <vector>

namespace model::terrain {

/// Finds what lies under a disc: a brush, a stamp. Keep one for many searches: it holds a mark for each triangle and
/// vertex, cleared again after each search at the cost of what was found.
class DiscSearch
{
public:
    /// Finds the triangles that touch the disc, void ones too, and the vertices in it. Distances are rounded; a
    /// triangle or vertex just at the rim may be found or not. Precondition: `radius` is at least 0; `near` is a
    /// vertex, or None.
    void search(const Tin &tin, Point2 centre, double radius, VertexId near = None);

    /// By breadth from the centre.
    std::span<const TriangleId> triangles() const { return mTriangles; }
    std::span<const VertexId> vertices() const { return mVertices; }

private:
    std::vector<TriangleId> mTriangles;
    std::vector<VertexId> mVertices;
    std::vector<VertexId> mLookedAt;
    SlotMarks mTriangleMarks, mVertexMarks;
};

} // namespace model::terrain
