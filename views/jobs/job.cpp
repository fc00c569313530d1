// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/jobs/job.h"

#include <QThreadPool>
#include <QtConcurrentRun>

namespace views {

namespace {

constexpr int PollMilliseconds = 50;
// Before this much has passed the speed of the work says little about its end.
constexpr double SecondsBeforeEstimate = 0.5;
constexpr double FractionBeforeEstimate = 0.01;

/// Not the global pool: frames for playback are computed there, and must not wait for somebody's encoding.
QThreadPool &jobThreads()
{
    static QThreadPool pool;
    static const bool prepared = [] {
        pool.setMaxThreadCount(16); // each job is mostly one waiting thread: the work spreads by itself
        return true;
    }();
    Q_UNUSED(prepared)
    return pool;
}

} // namespace

Job::Job(QObject *parent)
    : QObject(parent)
{
    mPolling.setInterval(PollMilliseconds);
    connect(&mPolling, &QTimer::timeout, this, &Job::pollProgress);
    connect(&mWatcher, &QFutureWatcher<void>::finished, this, &Job::finish);
}

Job::~Job()
{
    mProgress.cancel();
}

void Job::run(std::function<void(const model::Progress &)> work, std::function<void()> done)
{
    mProgress.cancel(); // of what ran before; a no-op if nothing did
    mReported = std::make_shared<std::atomic<double>>(0.0);
    mProgress = model::Progress([reported = mReported](double fraction) { reported->store(fraction); });
    mFraction = 0;
    const bool wasRunning = isRunning();
    mDone = std::move(done);
    mClock.start();
    mPolling.start();
    mWatcher.setFuture(
        QtConcurrent::run(&jobThreads(), [work = std::move(work), progress = mProgress]() mutable { work(progress); }));
    if (!wasRunning)
        emit runningChanged(true);
    emit progressed(0);
}

void Job::cancel()
{
    mProgress.cancel();
}

std::optional<double> Job::secondsLeft() const
{
    const double elapsed = elapsedSeconds();
    if (!isRunning() || elapsed < SecondsBeforeEstimate || mFraction < FractionBeforeEstimate)
        return std::nullopt;
    return elapsed * (1 - mFraction) / mFraction;
}

void Job::finish()
{
    mPolling.stop();
    pollProgress();
    const std::function<void()> done = std::exchange(mDone, nullptr);
    emit runningChanged(false);
    done(); // last: it may delete this
}

void Job::pollProgress()
{
    const double fraction = mReported->load();
    if (fraction == mFraction)
        return;
    mFraction = fraction;
    emit progressed(fraction);
}

} // namespace views
