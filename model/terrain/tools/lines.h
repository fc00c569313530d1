// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tools/brush.h"

#include <optional>

namespace model::terrain {

/// A row of tines drawn through the ground: grooves, and between them what came out of the grooves.
struct Rake
{
    double width = 1; ///< metres, across the motion
    std::uint32_t tines = 5;
    double depth = 0.05;   ///< metres below the mean of the ground
    double spacing = 0.25; ///< between stamps, in distances of two tines
    Mask mask;
};

/// One stamp: what the tines take out goes to the ridges between them, exactly. Grooves end at their depth: drawing
/// the rake through them again moves next to nothing.
void stamp(TinEdit &edit, const Rake &tool, const StampPose &pose, ToolMemory &memory);

/// An even slope from the first point of the stroke to the last.
struct Ramp
{
    Brush brush;                    ///< its radius is half the ramp's width
    std::optional<double> from, to; ///< heights of the ends; none: those of the ground there
};

/// The whole ramp at once.
void makeRamp(TinEdit &edit, const Ramp &tool, Point2 from, Point2 to, double pressure, ToolMemory &memory);

/// A line of constrained edges along the path, on the ground or at a height: a ridge, a ditch's edge, a shore.
struct Breakline
{
    double spacing = 0; ///< metres; its edges are divided so that they follow the ground; 0: only the path's corners
    std::optional<double> height; ///< none: on the ground
    Crossing crossing = Crossing::Split;
};

/// Parts of the path outside the domain are left out.
/// \error CrossingConstraints  it meets a constraint that it may not cross; the edit has to be rolled back
Result<void> insertBreakline(TinEdit &edit, const Breakline &tool, std::span<const Point2> path, OwnerId owner);

Result<void> check(const Rake &tool);
Result<void> check(const Ramp &tool);
Result<void> check(const Breakline &tool);

/// The corners of a path: points on the line between their neighbours are left out, as if nobody had sampled them.
std::vector<Point2> cornersOf(std::span<const PathPoint> path);

} // namespace model::terrain
