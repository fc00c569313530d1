// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/progress.h"

#include <algorithm>

namespace model {

Progress::Progress(Callback callback)
    : mState(std::make_shared<State>())
{
    mState->callback = std::move(callback);
}

void Progress::report(double fraction) const
{
    if (!mState->callback)
        return;
    const double whole = mFrom + (mTo - mFrom) * std::clamp(fraction, 0.0, 1.0);
    const int permille = int(whole * 1000.0);
    // A report that another thread overtakes is dropped: the next one carries the news.
    if (permille <= mState->permille.load(std::memory_order_relaxed) ||
        mState->calling.test_and_set(std::memory_order_acquire))
        return;
    if (permille > mState->permille.load(std::memory_order_relaxed)) {
        mState->permille.store(permille, std::memory_order_relaxed);
        mState->callback(whole);
    }
    mState->calling.clear(std::memory_order_release);
}

Progress Progress::part(double from, double to) const
{
    Progress result = *this;
    result.mFrom = mFrom + (mTo - mFrom) * from;
    result.mTo = mFrom + (mTo - mFrom) * to;
    return result;
}

} // namespace model
