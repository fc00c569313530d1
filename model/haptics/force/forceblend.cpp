// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/force/forceblend.h"

#include <algorithm>
#include <cmath>

namespace model::haptics {

void ForceBlend::change(Vec3d before, Vec3d after, Time period)
{
    mDifference = before + remainder() - after;
    mShare = 1;
    const double amount = std::sqrt(dot(mDifference, mDifference));
    const double shortest = std::max(seconds(std::clamp(period, ShortestFade, LongestFade)), amount / LargestRate);
    mPerSecond = 1 / shortest;
}

Vec3d ForceBlend::advance(Time elapsed)
{
    mShare = std::max(0.0, mShare - seconds(elapsed) * mPerSecond);
    return remainder();
}

} // namespace model::haptics
