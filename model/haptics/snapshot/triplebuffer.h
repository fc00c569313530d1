// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace model::haptics {

/// Hands values from one writing thread to one reading thread. Both are wait-free and neither copies: each owns one of
/// three values, and they swap theirs for the one in the middle. The reader sees the newest value that was published,
/// or the one it has; never a half-written one.
template <class T>
class TripleBuffer
{
public:
    /// The writer's own value; what it holds is that of some earlier publication.
    T &writable() { return mValues[mWriting]; }
    /// Gives writable() away. It names another value afterwards.
    void publish() { mWriting = mMiddle.exchange(mWriting | Fresh, std::memory_order_acq_rel) & IndexMask; }

    /// Whether take() would find something newer.
    bool hasNews() const { return mMiddle.load(std::memory_order_relaxed) & Fresh; }
    /// Makes the newest published value the reader's own. \returns false if there is none that is newer
    bool take()
    {
        if (!hasNews())
            return false;
        mReading = mMiddle.exchange(mReading, std::memory_order_acq_rel) & IndexMask;
        return true;
    }
    /// The reader's own value.
    const T &readable() const { return mValues[mReading]; }

private:
    static constexpr std::uint32_t IndexMask = 3, Fresh = 4;

    std::array<T, 3> mValues{};
    alignas(64) std::atomic<std::uint32_t> mMiddle = 1;
    alignas(64) std::uint32_t mWriting = 0; ///< of the writer alone
    alignas(64) std::uint32_t mReading = 2; ///< of the reader alone
};

} // namespace model::haptics
