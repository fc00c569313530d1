// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/servo/periodicthread.h"

#include "model/haptics/servo/deadline.h"

#include <cerrno>
#include <ctime>

#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace model::haptics {

namespace {

/// Below what the kernel's own threads have.
constexpr int WantedPriority = 20;

bool takeRealTimePriority()
{
    rlimit limit{};
    if (getrlimit(RLIMIT_RTPRIO, &limit) != 0 || limit.rlim_cur == 0)
        return false;
    sched_param parameters{};
    parameters.sched_priority = limit.rlim_cur < rlim_t(WantedPriority) ? int(limit.rlim_cur) : WantedPriority;
    return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

void sleepUntil(Time when)
{
    timespec at{};
    at.tv_sec = when.count() / 1'000'000'000;
    at.tv_nsec = when.count() % 1'000'000'000;
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr) == EINTR) {
    }
}

} // namespace

Time monotonicNow()
{
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::chrono::seconds(now.tv_sec) + Time(now.tv_nsec);
}

PeriodicThread::PeriodicThread(std::function<void(Time now)> step, Time period)
    : mStep(std::move(step))
    , mPeriod(period)
{}

PeriodicThread::~PeriodicThread()
{
    stop();
}

void PeriodicThread::start()
{
    if (isRunning())
        return;
    mHasToStop = false;
    mSteps = mMissed = 0;
    mElapsed = 0;
    mLateness.reset();
    mStepTimes.reset();
    mThread = std::thread([this] { run(); });
}

void PeriodicThread::stop()
{
    mHasToStop = true;
    if (mThread.joinable())
        mThread.join();
}

Punctuality PeriodicThread::punctuality() const
{
    return {mSteps.load(), mMissed.load(), Time(mElapsed.load()), mIsRealTime.load()};
}

void PeriodicThread::run()
{
    mIsRealTime = takeRealTimePriority();
    prctl(PR_SET_TIMERSLACK, 1); // ns; the default of 50 us is half of the lateness
    pthread_setname_np(pthread_self(), "haptics servo");
    const Time begin = monotonicNow();
    Deadline deadline(begin, mPeriod);
    while (!mHasToStop.load(std::memory_order_relaxed)) {
        sleepUntil(deadline.due());
        const Time now = monotonicNow();
        mLateness.add(now - deadline.due());
        mStep(now);
        const Time after = monotonicNow();
        mStepTimes.add(after - now);
        mMissed.store(mMissed.load(std::memory_order_relaxed) + deadline.advance(after), std::memory_order_relaxed);
        mSteps.store(mSteps.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
        mElapsed.store((deadline.due() - mPeriod - begin).count(), std::memory_order_relaxed);
    }
}

} // namespace model::haptics
