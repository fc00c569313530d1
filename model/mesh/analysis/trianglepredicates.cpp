// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: CGAL's exact predicates (CGAL Project, CGAL User and Reference Manual 5.5, 2D and 3D Linear Geometry
// Kernel)
#include "model/mesh/analysis/trianglepredicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace model {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point(Vec3f p)
{
    return {double(p.x), double(p.y), double(p.z)};
}
Kernel::Triangle_3 triangle(const std::array<Vec3f, 3> &corners)
{
    return {point(corners[0]), point(corners[1]), point(corners[2])};
}

} // namespace

bool areCollinear(const std::array<Vec3f, 3> &corners)
{
    return CGAL::collinear(point(corners[0]), point(corners[1]), point(corners[2]));
}

bool trianglesMeet(const std::array<Vec3f, 3> &a, const std::array<Vec3f, 3> &b)
{
    return CGAL::do_intersect(triangle(a), triangle(b));
}

bool segmentMeetsTriangle(const std::array<Vec3f, 2> &segment, const std::array<Vec3f, 3> &corners)
{
    return CGAL::do_intersect(Kernel::Segment_3(point(segment[0]), point(segment[1])), triangle(corners));
}

bool foldsOver(Vec3f a, Vec3f b, Vec3f p, Vec3f q)
{
    return CGAL::coplanar(point(a), point(b), point(p), point(q)) &&
           CGAL::coplanar_orientation(point(a), point(b), point(p), point(q)) == CGAL::POSITIVE;
}

} // namespace model
