// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace model::terrain {

using VertexId = std::uint32_t;
using TriangleId = std::uint32_t;
/// Who put a constraint there: the number of a stamp, breakline or import.
using OwnerId = std::uint32_t;

/// No vertex, no triangle, no record.
inline constexpr std::uint32_t None = ~std::uint32_t(0);

/// Owner of the edges between void triangles and the terrain.
inline constexpr OwnerId VoidOwner = None - 1;

/// A corner is one vertex of one triangle: corners 4t, 4t + 1, 4t + 2 of triangle t, counter-clockwise. It also names
/// the edge of its triangle that it does not touch.
using Corner = std::uint32_t;
/// Across the border: no triangle, and the edge is constrained. See Opposite.
inline constexpr Corner NoCorner = 0x7fffffff;

constexpr TriangleId triangleOf(Corner c)
{
    return c >> 2;
}
constexpr Corner cornerOf(TriangleId t, std::uint32_t i)
{
    return 4 * t + i;
}
constexpr Corner next(Corner c)
{
    return (c & 3) == 2 ? c - 2 : c + 1;
}
constexpr Corner previous(Corner c)
{
    return (c & 3) == 0 ? c + 2 : c - 1;
}
/// Where the corner lies in arrays of three values for each triangle.
constexpr std::size_t slotOf(Corner c)
{
    return c - (c >> 2);
}

/// A point of the ground plane, in metres from the terrain's local origin, x east, y north.
struct Point2
{
    double x = 0, y = 0;

    friend constexpr bool operator==(const Point2 &, const Point2 &) = default;
};

struct Point3
{
    double x = 0, y = 0, z = 0;
};

/// The domain of a terrain.
struct Rectangle
{
    Point2 low, high;

    constexpr bool contains(Point2 p) const { return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y; }
    friend constexpr bool operator==(const Rectangle &, const Rectangle &) = default;
};

} // namespace model::terrain
