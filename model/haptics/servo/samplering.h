// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/servo/servocore.h"

#include <atomic>
#include <memory>
#include <vector>

namespace model::haptics {

/// What the servo did, for whoever plots or records it: a queue from one thread to one other. Neither waits; what does
/// not fit is counted and lost.
class SampleRing
{
public:
    static constexpr std::uint64_t Capacity = 16384; ///< 16 s

    SampleRing()
        : mSamples(Capacity)
    {}

    void push(const ServoSample &sample)
    {
        const std::uint64_t written = mWritten.load(std::memory_order_relaxed);
        if (written - mRead.load(std::memory_order_acquire) == Capacity) {
            mLost.store(mLost.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
            return;
        }
        mSamples[written % Capacity] = sample;
        mWritten.store(written + 1, std::memory_order_release);
    }

    /// Appends all that is there to `samples`.
    void drain(std::vector<ServoSample> &samples)
    {
        const std::uint64_t written = mWritten.load(std::memory_order_acquire);
        std::uint64_t read = mRead.load(std::memory_order_relaxed);
        for (; read != written; ++read)
            samples.push_back(mSamples[read % Capacity]);
        mRead.store(read, std::memory_order_release);
    }

    std::uint64_t lost() const { return mLost.load(std::memory_order_relaxed); }

private:
    std::vector<ServoSample> mSamples;
    alignas(64) std::atomic<std::uint64_t> mWritten = 0;
    alignas(64) std::atomic<std::uint64_t> mRead = 0;
    std::atomic<std::uint64_t> mLost = 0;
};

} // namespace model::haptics
