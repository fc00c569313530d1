// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"

#include <QElapsedTimer>
#include <QFutureWatcher>
#include <QObject>
#include <QTimer>

#include <atomic>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>

namespace views {

/// Work in the background for one purpose of a window ("read the source", "save this document"); used again and again.
///
///     mReading.start([path](const model::Progress &progress) { return model::io::readAnimation(path, {}, progress); },
///                    [this](model::Result<model::FrameSourcePtr> result) { showFound(std::move(result)); });
///
/// Lives in the GUI thread, as a member or child of whoever `done` belongs to. Destroying a running job, or starting it
/// again, cancels the work and drops its result at once, without waiting: the work ends by itself soon after. (Leaving
/// the program waits for it.)
class Job final : public QObject
{
    Q_OBJECT

public:
    explicit Job(QObject *parent = nullptr);
    ~Job() override;

    /// Runs `work` in another thread, then `done` in this one with what it returned.
    /// \param work  Result<T>(const model::Progress &); owns what it uses (it may outlive this object); returns
    ///              ErrorCode::Cancelled soon after a cancel. Running out of memory is turned into OutOfMemory.
    /// \param done  void(Result<T>); called once with the outcome, which after cancel() is mostly, but need not be,
    ///              Cancelled. May start this job again or delete it.
    template <class Work, class Done>
    void start(Work work, Done done)
    {
        using Outcome = std::invoke_result_t<Work &, const model::Progress &>;
        auto outcome = std::make_shared<std::optional<Outcome>>();
        run(
            [work = std::move(work), outcome](const model::Progress &progress) mutable {
                try {
                    outcome->emplace(work(progress));
                } catch (const std::bad_alloc &) {
                    outcome->emplace(model::fail(model::ErrorCode::OutOfMemory));
                }
            },
            [done = std::move(done), outcome]() mutable { done(std::move(**outcome)); });
    }

    bool isRunning() const { return mDone != nullptr; }
    /// 0..1, of the work that runs.
    double fraction() const { return mFraction; }
    double elapsedSeconds() const { return double(mClock.elapsed()) / 1000; }
    /// What remains if it goes on as fast as so far; nothing while that cannot be told yet.
    std::optional<double> secondsLeft() const;

public slots:
    /// Asks the work to stop; `done` follows when it has.
    void cancel();

signals:
    /// Work began, or ended; the end is said before `done` is called.
    void runningChanged(bool running);
    /// At most some 20 times a second, only when it changed.
    void progressed(double fraction);

private:
    void run(std::function<void(const model::Progress &)> work, std::function<void()> done);
    void finish();
    void pollProgress();

    model::Progress mProgress;
    std::shared_ptr<std::atomic<double>> mReported;
    std::function<void()> mDone; ///< null while nothing runs
    QFutureWatcher<void> mWatcher;
    QTimer mPolling;
    QElapsedTimer mClock;
    double mFraction = 0;
};

} // namespace views
