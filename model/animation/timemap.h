// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace model {

/// Where each frame of an edited animation comes from: positions in the frames of a source, 0..F-1; a fraction blends
/// its two neighbours linearly. Trimming, reversing and resampling are operations on this list, so that they cost
/// nothing, are exact to undo, and never accumulate blending.
class TimeMap
{
public:
    /// Every frame of the source once.
    static TimeMap identity(std::uint32_t frameCount);

    /// Precondition: not empty; each finite and at least 0.
    explicit TimeMap(std::vector<double> sourcePositions);

    std::uint32_t frameCount() const { return std::uint32_t(mPositions.size()); }
    double sourcePosition(std::uint32_t frame) const { return mPositions[frame]; }
    bool isIdentity(std::uint32_t sourceFrameCount) const;

    /// Frames first..last (both kept). Precondition: first <= last < frameCount().
    TimeMap trimmed(std::uint32_t first, std::uint32_t last) const;
    TimeMap reversed() const;
    /// The same duration at another rate: frame j of the result shows this map at j * fromRate / toRate; the first and
    /// the last moment stay. Preconditions: both rates above zero.
    TimeMap resampled(double fromRate, double toRate) const;

    friend bool operator==(const TimeMap &, const TimeMap &) = default;

private:
    std::vector<double> mPositions;
};

} // namespace model
