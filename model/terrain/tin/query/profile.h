// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tin.h"

#include <optional>
#include <span>
#include <vector>

namespace model::terrain {

/// Where a cross-section bends.
struct ProfilePoint
{
    double distance = 0;      ///< from the section's first point, in metres on the map
    double height = 0;        ///< metres
    bool isVoidAfter = false; ///< there is no ground from here to the next point
};

/// The surface above the straight line from `a` to `b`: a point wherever the line crosses an edge or meets a vertex,
/// and at both ends; between them the surface is straight. Where the line leaves the domain, the section ends.
///
/// Empty if the line misses the domain or if `a` is `b`. Exact: which triangles it passes does not depend on rounding.
/// Cost: O(triangles passed).
std::vector<ProfilePoint> profile(const Tin &tin, Point2 a, Point2 b);

/// The height at a distance along a profile; nothing beyond its ends and over a void.
std::optional<double> heightAt(std::span<const ProfilePoint> profile, double distance);

} // namespace model::terrain
