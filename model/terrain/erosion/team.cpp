// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/erosion/team.h"

#include <thread>
#include <utility>

namespace model::terrain {

namespace {

/// How often a helper looks for work before it goes to sleep: about as long as the leader needs between two steps.
constexpr int LooksBeforeSleep = 2000;

} // namespace

void Team::run(const std::function<void(Team &)> &lead, unsigned threads)
{
    Team team;
    // Whoever takes index 0 leads; it is taken first, so that there is never a helper without a leader.
    parallelFor(threads, [&](std::size_t i) {
        if (i > 0)
            return team.help();
        struct End
        {
            Team &team;
            ~End()
            {
                team.mIsOver = true;
                ++team.mStep;
                team.mStep.notify_all();
            }
        } end{team};
        lead(team);
    });
}

void Team::forEach(std::size_t count, const std::function<void(std::size_t)> &body)
{
    if (count == 1)
        return body(0);
    if (count == 0)
        return;
    mBody.store(&body, std::memory_order_relaxed);
    mDone.store(0, std::memory_order_relaxed);
    const std::uint32_t step = mStep.load(std::memory_order_relaxed) + 1;
    mLeft.store(std::uint64_t(step) << 32 | count, std::memory_order_release);
    mStep.store(step, std::memory_order_release);
    mStep.notify_all();
    work();
    for (int looks = 0; mDone.load(std::memory_order_acquire) != count; ++looks)
        if (looks > LooksBeforeSleep)
            std::this_thread::yield();
    if (mThrown)
        std::rethrow_exception(std::exchange(mThrown, nullptr));
}

void Team::work()
{
    std::uint64_t left = mLeft.load(std::memory_order_acquire);
    while (std::uint32_t(left) != 0) {
        if (!mLeft.compare_exchange_weak(left, left - 1, std::memory_order_acq_rel, std::memory_order_acquire))
            continue;
        // The leader does not go on to another body before this item is done.
        try {
            (*mBody.load(std::memory_order_relaxed))(std::uint32_t(left) - 1);
        } catch (...) {
            const std::lock_guard lock(mThrowing);
            mThrown = std::current_exception();
        }
        mDone.fetch_add(1, std::memory_order_acq_rel);
        left = mLeft.load(std::memory_order_acquire);
    }
}

void Team::help()
{
    for (std::uint32_t seen = 0; !mIsOver.load(std::memory_order_acquire);) {
        int looks = 0;
        while (mStep.load(std::memory_order_acquire) == seen && ++looks < LooksBeforeSleep)
            ;
        mStep.wait(seen, std::memory_order_acquire);
        seen = mStep.load(std::memory_order_acquire);
        work();
    }
}

} // namespace model::terrain
