// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/servo/histogram.h"

#include <atomic>
#include <functional>
#include <thread>

namespace model::haptics {

/// CLOCK_MONOTONIC.
Time monotonicNow();

/// How well a PeriodicThread keeps its time.
struct Punctuality
{
    std::uint64_t steps = 0;  ///< done
    std::uint64_t missed = 0; ///< deadlines that had passed, and were skipped
    Time elapsed{0};          ///< from the start to the last deadline that was met or skipped
    bool isRealTime = false;  ///< whether it runs at real-time priority
    /// Deadlines a second, met or skipped: the nominal rate, unless the clock drifts.
    double rate() const { return elapsed > Time(0) ? double(steps + missed) / seconds(elapsed) : 0; }
    /// Steps a second.
    double stepRate() const { return elapsed > Time(0) ? double(steps) / seconds(elapsed) : 0; }
};

/// Calls a function each millisecond, from a thread of its own that sleeps in between until absolute deadlines.
///
/// It asks for real-time priority where the system allows that to this user (RLIMIT_RTPRIO), runs at normal priority
/// elsewhere, and says which.
class PeriodicThread
{
public:
    /// \param step  takes the time; must not throw, and has to be quick
    explicit PeriodicThread(std::function<void(Time now)> step, Time period = ServoPeriod);
    PeriodicThread(const PeriodicThread &) = delete;
    PeriodicThread &operator=(const PeriodicThread &) = delete;
    ~PeriodicThread(); ///< stops

    void start();
    /// Returns when the last step is over.
    void stop();
    bool isRunning() const { return mThread.joinable(); }

    Punctuality punctuality() const;
    /// How late steps began after their deadlines.
    const Histogram &lateness() const { return mLateness; }
    /// How long steps took.
    const Histogram &stepTimes() const { return mStepTimes; }

private:
    void run();

    std::function<void(Time)> mStep;
    const Time mPeriod;
    std::thread mThread;
    std::atomic<bool> mHasToStop = false, mIsRealTime = false;
    std::atomic<std::uint64_t> mSteps = 0, mMissed = 0;
    std::atomic<std::int64_t> mElapsed = 0;
    Histogram mLateness, mStepTimes;
};

} // namespace model::haptics
