// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include <csignal>
#include <sys/resource.h>

namespace tests {

/// While it lives, allocations with `new` of `bytes` or more fail, in every thread. One at a time.
class AllocationLimit
{
public:
    explicit AllocationLimit(std::size_t bytes);
    AllocationLimit(const AllocationLimit &) = delete;
    AllocationLimit &operator=(const AllocationLimit &) = delete;
    ~AllocationLimit();
};

/// Counts what is allocated with `new`, in every thread, while it lives: how much more there is than when it began, and
/// the most there was. One at a time. What C libraries allocate (zlib: some 40 KiB for a stream) is not counted.
class AllocationMeter
{
public:
    AllocationMeter();
    AllocationMeter(const AllocationMeter &) = delete;
    AllocationMeter &operator=(const AllocationMeter &) = delete;
    ~AllocationMeter();

    /// Bytes.
    std::uint64_t peak() const;
};

/// While it lives, no file grows beyond `bytes`: writing fails as on a full disk.
class FileSizeLimit
{
public:
    explicit FileSizeLimit(std::uint64_t bytes);
    FileSizeLimit(const FileSizeLimit &) = delete;
    FileSizeLimit &operator=(const FileSizeLimit &) = delete;
    ~FileSizeLimit();

private:
    rlimit mBefore;
    void (*mHandlerBefore)(int);
};

} // namespace tests
