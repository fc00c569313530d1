// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/geometry/vec3d.h"
#include "model/haptics/time.h"

#include <string_view>
#include <vector>

namespace model::haptics {

/// Where a hand goes: straight from point to point.
class Trajectory
{
public:
    struct Point
    {
        double time = 0; ///< seconds from its beginning, ascending
        Vec3d position;  ///< metres of the hand
        std::uint32_t buttons = 0;
    };

    Trajectory() = default;
    /// Precondition: times ascend.
    explicit Trajectory(std::vector<Point> points)
        : mPoints(std::move(points))
    {}

    bool isEmpty() const { return mPoints.empty(); }
    double duration() const { return mPoints.empty() ? 0 : mPoints.back().time; }
    /// Before the first point the first, after the last the last; buttons as at the point before. No allocation.
    /// Precondition: it is not empty.
    Point at(double time) const;
    const std::vector<Point> &points() const { return mPoints; }

private:
    std::vector<Point> mPoints;
};

/// One point a line: `seconds x y z [buttons]`; `#` begins a comment.
/// \error SyntaxError    a line that is none (its number in the error)
/// \error BadValue       a time before the one before it, a position beyond 10 m
/// \error LimitExceeded  more than a million points
Result<Trajectory> parseTrajectory(std::string_view text);

/// Down into the ground at the origin, held, pushed sideways, held, and out: what the recorded sessions do.
Trajectory pressTrajectory();

} // namespace model::haptics
