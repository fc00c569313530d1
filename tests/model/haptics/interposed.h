// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace tests {

/// What this thread has asked of the heap and of locks since the program began. Counted by functions that stand in for
/// malloc and pthread_mutex_lock (in sanitized programs by the sanitizer's own hook).
struct Interposed
{
    std::uint64_t allocations = 0, releases = 0, locks = 0;
};
const Interposed &interposedCalls();

} // namespace tests
