// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tools/stroke.h"
#include "views/terrain/groundinteraction.h"

namespace views {

/// A tool's outline on the ground at a place, and within it, dashed, a second one as far inside as the tool goes deep:
/// the edge of the sole, were the walls at 45 degrees. Tools without a depth show where they work at half strength.
/// \param metresPerPixel  for tools without a width, which show a mark
std::vector<GroundLine> outlineOf(const model::terrain::Tool &tool, model::terrain::Point2 at, double metresPerPixel);

/// What a ramp or a breakline would be made along, while it is drawn.
GroundLine pathOf(const model::terrain::Tool &tool, std::span<const model::terrain::PathPoint> path);

/// Where the mirrors of a symmetry stand, or between which spokes its copies lie: as far as the terrain goes.
std::vector<GroundLine> axesOf(const model::terrain::Symmetry &symmetry, const model::terrain::Rectangle &domain);

} // namespace views
