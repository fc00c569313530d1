// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/strokepath.h"

#include "model/base/numbertext.h"
#include "model/terrain/tin/predicates.h"

#include <algorithm>
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

} // namespace

Result<void> checkPath(std::span<const PathPoint> path)
{
    if (path.empty())
        return fail(ErrorCode::BadSetting, "path", "no points", "at least one point");
    for (std::size_t i = 0; i < path.size(); ++i) {
        const PathPoint &p = path[i];
        if (!std::isfinite(p.at.x) || !std::isfinite(p.at.y) || !std::isfinite(p.pressure) || !std::isfinite(p.speed))
            return fail(ErrorCode::NonFinite, "path point " + std::to_string(i));
        if (std::abs(p.at.x) > LargestCoordinate || std::abs(p.at.y) > LargestCoordinate)
            return fail(ErrorCode::BadSetting, "path", "point " + std::to_string(i), "coordinates up to 1e12");
        if (p.pressure < 0 || p.pressure > 1)
            return fail(ErrorCode::BadSetting, "pressure", std::to_string(p.pressure), "0 ... 1");
        if (p.speed < 0)
            return fail(ErrorCode::BadSetting, "speed", std::to_string(p.speed), "at least 0");
    }
    return {};
}

Result<std::vector<StampPose>> resample(std::span<const PathPoint> path, double spacing)
{
    if (const Result<void> checked = checkPath(path); !checked)
        return fail(checked.error());
    if (!(spacing > 0) || !std::isfinite(spacing))
        return fail(ErrorCode::BadSetting, "spacing", numberText(spacing), "above 0");
    std::vector<double> along{0};
    for (std::size_t i = 1; i < path.size(); ++i)
        along.push_back(along.back() + std::hypot(path[i].at.x - path[i - 1].at.x, path[i].at.y - path[i - 1].at.y));
    // A path as long as a multiple of the spacing ends with a stamp, whichever way its length was rounded.
    const double steps = std::floor(along.back() / spacing + 1e-6);
    if (!(steps < double(LargestStampCount)))
        return fail(ErrorCode::LimitExceeded, "number of stamps", numberText(steps), std::to_string(LargestStampCount));
    const double quantum = std::exp2(std::floor(std::log2(spacing))) * Quantum;
    const auto rounded = [&](double value) {
        const double multiple = std::nearbyint(value / quantum);
        return std::abs(multiple) < 0x1p52 ? multiple * quantum : value;
    };
    std::vector<StampPose> poses;
    std::size_t segment = 1;
    for (std::size_t k = 0; k <= std::size_t(steps); ++k) {
        const double s = std::min(double(k) * spacing, along.back());
        while (segment + 1 < path.size() && along[segment] < s)
            ++segment;
        if (path.size() == 1 || along.back() == 0) {
            poses.push_back({path[0].at, {}, path[0].pressure, path[0].speed, false});
            break;
        }
        const PathPoint &a = path[segment - 1], &b = path[segment];
        const double length = along[segment] - along[segment - 1];
        const double t = length > 0 ? std::clamp((s - along[segment - 1]) / length, 0.0, 1.0) : 0;
        const auto mixed = [&](double from, double to) { return from + t * (to - from); };
        poses.push_back({{rounded(mixed(a.at.x, b.at.x)), rounded(mixed(a.at.y, b.at.y))},
                         {},
                         std::nearbyint(mixed(a.pressure, b.pressure) / Quantum) * Quantum,
                         std::nearbyint(mixed(a.speed, b.speed) / Quantum) * Quantum,
                         false});
    }
    // From the stamps themselves, not from the path, whose corners may lie anywhere between them.
    for (std::size_t k = 0; poses.size() > 1 && k < poses.size(); ++k) {
        const Point2 from = poses[k == 0 ? 0 : k - 1].at, to = poses[std::min(k + 1, poses.size() - 1)].at;
        const double length = std::hypot(to.x - from.x, to.y - from.y);
        if (length > 0)
            poses[k].direction = {(to.x - from.x) / length, (to.y - from.y) / length};
        else if (k > 0)
            poses[k].direction = poses[k - 1].direction;
    }
    return poses;
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
