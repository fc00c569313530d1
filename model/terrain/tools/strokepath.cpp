// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/strokepath.h"

#include "model/base/numbertext.h"
#include "model/terrain/tin/predicates.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace model::terrain {

namespace {

/// Positions are multiples of the spacing's power of two times this.
constexpr double Quantum = 0x1p-30;
constexpr std::uint32_t MostRadialCopies = 64;

Point2 rotated(Point2 p, double cosine, double sine)
{
    return {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y};
}

Result<void> checkPoint(const PathPoint &p, std::size_t i)
{
    if (!std::isfinite(p.at.x) || !std::isfinite(p.at.y) || !std::isfinite(p.pressure) || !std::isfinite(p.speed))
        return fail(ErrorCode::NonFinite, "path point " + std::to_string(i));
    if (std::abs(p.at.x) > LargestCoordinate || std::abs(p.at.y) > LargestCoordinate)
        return fail(ErrorCode::BadSetting, "path", "point " + std::to_string(i), "coordinates up to 1e12");
    if (p.pressure < 0 || p.pressure > 1)
        return fail(ErrorCode::BadSetting, "pressure", std::to_string(p.pressure), "0 ... 1");
    if (p.speed < 0)
        return fail(ErrorCode::BadSetting, "speed", std::to_string(p.speed), "at least 0");
    return {};
}

} // namespace

Result<void> checkPath(std::span<const PathPoint> path)
{
    if (path.empty())
        return fail(ErrorCode::BadSetting, "path", "no points", "at least one point");
    for (std::size_t i = 0; i < path.size(); ++i)
        if (Result<void> checked = checkPoint(path[i], i); !checked)
            return checked;
    return {};
}

PathSampler::PathSampler(double spacing, std::size_t most)
    : mSpacing(spacing)
    , mQuantum(std::exp2(std::floor(std::log2(spacing))) * Quantum)
    , mMost(most)
{}

Result<PathSampler> PathSampler::create(double spacing, std::size_t most)
{
    if (!(spacing > 0) || !std::isfinite(spacing))
        return fail(ErrorCode::BadSetting, "spacing", numberText(spacing), "above 0");
    return PathSampler(spacing, most);
}

StampPose PathSampler::poseAt(double along) const
{
    const auto rounded = [&](double value) {
        const double multiple = std::nearbyint(value / mQuantum);
        return std::abs(multiple) < 0x1p52 ? multiple * mQuantum : value;
    };
    const double length = mAlong - mAlongFrom;
    const double t = length > 0 ? std::clamp((along - mAlongFrom) / length, 0.0, 1.0) : 0;
    const auto mixed = [&](double from, double to) { return from + t * (to - from); };
    return {{rounded(mixed(mFrom.at.x, mTo.at.x)), rounded(mixed(mFrom.at.y, mTo.at.y))},
            {},
            std::nearbyint(mixed(mFrom.pressure, mTo.pressure) / Quantum) * Quantum,
            std::nearbyint(mixed(mFrom.speed, mTo.speed) / Quantum) * Quantum,
            false};
}

/// Directions are those of the stamps themselves, not of the path, whose corners may lie anywhere between them: from
/// the stamp before to the one after.
void PathSampler::append(const StampPose &pose)
{
    mPoses.push_back(pose);
    const std::size_t last = mPoses.size() - 1;
    for (std::size_t k = last == 0 ? 0 : last - 1; k <= last; ++k) {
        const Point2 from = mPoses[k == 0 ? 0 : k - 1].at, to = mPoses[std::min(k + 1, last)].at;
        const double length = std::hypot(to.x - from.x, to.y - from.y);
        if (length > 0)
            mPoses[k].direction = {(to.x - from.x) / length, (to.y - from.y) / length};
        else if (k > 0)
            mPoses[k].direction = mPoses[k - 1].direction;
    }
}

Result<void> PathSampler::add(const PathPoint &point)
{
    assert(!mIsEnded);
    if (Result<void> checked = checkPoint(point, mPoints); !checked)
        return checked;
    if (mPoints == 0) {
        mFrom = mTo = point;
        append(poseAt(0));
        ++mPoints;
        return {};
    }
    const double step = std::hypot(point.at.x - mTo.at.x, point.at.y - mTo.at.y), along = mAlong + step;
    const double count = std::floor(along / mSpacing);
    if (!(count < double(mMost)))
        return fail(ErrorCode::LimitExceeded, "number of stamps", numberText(count), std::to_string(mMost));
    ++mPoints;
    if (along == mAlong) { // the pen stands, and is pressed harder or less
        mTo = point;
        return {};
    }
    mFrom = mTo;
    mTo = point;
    mAlongFrom = mAlong;
    mAlong = along;
    for (double next = double(mPoses.size()) * mSpacing; next <= mAlong; next = double(mPoses.size()) * mSpacing)
        append(poseAt(next));
    return {};
}

void PathSampler::end()
{
    // A path as long as a multiple of the spacing ends with a stamp, whichever way its length was rounded.
    if (mAlong > 0 && mPoses.size() < mMost && double(mPoses.size()) <= std::floor(mAlong / mSpacing + 1e-6))
        append(poseAt(mAlong));
    mIsEnded = true;
}

Result<std::vector<StampPose>> resample(std::span<const PathPoint> path, double spacing)
{
    if (const Result<void> checked = checkPath(path); !checked)
        return fail(checked.error());
    auto sampler = PathSampler::create(spacing);
    if (!sampler)
        return fail(sampler.error());
    for (const PathPoint &point : path)
        if (const Result<void> added = sampler->add(point); !added)
            return fail(added.error());
    sampler->end();
    return std::vector<StampPose>(sampler->poses().begin(), sampler->poses().end());
}

Result<void> Symmetry::check() const
{
    if (!std::isfinite(centre.x) || !std::isfinite(centre.y))
        return fail(ErrorCode::NonFinite, "centre of symmetry");
    if (kind == Kind::Radial && (copies < 1 || copies > MostRadialCopies))
        return fail(ErrorCode::BadSetting, "copies", std::to_string(copies), "1 ... 64");
    return {};
}

std::uint32_t Symmetry::count() const
{
    switch (kind) {
    case Kind::Off:
        return 1;
    case Kind::MirrorX:
    case Kind::MirrorY:
        return 2;
    case Kind::MirrorBoth:
        return 4;
    case Kind::Radial:
        return copies;
    }
    return 1;
}

Point2 Symmetry::copyOf(Point2 p, std::uint32_t i) const
{
    if (i == 0)
        return p;
    if (kind == Kind::Radial) {
        const double angle = 2 * M_PI * i / copies;
        const Point2 turned = rotated({p.x - centre.x, p.y - centre.y}, std::cos(angle), std::sin(angle));
        return {centre.x + turned.x, centre.y + turned.y};
    }
    const bool isX = kind == Kind::MirrorX || (kind == Kind::MirrorBoth && (i & 1));
    const bool isY = kind == Kind::MirrorY || (kind == Kind::MirrorBoth && (i & 2));
    return {isX ? 2 * centre.x - p.x : p.x, isY ? 2 * centre.y - p.y : p.y};
}

StampPose Symmetry::copyOf(const StampPose &pose, std::uint32_t i) const
{
    StampPose copy = pose;
    copy.at = copyOf(pose.at, i);
    const Symmetry around{kind, {0, 0}, copies};
    copy.direction = around.copyOf(pose.direction, i);
    copy.isMirrored = i > 0 && kind != Kind::Radial && !(kind == Kind::MirrorBoth && i == 3);
    return copy;
}

} // namespace model::terrain
