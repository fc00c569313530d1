// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tin.h"

#include <optional>

namespace views {

/// A line of sight: `origin + t * direction`, t >= 0, in a terrain's local metres.
struct GroundRay
{
    model::terrain::Point3 origin;
    model::terrain::Point3 direction; ///< not zero
};

/// Where a ray meets the surface from above for the first time; nothing if it misses the terrain. Void triangles are
/// holes. Walks through the triangles below the ray. Cost: one exact orientation for each.
std::optional<model::terrain::Point3> hitOf(const model::terrain::Tin &tin, const GroundRay &ray);

/// Where a ray meets the ground that goes on beyond the terrain's border, level outwards from each place of it (and
/// under voids, at the height of the border nearest to them). Nothing if the ray does not go down.
std::optional<model::terrain::Point3> hitBeyond(const model::terrain::Tin &tin, const GroundRay &ray);

/// The height at the place of the domain nearest to `p`.
double nearestHeight(const model::terrain::Tin &tin, model::terrain::Point2 p);

} // namespace views
