// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/time.h"

#include <cstdint>

namespace model::haptics {

/// When the next step is due. Deadlines lie on one grid for ever, so that nothing drifts; those that have passed
/// already are skipped and counted, never made up for in a burst.
class Deadline
{
public:
    Deadline(Time begin, Time period)
        : mDue(begin + period)
        , mPeriod(period)
    {}

    Time due() const { return mDue; }
    /// To be called when the step of due() is done. \returns how many deadlines were missed
    std::uint64_t advance(Time now)
    {
        const std::int64_t passed = now > mDue ? (now - mDue) / mPeriod : 0;
        mDue += (passed + 1) * mPeriod;
        return std::uint64_t(passed);
    }

private:
    Time mDue, mPeriod;
};

} // namespace model::haptics
