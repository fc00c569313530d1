// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/servo/histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace model::haptics {

// Values below 64 have a bucket each; above, a power of two 2^e ... 2^(e + 1) has 64 buckets.
std::uint32_t Histogram::bucketOf(std::uint64_t nanoseconds)
{
    if (nanoseconds < 64)
        return std::uint32_t(nanoseconds);
    const std::uint32_t exponent = std::uint32_t(std::bit_width(nanoseconds)) - 1;
    const std::uint32_t bucket = 64 * (exponent - 5) + std::uint32_t((nanoseconds >> (exponent - 6)) - 64);
    return std::min(bucket, BucketCount - 1);
}

Time Histogram::endOf(std::uint32_t bucket)
{
    if (bucket < 64)
        return Time(bucket);
    const std::uint32_t exponent = bucket / 64 + 5;
    const std::uint64_t first = (std::uint64_t(bucket % 64) + 64) << (exponent - 6);
    return Time(std::int64_t(first + (std::uint64_t(1) << (exponent - 6)) - 1));
}

void Histogram::add(Time value)
{
    // One writer: a load and a store are enough, and cheaper than adding atomically.
    const auto increase = [](auto &number) {
        number.store(number.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    };
    increase(mBuckets[bucketOf(std::uint64_t(std::max<std::int64_t>(0, value.count())))]);
    increase(mCount);
    if (value.count() > mLongest.load(std::memory_order_relaxed))
        mLongest.store(value.count(), std::memory_order_relaxed);
}

Time Histogram::percentile(double share) const
{
    std::uint64_t total = 0;
    for (const auto &bucket : mBuckets)
        total += bucket.load(std::memory_order_relaxed);
    const double wanted = std::max(1.0, std::ceil(share * double(total)));
    std::uint64_t sum = 0;
    for (std::uint32_t i = 0; i < BucketCount; ++i) {
        sum += mBuckets[i].load(std::memory_order_relaxed);
        if (sum > 0 && double(sum) >= wanted)
            return std::min(endOf(i), longest());
    }
    return Time(0);
}

void Histogram::reset()
{
    for (auto &bucket : mBuckets)
        bucket.store(0, std::memory_order_relaxed);
    mCount.store(0, std::memory_order_relaxed);
    mLongest.store(0, std::memory_order_relaxed);
}

} // namespace model::haptics
