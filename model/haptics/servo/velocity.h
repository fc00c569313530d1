// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/geometry/vec3d.h"
#include "model/haptics/time.h"

#include <array>
#include <cstdint>

namespace model::haptics {

/// Velocity over the last 15 ms: a difference of two steps would be mostly the device's resolution.
/// Source: CHAI3D 3.2, cGenericHapticDevice (its window for linear velocity).
class VelocityWindow
{
public:
    /// m/s. A position that is said again with the same time changes nothing.
    Vec3d add(Vec3d position, Time time)
    {
        if (mCount > 0 && time <= mEntries[(mNext + Size - 1) % Size].time)
            return mVelocity;
        mEntries[mNext] = {position, time};
        mNext = (mNext + 1) % Size;
        mCount = mCount < Size ? mCount + 1 : Size;
        std::uint32_t oldest = (mNext + Size - 1) % Size; // itself, and from there back in time
        for (std::uint32_t i = 1; i < mCount; ++i) {
            const std::uint32_t at = (mNext + Size - 1 - i) % Size;
            // At least one difference, and as many as the window holds.
            if (i > 1 && time - mEntries[at].time > Window)
                break;
            oldest = at;
        }
        const double span = seconds(time - mEntries[oldest].time);
        mVelocity = span > 0 ? (position - mEntries[oldest].position) * (1 / span) : Vec3d();
        return mVelocity;
    }
    void reset() { *this = {}; }

private:
    static constexpr Time Window = std::chrono::milliseconds(15);
    static constexpr std::uint32_t Size = 32;
    struct Entry
    {
        Vec3d position;
        Time time{0};
    };

    std::array<Entry, Size> mEntries{};
    std::uint32_t mNext = 0, mCount = 0;
    Vec3d mVelocity;
};

} // namespace model::haptics
