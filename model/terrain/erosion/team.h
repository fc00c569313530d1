// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/parallel.h"

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>

namespace model::terrain {

/// Threads that stay for a loop of many short parallel steps, where starting them for each step would cost more than
/// the step. The leader never waits for a helper to come, only for what a helper has taken: without helpers it does all
/// of the work itself.
class Team
{
public:
    /// Calls `lead(team)` on this thread or another, with up to `threads` - 1 helpers at hand until it returns.
    static void run(const std::function<void(Team &)> &lead, unsigned threads = threadCount());

    /// Called by the leader: body(i) for i in 0..count-1; returns when all are done. A result must not depend on who
    /// does which. What a body throws is thrown here again, when all are done.
    void forEach(std::size_t count, const std::function<void(std::size_t)> &body);

private:
    Team() = default;
    void help();

    void work();

    /// The number of the step, and below it how many of its items nobody has taken yet. One word, so that nobody takes
    /// an item of one step for that of another.
    std::atomic<std::uint64_t> mLeft = 0;
    std::atomic<std::uint32_t> mStep = 0; ///< the same number, to sleep on
    std::atomic<std::size_t> mDone = 0;
    std::atomic<const std::function<void(std::size_t)> *> mBody = nullptr;
    std::atomic<bool> mIsOver = false;
    std::mutex mThrowing;
    std::exception_ptr mThrown;
};

} // namespace model::terrain
