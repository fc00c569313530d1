// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/time.h"

#include <array>
#include <atomic>
#include <cstdint>

namespace model::haptics {

/// How often which span of time occurred. One thread adds, any may read meanwhile; nobody waits.
///
/// Buckets are 1/64 of their power of two wide: percentiles are right to 1.6 %, the maximum to the nanosecond.
class Histogram
{
public:
    void add(Time value);
    std::uint64_t count() const { return mCount.load(std::memory_order_relaxed); }
    Time longest() const { return Time(mLongest.load(std::memory_order_relaxed)); }
    /// The smallest span that this share (0 ... 1) of all does not exceed; 0 if there are none.
    Time percentile(double share) const;
    void reset();

    static constexpr std::uint32_t BucketCount = 64 * 28;
    /// The upper end of a bucket.
    static Time endOf(std::uint32_t bucket);
    std::uint32_t countIn(std::uint32_t bucket) const { return mBuckets[bucket].load(std::memory_order_relaxed); }

private:
    static std::uint32_t bucketOf(std::uint64_t nanoseconds);

    std::array<std::atomic<std::uint32_t>, BucketCount> mBuckets{};
    std::atomic<std::uint64_t> mCount = 0;
    std::atomic<std::int64_t> mLongest = 0;
};

} // namespace model::haptics
