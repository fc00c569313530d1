// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/terrain/tin/tinedit.h"

#include <span>
#include <vector>

namespace model::terrain {

/// Splits edges of these triangles until none is longer than `longest`: each time the longest one, in its middle, at
/// the height that the surface has there. Edges of voids stay. Returns the triangles around the new vertices, some of
/// them perhaps twice.
/// Precondition: longest > 0.
/// \param limit     no more new vertices than that
/// \param progress  asked only whether to stop
std::vector<TriangleId> splitLongEdges(TinEdit &edit, std::span<const TriangleId> triangles, double longest,
                                       std::uint32_t limit, std::uint32_t &added,
                                       const Progress &progress = Progress());

/// Longer than this, squared.
bool hasLongEdge(const TinArrays &tin, TriangleId t, double longest);

/// Removes vertices of no use. Afterwards the surface, at every point and not only at vertices, differs from what it
/// was by no more than `error`, and the volume by nothing but rounding.
///
/// A vertex goes if its triangles all lie within `flatAngle` of their mean plane, and if the polygon around it does not
/// rise or fall from that plane by more than half of `error` allows: whatever triangles fill the hole, they and those
/// that were there both lie between the polygon's highest and lowest deviation, so that this range bounds the change,
/// and it is added to what earlier removals did to the same triangles. The other half is for giving the volume back:
/// the mean change over the area that changed is not more than the largest one.
/// \param candidates  may name vertices that cannot be removed, or are none
/// \param progress    asked only whether to stop; the volume is not given back then, and the edit is to be rolled back
/// Source: the angle is that of V. Purchart, 2009, which gives no bound; the bound is derived here.
std::uint32_t removeRedundant(TinEdit &edit, std::span<const VertexId> candidates, double error, double flatAngle,
                              const Progress &progress = Progress());

} // namespace model::terrain
