// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/base/taskqueue.h"
#include "tests/support/testmain.h"

#include <atomic>
#include <new>
#include <thread>

using namespace model;

class TestTaskQueue final : public QObject
{
    Q_OBJECT

private slots:
    void cleanup() { setThreadCount(0); }

    void tasksRunInTheirOrder_data()
    {
        QTest::addColumn<unsigned>("threads");
        QTest::newRow("one thread") << 1u;
        QTest::newRow("two") << 2u;
    }
    void tasksRunInTheirOrder()
    {
        QFETCH(unsigned, threads);
        setThreadCount(threads);
        std::vector<int> wanted, done;
        TaskQueue queue(2);
        for (int i = 0; i < 1000; ++i) {
            wanted.push_back(i);
            queue.run([&done, i] { done.push_back(i); });
        }
        queue.finish();
        QVERIFY(done == wanted);
        queue.run([&done] { done.push_back(-1); }); // it can be used again
        queue.finish();
        QCOMPARE(done.back(), -1);
    }

    void theyRunInAThreadOfTheirOwn()
    {
        setThreadCount(2);
        std::thread::id id;
        TaskQueue queue(1);
        queue.run([&id] { id = std::this_thread::get_id(); });
        queue.finish();
        QVERIFY(id != std::thread::id());
        QVERIFY(id != std::this_thread::get_id());
    }

    void noMoreThanAllowedWait()
    {
        setThreadCount(2);
        std::atomic<int> waiting = 0, most = 0;
        TaskQueue queue(3);
        for (int i = 0; i < 200; ++i) {
            queue.run([&] { --waiting; });
            most = std::max(most.load(), ++waiting);
        }
        queue.finish();
        QVERIFY(most <= 5); // three that wait, one that runs, one counted late
    }

    void whatATaskThrowsComesOutOfFinish()
    {
        setThreadCount(2);
        int after = 0;
        TaskQueue queue(4);
        queue.run([] { throw std::bad_alloc(); });
        QVERIFY_EXCEPTION_THROWN(queue.finish(), std::bad_alloc);
        queue.run([&after] { ++after; });
        QVERIFY_EXCEPTION_THROWN(queue.finish(), std::bad_alloc);
        QCOMPARE(after, 0);
    }

    void goingAwayDropsWhatWasNotBegun()
    {
        setThreadCount(2);
        std::atomic<bool> begun = false, mayEnd = false;
        std::atomic<int> done = 0;
        {
            TaskQueue queue(10);
            queue.run([&] {
                begun = true;
                while (!mayEnd)
                    std::this_thread::yield();
                ++done;
            });
            for (int i = 0; i < 5; ++i)
                queue.run([&] { ++done; });
            while (!begun)
                std::this_thread::yield();
            std::jthread([&] { mayEnd = true; }).join();
        }
        QVERIFY(done >= 1);
    }
};

SANDREEL_TEST(TestTaskQueue)
#include "tst_taskqueue.moc"
