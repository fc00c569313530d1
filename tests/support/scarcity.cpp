// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scarcity.h"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t Unlimited = std::numeric_limits<std::size_t>::max();
std::atomic<std::size_t> failFrom = Unlimited;

void *allocate(std::size_t size) noexcept
{
    return size >= failFrom.load(std::memory_order_relaxed) ? nullptr : std::malloc(size ? size : 1);
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
    std::free(memory);
}
void operator delete[](void *memory) noexcept
{
    std::free(memory);
}
void operator delete(void *memory, std::size_t) noexcept
{
    std::free(memory);
}
void operator delete[](void *memory, std::size_t) noexcept
{
    std::free(memory);
}
void operator delete(void *memory, const std::nothrow_t &) noexcept
{
    std::free(memory);
}
void operator delete[](void *memory, const std::nothrow_t &) noexcept
{
    std::free(memory);
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
