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

/// Stamps along a path at distances that depend on `spacing` alone, as the path goes on: points added on the lines of a
/// path change nothing, nor how many are given at a time. Positions are rounded to about 1e-9 of the spacing, so that
/// this is so to the last bit but for rare ties.
class PathSampler
{
public:
    /// \error BadSetting  a spacing that is not above 0
    /// \param most  stamps, at least 1
    static Result<PathSampler> create(double spacing, std::size_t most = LargestStampCount);

    /// The path goes on to `point`. Precondition: end() was not called.
    /// \error BadSetting     pressure outside 0 ... 1, negative speed, a coordinate beyond LargestCoordinate
    /// \error NonFinite      what is no number (the point's index in the error)
    /// \error LimitExceeded  more than `most` stamps; as all errors, it leaves the path as it was
    Result<void> add(const PathPoint &point);
    /// The path ends where it is.
    void end();

    /// All stamps so far.
    std::span<const StampPose> poses() const { return mPoses; }
    /// How many of them have their direction: all but the last, which has it when the path ends.
    std::size_t settledCount() const { return mIsEnded ? mPoses.size() : mPoses.size() - !mPoses.empty(); }

private:
    PathSampler(double spacing, std::size_t most);
    StampPose poseAt(double along) const;
    void append(const StampPose &pose);

    double mSpacing, mQuantum;
    std::size_t mMost;
    std::vector<StampPose> mPoses;
    std::size_t mPoints = 0;
    bool mIsEnded = false;
    PathPoint mFrom, mTo;              ///< the last piece of the path that has a length
    double mAlongFrom = 0, mAlong = 0; ///< the length of the path there
};

/// The stamps of a whole path, from PathSampler. \returns at least one pose, the first at the start of the path
/// \error BadSetting  an empty path; or as PathSampler says
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
