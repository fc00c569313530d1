// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/terrain/tin/ids.h"

#include <span>
#include <vector>

namespace model::terrain {

/// The most stamps of one stroke, its mirrored copies included.
inline constexpr std::size_t LargestStampCount = 100000;

/// Where the pen was.
struct PathPoint
{
    Point2 at;
    double pressure = 1; ///< 0 ... 1
    double speed = 0;    ///< metres a second, at least 0; 0 if nobody measured it

    friend bool operator==(const PathPoint &, const PathPoint &) = default;
};

/// Where and how a tool is pressed in.
struct StampPose
{
    Point2 at;
    Point2 direction; ///< of the motion, of length 1; 0, 0 if the pen stands still
    double pressure = 1;
    double speed = 0;
    bool isMirrored = false; ///< the outline is that of a tool seen in a mirror
};

/// Stamps along a path at distances that depend on `spacing` alone: points added on the lines of a path change nothing.
/// Positions are rounded to about 1e-9 of the spacing, so that this is so to the last bit but for rare ties.
/// \returns  at least one pose, the first at the start of the path
/// \error BadSetting     an empty path, a spacing that is not above 0, pressure outside 0 ... 1, negative speed
/// \error NonFinite      a point that is no number (its index in the error)
/// \error LimitExceeded  more stamps than LargestStampCount
Result<std::vector<StampPose>> resample(std::span<const PathPoint> path, double spacing);

/// The path must be one that resample() takes.
Result<void> checkPath(std::span<const PathPoint> path);

/// Copies of a stroke that are drawn along with it.
struct Symmetry
{
    enum class Kind : std::uint8_t {
        Off,
        MirrorX, ///< x becomes its mirror image at the centre
        MirrorY,
        MirrorBoth, ///< four in all
        Radial,     ///< `copies` in all, turned around the centre
    };
    Kind kind = Kind::Off;
    Point2 centre;
    std::uint32_t copies = 2; ///< Radial: 1 ... 64

    /// \error BadSetting  the number of copies, or the centre
    Result<void> check() const;
    /// How many there are in all.
    std::uint32_t count() const;
    /// The pose of copy `i`; 0 is the stroke itself.
    StampPose copyOf(const StampPose &pose, std::uint32_t i) const;
    Point2 copyOf(Point2 p, std::uint32_t i) const;

    friend bool operator==(const Symmetry &, const Symmetry &) = default;
};

} // namespace model::terrain
