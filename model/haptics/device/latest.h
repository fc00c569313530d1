// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace model::haptics {

/// The latest value of something small, from one thread to any: a sequence lock. Writing never waits; reading tries
/// again while it is disturbed, at most a few times.
template <class T>
class Latest
{
    static_assert(std::is_trivially_copyable_v<T>);

public:
    Latest()
        : Latest(T{})
    {}
    explicit Latest(const T &value) { set(value); }

    void set(const T &value)
    {
        std::array<std::uint64_t, Words> words{};
        std::memcpy(words.data(), &value, sizeof(T));
        const std::uint32_t count = mCount.load(std::memory_order_relaxed);
        mCount.store(count + 1, std::memory_order_relaxed);
        // Release stores: who sees one of these words sees the odd count before it.
        for (std::size_t i = 0; i < Words; ++i)
            mWords[i].store(words[i], std::memory_order_release);
        mCount.store(count + 2, std::memory_order_release);
    }

    /// \returns false if the writer was at it all the time; `value` is untouched then
    bool read(T &value) const
    {
        for (int attempt = 0; attempt < 16; ++attempt) {
            const std::uint32_t before = mCount.load(std::memory_order_acquire);
            if (before & 1)
                continue;
            std::array<std::uint64_t, Words> words;
            for (std::size_t i = 0; i < Words; ++i)
                words[i] = mWords[i].load(std::memory_order_acquire);
            if (mCount.load(std::memory_order_relaxed) != before)
                continue;
            std::memcpy(static_cast<void *>(&value), words.data(), sizeof(T));
            return true;
        }
        return false;
    }

private:
    static constexpr std::size_t Words = (sizeof(T) + 7) / 8;

    std::atomic<std::uint32_t> mCount = 0;
    std::array<std::atomic<std::uint64_t>, Words> mWords{};
};

} // namespace model::haptics
