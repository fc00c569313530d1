// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"
#include "views/jobs/job.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QThread>

using namespace model;
using views::Job;

namespace {

/// Shared with the work, so that a test holds it at a known place.
struct Gate
{
    QSemaphore started;
    QSemaphore mayEnd;
    std::atomic<bool> sawCancel = false;
    std::atomic<int> ended = 0;
};

/// Work that waits for a cancel.
Result<int> waitForCancel(Gate &gate, const Progress &progress)
{
    gate.started.release();
    while (!progress.isCancelled())
        QThread::msleep(1);
    gate.sawCancel = true;
    ++gate.ended;
    return fail(ErrorCode::Cancelled);
}

} // namespace

class TestJob final : public QObject
{
    Q_OBJECT

private slots:
    void whatWasReportedLastIsToldBeforeTheEnd()
    {
        // Work that ends at once never meets the timer that looks at its progress.
        Job job;
        QList<double> told;
        connect(&job, &Job::progressed, this, [&](double fraction) { told << fraction; });
        QList<double> toldAtEnd;
        job.start(
            [](const Progress &progress) -> Result<int> {
                progress.report(1);
                return 1;
            },
            [&](Result<int>) { toldAtEnd = told; });
        QTRY_VERIFY(!job.isRunning());
        QCOMPARE(toldAtEnd.value(toldAtEnd.size() - 1, -1), 1.0);
    }

    void resultArrivesInTheThreadOfTheJob()
    {
        Job job;
        QThread *worker = nullptr;
        QThread *receiver = nullptr;
        std::optional<Result<int>> outcome;
        job.start(
            [&worker](const Progress &) -> Result<int> {
                worker = QThread::currentThread();
                return 42;
            },
            [&](Result<int> result) {
                receiver = QThread::currentThread();
                outcome = std::move(result);
            });
        QVERIFY(job.isRunning());
        QTRY_VERIFY(outcome.has_value());
        QVERIFY(!job.isRunning());
        QCOMPARE(outcome->value(), 42);
        QCOMPARE(receiver, QThread::currentThread());
        QVERIFY(worker != receiver);
    }

    void resultsNeedNotBeCopyable()
    {
        Job job;
        std::unique_ptr<int> arrived;
        job.start([](const Progress &) -> Result<std::unique_ptr<int>> { return std::make_unique<int>(7); },
                  [&](Result<std::unique_ptr<int>> result) { arrived = std::move(*result); });
        QTRY_VERIFY(arrived);
        QCOMPARE(*arrived, 7);
    }

    void errorsArriveAsTheyAre()
    {
        Job job;
        std::optional<Error> error;
        job.start(
            [](const Progress &) -> Result<void> {
                return fail(Error{ErrorCode::NotFound, {}, "a.obj", 3});
            },
            [&](Result<void> result) { error = result.error(); });
        QTRY_VERIFY(error);
        QCOMPARE(int(error->code), int(ErrorCode::NotFound));
        QCOMPARE(error->file, std::string("a.obj"));
        QCOMPARE(error->line, std::uint64_t(3));
    }

    void outOfMemoryIsAnError()
    {
        Job job;
        std::optional<Error> error;
        job.start([](const Progress &) -> Result<void> { throw std::bad_alloc(); },
                  [&](Result<void> result) { error = result.error(); });
        QTRY_VERIFY(error);
        QCOMPARE(int(error->code), int(ErrorCode::OutOfMemory));
    }

    void progressIsSeenWhileItRuns()
    {
        Gate gate;
        Job job;
        QSignalSpy progressed(&job, &Job::progressed);
        bool done = false;
        job.start(
            [&gate](const Progress &progress) -> Result<int> {
                progress.part(0.5, 1).report(0.5);
                gate.mayEnd.acquire();
                return 1;
            },
            [&done](const Result<int> &) { done = true; });
        QTRY_COMPARE(job.fraction(), 0.75);
        QVERIFY(!done);
        QCOMPARE(progressed.last().first().toDouble(), 0.75);
        QTRY_VERIFY(job.secondsLeft().has_value());
        QVERIFY(*job.secondsLeft() < job.elapsedSeconds()); // three quarters are done, one is left
        gate.mayEnd.release();
        QTRY_VERIFY(done);
        QVERIFY(!job.secondsLeft().has_value());
    }

    void runningIsSaidOnceEachWay()
    {
        Job job;
        QList<bool> said;
        bool doneSawIt = false;
        connect(&job, &Job::runningChanged, this, [&](bool running) { said << running; });
        job.start([](const Progress &) -> Result<int> { return 1; },
                  [&](const Result<int> &) {
                      doneSawIt = said == QList<bool>{true, false};
                  });
        QTRY_VERIFY(doneSawIt);
    }

    void cancelEndsTheWork()
    {
        Gate gate;
        Job job;
        std::optional<Error> error;
        job.start([&gate](const Progress &progress) { return waitForCancel(gate, progress); },
                  [&](const Result<int> &result) { error = result.error(); });
        gate.started.acquire();
        job.cancel();
        QVERIFY(!error);
        QTRY_VERIFY(error);
        QCOMPARE(int(error->code), int(ErrorCode::Cancelled));
        QVERIFY(!job.isRunning());
    }

    void startingAgainDropsTheOlderResult()
    {
        const auto gate = std::make_shared<Gate>();
        Job job;
        bool olderCame = false;
        int newer = 0;
        job.start([gate](const Progress &progress) { return waitForCancel(*gate, progress); },
                  [&](const Result<int> &) { olderCame = true; });
        gate->started.acquire();
        job.start([](const Progress &) -> Result<int> { return 2; },
                  [&](const Result<int> &result) { newer = *result; });
        QTRY_COMPARE(newer, 2);
        QTRY_VERIFY(gate->sawCancel);
        QTest::qWait(20); // the older one's end must not arrive late either
        QVERIFY(!olderCame);
    }

    void destroyingCancelsWithoutWaiting()
    {
        const auto gate = std::make_shared<Gate>();
        bool came = false;
        {
            Job job;
            job.start(
                [gate](const Progress &progress) -> Result<int> {
                    gate->started.release();
                    gate->mayEnd.acquire(); // held until after the job is gone
                    gate->sawCancel = progress.isCancelled();
                    ++gate->ended;
                    return 1;
                },
                [&](const Result<int> &) { came = true; });
            gate->started.acquire();
        }
        QCOMPARE(gate->ended.load(), 0);
        gate->mayEnd.release();
        QTRY_COMPARE(gate->ended.load(), 1);
        QVERIFY(gate->sawCancel);
        QTest::qWait(20);
        QVERIFY(!came);
    }

    void doneMayDeleteTheJob()
    {
        auto *job = new Job;
        bool deleted = false;
        job->start([](const Progress &) -> Result<int> { return 1; },
                   [&](const Result<int> &) {
                       delete job;
                       deleted = true;
                   });
        QTRY_VERIFY(deleted);
    }

    void doneMayStartTheNext()
    {
        Job job;
        int last = 0;
        std::function<void(Result<int>)> done = [&](const Result<int> &result) {
            last = *result;
            if (last < 3)
                job.start([next = last + 1](const Progress &) -> Result<int> { return next; }, done);
        };
        job.start([](const Progress &) -> Result<int> { return 1; }, done);
        QTRY_COMPARE(last, 3);
        QTRY_VERIFY(!job.isRunning());
    }
};

SANDREEL_TEST(TestJob)
#include "tst_job.moc"
