// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tools/imprint.h"
#include "model/terrain/tools/lines.h"
#include "model/terrain/tools/sculpt.h"

#include <variant>

namespace model::terrain {

/// What a stroke is drawn with.
using Tool =
    std::variant<Imprint, Rake, Raise, Lower, Flatten, Smooth, Noise, Ramp, Restore, Pour, Scoop, Breakline, Moisten>;

/// The tool's name in scripts and logs: "imprint", "rake", ...
const char *nameOf(const Tool &tool);

/// A tool drawn along a path. Stamps lie at distances that depend on the tool: how often the pen was sampled changes
/// nothing. Ramp goes from the path's first point to its last, Breakline along its corners.
struct Stroke
{
    Tool tool;
    std::vector<PathPoint> path;
    Symmetry symmetry;
};

/// What a stroke did. Volumes in cubic metres, at least 0.
struct StrokeReport
{
    std::uint32_t stamps = 0;
    double added = 0, removed = 0; ///< as the ledger has them; what Scoop took is `removed`
    double moved = 0;
    double compressed = 0; ///< Imprint: what was pressed together, and not removed: its mass is still there
    OwnerId nextOwner = 0; ///< the first one that no constraint of the stroke has
};

struct DoneStroke
{
    Edit edit;
    StrokeReport report;
};

/// \error BadSetting  a setting outside its range
Result<void> check(const Tool &tool);
/// \error BadSetting, NonFinite, LimitExceeded  as the tool, the path and the symmetry say
Result<void> check(const Stroke &stroke);

/// Draws a stroke: one edit. A stroke that misses the terrain makes an empty one.
///
/// \param tin     as it was if there is an error
/// \param owner   of the first stamp's constraints, the next ones follow; None: one that is free, which costs O(all
///                constraints)
/// \param memory  keep it from stroke to stroke: what is made anew costs O(n)
/// \error BadSetting, NonFinite, LimitExceeded  as check() says
/// \error CrossingConstraints  a breakline that meets what it may not cross
Result<DoneStroke> draw(Tin &tin, const Stroke &stroke, OwnerId owner, ToolMemory &memory);
Result<DoneStroke> draw(Tin &tin, const Stroke &stroke, OwnerId owner = None);

/// The same within an edit that is open, with other strokes before and after. On error the edit has to be rolled back.
/// Leaves nothing of leak(): the volume that the surface gained by being divided anew is given back. LiveStroke draws
/// while the path still grows.
Result<StrokeReport> draw(TinEdit &edit, const Stroke &stroke, OwnerId owner, ToolMemory &memory);

/// The first owner above all that hold a constraint. Cost: O(all constraints).
OwnerId nextFreeOwner(const Tin &tin);

/// What an edit changed that is still there, ascending: vertices with a new height or new triangles, and the triangles
/// around them. Erosion starts there.
struct Touched
{
    std::vector<VertexId> vertices;
    std::vector<TriangleId> triangles;
};
Touched touchedBy(const Tin &tin, const Edit &edit);

} // namespace model::terrain
