// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/ids.h"

#include <cmath>

namespace model::terrain {

/// Coordinates whose size is above this are refused where a terrain is built; the filters below count on it.
inline constexpr double LargestCoordinate = 1e12;

namespace exact {

/// CGAL's predicates, exact and slow; predicates.h calls them where double precision cannot tell.
int orientation(Point2 a, Point2 b, Point2 c);
int inCircle(Point2 a, Point2 b, Point2 c, Point2 d);

} // namespace exact

// The filters are the A stages of J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust
// Geometric Predicates, 1997: with e = 2^-53, the error of the determinant is at most (3 + 16 e) e, or (10 + 96 e) e,
// times the sum of the sizes of its terms. His proof leaves out underflow; an underflowing operation is wrong by up to
// 2^-1075, which later factors, squared differences of LargestCoordinate at most, take to 1e-298. FilterFloor is far
// above that.
inline constexpr double RoundingUnit = 0x1p-53;
inline constexpr double OrientationFilter = (3 + 16 * RoundingUnit) * RoundingUnit;
inline constexpr double InCircleFilter = (10 + 96 * RoundingUnit) * RoundingUnit;
inline constexpr double FilterFloor = 1e-290;

/// 1 if `c` lies left of the line from `a` to `b`, -1 if right, 0 if on it. Exact.
inline int orientation(Point2 a, Point2 b, Point2 c)
{
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double determinant = left - right;
    const double bound = OrientationFilter * (std::abs(left) + std::abs(right)) + FilterFloor;
    if (determinant > bound)
        return 1;
    if (-determinant > bound)
        return -1;
    return exact::orientation(a, b, c);
}

/// 1 if `d` lies inside the circle through `a`, `b`, `c` (counter-clockwise), -1 if outside, 0 if on it. Exact.
inline int inCircle(Point2 a, Point2 b, Point2 c, Point2 d)
{
    const double adx = a.x - d.x, ady = a.y - d.y;
    const double bdx = b.x - d.x, bdy = b.y - d.y;
    const double cdx = c.x - d.x, cdy = c.y - d.y;
    const double bdxcdy = bdx * cdy, cdxbdy = cdx * bdy, alift = adx * adx + ady * ady;
    const double cdxady = cdx * ady, adxcdy = adx * cdy, blift = bdx * bdx + bdy * bdy;
    const double adxbdy = adx * bdy, bdxady = bdx * ady, clift = cdx * cdx + cdy * cdy;
    const double determinant = alift * (bdxcdy - cdxbdy) + blift * (cdxady - adxcdy) + clift * (adxbdy - bdxady);
    const double sizes = (std::abs(bdxcdy) + std::abs(cdxbdy)) * alift + (std::abs(cdxady) + std::abs(adxcdy)) * blift +
                         (std::abs(adxbdy) + std::abs(bdxady)) * clift;
    const double bound = InCircleFilter * sizes + FilterFloor;
    if (determinant > bound)
        return 1;
    if (-determinant > bound)
        return -1;
    return exact::inCircle(a, b, c, d);
}

/// The tie rule: which side of the circle through `a`, `b`, `c` a point `d` on it is taken to be. 1 inside, -1 outside.
int cocircularSide(Point2 a, Point2 b, Point2 c, Point2 d);

/// inCircle with ties broken, never 0: with it, the Delaunay triangulation of any points is unique.
inline bool isInsideCircle(Point2 a, Point2 b, Point2 c, Point2 d)
{
    const int side = inCircle(a, b, c, d);
    return side != 0 ? side > 0 : cocircularSide(a, b, c, d) > 0;
}

} // namespace model::terrain
