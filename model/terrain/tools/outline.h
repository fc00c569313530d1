// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/terrain/tin/ids.h"

#include <span>
#include <string_view>
#include <vector>

namespace model::terrain {

/// The most corners that an outline may have: whether it crosses itself is found pair by pair.
inline constexpr std::size_t LargestOutline = 512;

/// The shape of a tool seen from above, around the origin: a simple polygon, convex or not, counter-clockwise, in units
/// of the tool's radius.
class Outline
{
public:
    /// A regular polygon whose corners have distance 1 from the origin. Precondition: at least 3 corners.
    static Outline disc(std::uint32_t corners = 12);
    static Outline square();
    /// A triangle that points along +x, as a plough does.
    static Outline wedge();
    /// Any simple polygon, either way round; points that repeat the one before are left out.
    /// \error BadSetting  fewer than 3 corners or more than LargestOutline, a coordinate that is no number or above
    ///                    1e6, no area, or an outline that crosses or touches itself
    static Result<Outline> polygon(std::vector<Point2> points);

    std::span<const Point2> points() const { return mPoints; }
    /// How far the farthest corner is from the origin.
    double reach() const;

    friend bool operator==(const Outline &, const Outline &) = default;

private:
    explicit Outline(std::vector<Point2> points)
        : mPoints(std::move(points))
    {}

    std::vector<Point2> mPoints;
};

/// Twice the signed area; positive if counter-clockwise.
double doubleAreaOf(std::span<const Point2> polygon);

/// Whether `p` lies in the polygon, by the even-odd rule; on its border either.
bool isInside(std::span<const Point2> polygon, Point2 p);

/// The point of the polygon's border nearest to `p`.
Point2 nearestOnBorder(std::span<const Point2> polygon, Point2 p);

/// Each edge moved to the left by `distance`, corners where neighbours then meet: inwards if counter-clockwise. The
/// result has as many corners; it may cross itself where the polygon is narrower than twice that.
std::vector<Point2> insetOf(std::span<const Point2> polygon, double distance);

/// No two edges touch but neighbours, in their common corner. Cost: O(n^2).
bool isSimple(std::span<const Point2> polygon);

/// The part of a polygon in a rectangle. That of one that is not convex may run back along the rectangle's border.
/// Source: I. Sutherland, G. Hodgman, Reentrant Polygon Clipping, 1974.
std::vector<Point2> clippedTo(const Rectangle &domain, std::span<const Point2> polygon);

} // namespace model::terrain
