// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace model::terrain {

/// Asks for large pages: what is read here and there in arrays of hundreds of megabytes otherwise waits for the table
/// of pages as long as for the memory itself. A hint; nothing happens where there are none.
inline void preferLargePages([[maybe_unused]] void *data, [[maybe_unused]] std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    constexpr std::size_t LargePage = std::size_t(1) << 21;
    const auto begin = (reinterpret_cast<std::uintptr_t>(data) + LargePage - 1) & ~(LargePage - 1);
    const auto end = (reinterpret_cast<std::uintptr_t>(data) + bytes) & ~(LargePage - 1);
    if (begin < end)
        madvise(reinterpret_cast<void *>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

/// A std::vector of plain values that has room for an eighth more from the start, and grows by an eighth and through
/// realloc. What is reserved but not used takes no memory, and the C library moves the pages of a large array instead
/// of its bytes; even that would make the first stamp on a copy of a million vertices wait for 30 ms, and the room
/// spares it. New values are not initialised.
template <class T>
class FlatArray
{
    static_assert(std::is_trivially_copyable_v<T>);

public:
    FlatArray() = default;
    FlatArray(const FlatArray &other)
    {
        resize(other.mSize);
        if (mSize)
            std::memcpy(static_cast<void *>(mData), other.mData, mSize * sizeof(T));
    }
    FlatArray(FlatArray &&other) noexcept { swap(other); }
    FlatArray &operator=(FlatArray other) noexcept
    {
        swap(other);
        return *this;
    }
    ~FlatArray() { std::free(mData); }

    std::size_t size() const { return mSize; }
    std::size_t capacity() const { return mCapacity; }
    T *data() { return mData; }
    const T *data() const { return mData; }
    T &operator[](std::size_t i) { return mData[i]; }
    const T &operator[](std::size_t i) const { return mData[i]; }
    std::span<const T> values() const { return {mData, mSize}; }
    std::size_t byteSize() const { return mSize * sizeof(T); }

    void resize(std::size_t size)
    {
        reserve(size);
        mSize = size;
    }
    void reserve(std::size_t capacity)
    {
        if (capacity <= mCapacity)
            return;
        capacity += capacity / 8 + 64;
        void *grown = std::realloc(static_cast<void *>(mData), capacity * sizeof(T));
        if (!grown)
            throw std::bad_alloc();
        mData = static_cast<T *>(grown);
        mCapacity = capacity;
        preferLargePages(grown, capacity * sizeof(T));
    }
    void push(const T &value)
    {
        const T copy = value;
        resize(mSize + 1);
        mData[mSize - 1] = copy;
    }

private:
    void swap(FlatArray &other) noexcept
    {
        std::swap(mData, other.mData);
        std::swap(mSize, other.mSize);
        std::swap(mCapacity, other.mCapacity);
    }

    T *mData = nullptr;
    std::size_t mSize = 0;
    std::size_t mCapacity = 0;
};

} // namespace model::terrain
