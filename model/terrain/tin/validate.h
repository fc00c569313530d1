// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tin.h"

namespace model::terrain {

/// The rules that hold between any two calls of a TIN.
enum class TinRule : std::uint8_t {
    Links,        ///< two triangles name each other across the same edge, with the same constrained bit
    Orientation,  ///< triangles are counter-clockwise and have an area
    VertexCorner, ///< a vertex in use has a corner at itself, and only such vertices are used
    EmptyCircle,  ///< no edge but a constrained one violates the circle rule, ties broken by isInsideCircle()
    Border,       ///< the border is constrained, runs along the domain, once around, and the corners are vertices
    Euler,        ///< triangles = 2 vertices - border edges - 2
    Constraint,   ///< each record lies on a constrained edge, and each constrained edge inside has a record
    RecordList,   ///< each record in use hangs in the lists of its two vertices, once
    VoidBorder,   ///< the edges between void and other triangles are VoidOwner's, and only they
    FreeList,     ///< free slots are in their list, once, and look as free slots do; counts agree
    Height,       ///< heights are finite
    Layers,       ///< no more layers than MaxLayers, and values for each at each vertex
    Thickness,    ///< thicknesses are finite and at least 0
    Humidity,     ///< humidities are 0 ... 1
};

/// For messages and logs; not translated.
const char *nameOf(TinRule rule);

/// A rule that is broken, and where: ids of what the rule is about, None where it has fewer.
struct TinDefect
{
    TinRule rule;
    std::uint32_t ids[3] = {None, None, None};
};

/// All broken rules, up to `limit`. Checks everything that TinRule lists. Cost: O(n).
std::vector<TinDefect> findDefects(const Tin &tin, std::size_t limit = 16);

/// The same of the arrays of a TIN, for those that have nothing but them.
std::vector<TinDefect> findDefects(const TinArrays &tin, const Rectangle &domain, std::size_t limit = 16);

/// \error BrokenTerrain  args: the name of the first rule that is broken, and the ids
Result<void> validate(const Tin &tin);

} // namespace model::terrain
