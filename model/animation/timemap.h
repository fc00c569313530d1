// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
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
    std::span<const double> sourcePositions() const { return mPositions; }
    bool isIdentity(std::uint32_t sourceFrameCount) const;

    /// Frames first..last (both kept). Precondition: first <= last < frameCount().
    TimeMap trimmed(std::uint32_t first, std::uint32_t last) const;
    TimeMap reversed() const;
    /// The same animation at another rate: resampledFrameCount() moments, evenly spread from the first moment to the
    /// last, both of which stay exactly. So the duration is kept to half a frame, and steps stay even, which a loop
    /// shows at once.
    ///
    /// A moment between two frames of this map lies between their *source positions*: frames that an earlier
    /// resampling left out come back, blends are never blended again, and going to a higher rate and back is exact.
    /// Only across a cut nothing lies between, and the nearer frame is shown. A cut is a step longer than one source
    /// frame and more than twice as long as the steps beside it; trimming, reversing and resampling make none.
    /// Preconditions: both rates above zero, resampledFrameCount() at most MaxFrameCount.
    TimeMap resampled(double fromRate, double toRate) const;

    /// Longest map that resampling may make; what asks a user for a rate must refuse a longer one.
    static constexpr std::uint32_t MaxFrameCount = 1'000'000;
    /// Frames after resampling: 1 stays 1, others keep at least their first and last.
    static std::uint64_t resampledFrameCount(std::uint32_t frameCount, double fromRate, double toRate);

    friend bool operator==(const TimeMap &, const TimeMap &) = default;

private:
    double between(std::size_t frame, double fraction) const;
    bool isCut(std::size_t frame) const;

    std::vector<double> mPositions;
};

} // namespace model
