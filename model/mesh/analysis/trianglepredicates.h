// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/geometry/vec.h"

#include <array>

namespace model {

// Exact answers about triangles with corners in float.

bool areCollinear(const std::array<Vec3f, 3> &corners);
/// Whether they have a point in common. Precondition: neither is collinear.
bool trianglesMeet(const std::array<Vec3f, 3> &a, const std::array<Vec3f, 3> &b);
/// Precondition: the triangle is not collinear, the segment not a point.
bool segmentMeetsTriangle(const std::array<Vec3f, 2> &segment, const std::array<Vec3f, 3> &triangle);
/// Whether the triangles (a, b, p) and (a, b, q) lie in one plane, on the same side of their common edge.
bool foldsOver(Vec3f a, Vec3f b, Vec3f p, Vec3f q);

} // namespace model
