// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: O. Devillers, M. Teillaud: Perturbations and Vertex Removal in a 3D Delaunay Triangulation, 2003, in the
// plane as CGAL 5.5 does it in Triangulation_2::side_of_oriented_circle.
#include "model/terrain/tin/predicates.h"

#include <algorithm>
#include <array>

namespace model::terrain {

int cocircularSide(Point2 a, Point2 b, Point2 c, Point2 d)
{
    // Lift points to the paraboloid and raise each by an infinitesimal, the larger the later it comes in lexicographic
    // order: the sign is that of the first cofactor, from the last point on, that is not zero.
    std::array<int, 4> order{0, 1, 2, 3};
    const std::array<Point2, 4> points{a, b, c, d};
    std::sort(order.begin(), order.end(), [&](int i, int j) {
        return points[i].x != points[j].x ? points[i].x < points[j].x : points[i].y < points[j].y;
    });
    for (int k = 3; k > 0; --k) {
        int side = 0;
        switch (order[k]) {
        case 0:
            side = orientation(d, b, c);
            break;
        case 1:
            side = orientation(a, d, c);
            break;
        case 2:
            side = orientation(a, b, d);
            break;
        default:
            return -1;
        }
        if (side != 0)
            return side;
    }
    return -1;
}

} // namespace model::terrain
