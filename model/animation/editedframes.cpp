// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/editedframes.h"

#include "model/base/digest.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace model {

namespace {

Vec3f blend(Vec3f a, Vec3f b, double fraction)
{
    const auto between = [fraction](double from, double to) { return float(from + (to - from) * fraction); };
    return {between(a.x, b.x), between(a.y, b.y), between(a.z, b.z)};
}

} // namespace

EditedFrames::EditedFrames(FrameSourcePtr source, TimeMap timeMap, Similarity placement, double frameRate,
                           std::string name)
    : mSource(std::move(source))
    , mTimeMap(std::move(timeMap))
    , mPlacement(placement)
    , mFrameRate(frameRate)
    , mName(std::move(name))
{
    assert(std::ranges::all_of(mTimeMap.sourcePositions(),
                               [this](double position) { return position <= mSource->frameCount() - 1; }));
    assert(mPlacement.scale > 0 && mFrameRate > 0);
}

void EditedFrames::positions(std::uint32_t frame, std::span<Vec3f> out) const
{
    assert(frame < frameCount());
    const double position = mTimeMap.sourcePosition(frame);
    const auto whole = std::uint32_t(position);
    mSource->positions(whole, out);
    if (const double fraction = position - whole; fraction > 0) {
        const std::vector<Vec3f> next = mSource->frame(whole + 1);
        std::ranges::transform(out, next, out.begin(), [fraction](Vec3f a, Vec3f b) { return blend(a, b, fraction); });
    }
    if (!mPlacement.isIdentity())
        std::ranges::transform(out, out.begin(), mPlacement);
}

std::uint64_t EditedFrames::digest() const
{
    if (keepsFrames())
        return mSource->digest();
    const std::uint64_t timed = digestOfArray(mTimeMap.sourcePositions(), mSource->digest());
    const double placement[] = {mPlacement.scale, mPlacement.offset[0], mPlacement.offset[1], mPlacement.offset[2]};
    return digestOfArray(std::span<const double>(placement), timed);
}

} // namespace model
