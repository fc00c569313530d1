// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scarcity.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

#include <malloc.h>

namespace {

constexpr std::size_t Unlimited = std::numeric_limits<std::size_t>::max();
std::atomic<std::size_t> failFrom = Unlimited;

std::atomic<bool> isMetered = false;
std::atomic<std::int64_t> meteredNow = 0, meteredPeak = 0;

void meter(void *memory, std::int64_t sign)
{
    if (!memory || !isMetered.load(std::memory_order_relaxed))
        return;
    const std::int64_t now = meteredNow += sign * std::int64_t(malloc_usable_size(memory));
    std::int64_t peak = meteredPeak;
    while (now > peak && !meteredPeak.compare_exchange_weak(peak, now)) {
    }
}

void *allocate(std::size_t size) noexcept
{
    if (size >= failFrom.load(std::memory_order_relaxed))
        return nullptr;
    void *const memory = std::malloc(size ? size : 1);
    meter(memory, 1);
    return memory;
}

void release(void *memory) noexcept
{
    meter(memory, -1);
    std::free(memory);
}

void *allocateOrThrow(std::size_t size)
{
    if (void *const memory = allocate(size))
        return memory;
    throw std::bad_alloc();
}

} // namespace

// Those of the whole program, libraries included; all that belong together, as the address sanitizer compares them.
void *operator new(std::size_t size)
{
    return allocateOrThrow(size);
}
void *operator new[](std::size_t size)
{
    return allocateOrThrow(size);
}
void *operator new(std::size_t size, const std::nothrow_t &) noexcept
{
    return allocate(size);
}
void *operator new[](std::size_t size, const std::nothrow_t &) noexcept
{
    return allocate(size);
}
void operator delete(void *memory) noexcept
{
    release(memory);
}
void operator delete[](void *memory) noexcept
{
    release(memory);
}
void operator delete(void *memory, std::size_t) noexcept
{
    release(memory);
}
void operator delete[](void *memory, std::size_t) noexcept
{
    release(memory);
}
void operator delete(void *memory, const std::nothrow_t &) noexcept
{
    release(memory);
}
void operator delete[](void *memory, const std::nothrow_t &) noexcept
{
    release(memory);
}

namespace tests {

AllocationLimit::AllocationLimit(std::size_t bytes)
{
    failFrom = bytes;
}

AllocationLimit::~AllocationLimit()
{
    failFrom = Unlimited;
}

AllocationMeter::AllocationMeter()
{
    meteredNow = 0;
    meteredPeak = 0;
    isMetered = true;
}

AllocationMeter::~AllocationMeter()
{
    isMetered = false;
}

std::uint64_t AllocationMeter::peak() const
{
    return std::uint64_t(std::max<std::int64_t>(meteredPeak, 0));
}

FileSizeLimit::FileSizeLimit(std::uint64_t bytes)
    : mHandlerBefore(std::signal(SIGXFSZ, SIG_IGN)) // else the kernel ends the process
{
    getrlimit(RLIMIT_FSIZE, &mBefore);
    const rlimit limit{bytes, mBefore.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
}

FileSizeLimit::~FileSizeLimit()
{
    setrlimit(RLIMIT_FSIZE, &mBefore);
    std::signal(SIGXFSZ, mHandlerBefore);
}

} // namespace tests
