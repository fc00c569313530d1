// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace model {

/// Threads that parallel work uses: the processor's, at least 1. `setThreadCount` overrides it (0: back to the
/// processor's); for tests that results do not depend on it.
unsigned threadCount();
void setThreadCount(unsigned count);

/// Calls `body(i)` for every i in 0..count-1, on up to threadCount() threads, the caller's being one of them; returns
/// when all are done. Order and distribution over threads are not fixed: a result must not depend on them.
///
/// What a body throws (std::bad_alloc, as we throw nothing ourselves) ends the loop early and is thrown here again.
void parallelFor(std::size_t count, const std::function<void(std::size_t)> &body);

/// The same over ranges begin..end of about `grain` indices.
void parallelRanges(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)> &body);

} // namespace model
