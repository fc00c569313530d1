// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>

namespace model {

/// How far a long piece of work is, and whether it should stop. A cheap handle: copies and parts share one state, so
/// that a caller keeps a copy, hands another to the work, and cancels through its own. Thread-safe.
///
/// Work calls `isCancelled()` at least every few milliseconds and returns ErrorCode::Cancelled without traces.
class Progress
{
public:
    using Callback = std::function<void(double fraction)>;

    /// \param callback  called with 0..1, never falling, from whichever thread reports, at most about 1000 times;
    ///                  never from two threads at once
    explicit Progress(Callback callback = {});

    /// Says that `fraction` (0..1) of this part is done.
    void report(double fraction) const;

    void cancel() const { mState->cancelled.store(true, std::memory_order_relaxed); }
    bool isCancelled() const { return mState->cancelled.load(std::memory_order_relaxed); }

    /// The share from..to of this part (both 0..1) as a progress of its own.
    Progress part(double from, double to) const;

private:
    struct State;
    std::shared_ptr<State> mState;
    double mFrom = 0.0;
    double mTo = 1.0;

    struct State
    {
        Callback callback;
        std::atomic<bool> cancelled = false;
        std::atomic<int> permille = -1;
        std::atomic_flag calling = ATOMIC_FLAG_INIT;
    };
};

} // namespace model
