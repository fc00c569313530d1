// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/timemap.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace model {

namespace {

/// A position this near to a whole source frame is that frame, so that rounding in a chain of resamplings does not turn
/// frames into blends. Frames; far above what rounding does to positions below 2^20, far below what anybody sees.
constexpr double WholeFrameTolerance = 1e-9;

double snapped(double position)
{
    const double whole = std::round(position);
    return std::abs(position - whole) < WholeFrameTolerance ? whole : position;
}

} // namespace

TimeMap TimeMap::identity(std::uint32_t frameCount)
{
    std::vector<double> positions(frameCount);
    std::iota(positions.begin(), positions.end(), 0.0);
    return TimeMap(std::move(positions));
}

TimeMap::TimeMap(std::vector<double> sourcePositions)
    : mPositions(std::move(sourcePositions))
{
    assert(!mPositions.empty());
    assert(std::ranges::all_of(mPositions, [](double p) { return std::isfinite(p) && p >= 0; }));
}

bool TimeMap::isIdentity(std::uint32_t sourceFrameCount) const
{
    if (frameCount() != sourceFrameCount)
        return false;
    for (std::size_t i = 0; i < mPositions.size(); ++i)
        if (mPositions[i] != double(i))
            return false;
    return true;
}

TimeMap TimeMap::trimmed(std::uint32_t first, std::uint32_t last) const
{
    assert(first <= last && last < frameCount());
    return TimeMap(std::vector<double>(mPositions.begin() + first, mPositions.begin() + last + 1));
}

TimeMap TimeMap::reversed() const
{
    return TimeMap(std::vector<double>(mPositions.rbegin(), mPositions.rend()));
}

TimeMap TimeMap::resampled(double fromRate, double toRate) const
{
    const std::uint64_t count = resampledFrameCount(frameCount(), fromRate, toRate);
    assert(count <= MaxFrameCount);
    const std::uint64_t fromSteps = frameCount() - 1;
    const std::uint64_t toSteps = std::max<std::uint64_t>(count - 1, 1);
    std::vector<double> positions(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        // From the index in whole numbers: no error adds up, the last moment is exact.
        const std::uint64_t product = i * fromSteps;
        positions[i] = between(product / toSteps, double(product % toSteps) / double(toSteps));
    }
    return TimeMap(std::move(positions));
}

std::uint64_t TimeMap::resampledFrameCount(std::uint32_t frameCount, double fromRate, double toRate)
{
    assert(fromRate > 0 && toRate > 0);
    if (frameCount < 2)
        return frameCount;
    const double steps = std::round((frameCount - 1) * (toRate / fromRate));
    return 1 + std::uint64_t(std::clamp(steps, 1.0, 1e18));
}

/// The source position at `frame` + `fraction`, fraction in 0..1 (excluding 1).
double TimeMap::between(std::size_t frame, double fraction) const
{
    if (fraction == 0)
        return mPositions[frame];
    const double a = mPositions[frame];
    const double b = mPositions[frame + 1];
    if (isCut(frame))
        return fraction < 0.5 ? a : b;
    return std::clamp(snapped(a + (b - a) * fraction), std::min(a, b), std::max(a, b));
}

/// Whether the step from `frame` to the next one is a cut, as the header says.
bool TimeMap::isCut(std::size_t frame) const
{
    const auto step = [&](std::size_t i) { return std::abs(mPositions[i + 1] - mPositions[i]); };
    const bool hasBefore = frame > 0;
    const bool hasAfter = frame + 2 < mPositions.size();
    if (!hasBefore && !hasAfter)
        return false;
    const double beside = std::max(hasBefore ? step(frame - 1) : 0.0, hasAfter ? step(frame + 1) : 0.0);
    return step(frame) > 1 && step(frame) > 2 * beside;
}

} // namespace model
