// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that includes CGAL: it takes 10 s to compile and wants -frounding-math.
#include "model/terrain/tin/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace model::terrain::exact {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 cgal(Point2 p)
{
    return {p.x, p.y};
}

} // namespace

int orientation(Point2 a, Point2 b, Point2 c)
{
    return int(CGAL::orientation(cgal(a), cgal(b), cgal(c)));
}

int inCircle(Point2 a, Point2 b, Point2 c, Point2 d)
{
    return int(CGAL::side_of_oriented_circle(cgal(a), cgal(b), cgal(c), cgal(d)));
}

} // namespace model::terrain::exact
