// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/base/progress.h"
#include "tests/support/testmain.h"

#include <atomic>
#include <vector>

using namespace model;

class TestProgress final : public QObject
{
    Q_OBJECT

private slots:
    void partsMapOntoTheirShare()
    {
        double last = -1;
        const Progress progress([&](double fraction) { last = fraction; });
        const Progress second = progress.part(0.5, 1.0);
        second.report(0.5);
        QCOMPARE(last, 0.75);
        second.part(0.8, 1.0).report(1.0);
        QCOMPARE(last, 1.0);
    }

    void neverFalls()
    {
        std::vector<double> reports;
        const Progress progress([&](double fraction) { reports.push_back(fraction); });
        progress.report(0.5);
        progress.report(0.2);
        progress.report(0.6);
        QVERIFY(reports == std::vector<double>({0.5, 0.6}));
    }

    void cancelReachesEveryPart()
    {
        const Progress progress;
        const Progress part = progress.part(0, 0.5);
        QVERIFY(!part.isCancelled());
        progress.cancel();
        QVERIFY(part.isCancelled());
    }

    void everyIndexIsVisitedOnce_data()
    {
        QTest::addColumn<unsigned>("threads");
        QTest::newRow("one") << 1u;
        QTest::newRow("four") << 4u;
    }
    void everyIndexIsVisitedOnce()
    {
        QFETCH(unsigned, threads);
        setThreadCount(threads);
        std::vector<std::atomic<int>> visits(1003);
        parallelFor(visits.size(), [&](std::size_t i) { ++visits[i]; });
        parallelRanges(visits.size(), 100, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                ++visits[i];
        });
        setThreadCount(0);
        for (const auto &count : visits)
            QCOMPARE(count.load(), 2);
        parallelFor(0, [](std::size_t) { QFAIL("called for nothing"); });
    }

    void whatABodyThrowsReachesTheCaller_data() { everyIndexIsVisitedOnce_data(); }
    void whatABodyThrowsReachesTheCaller()
    {
        QFETCH(unsigned, threads);
        setThreadCount(threads);
        constexpr std::size_t Count = 1'000'000, Bad = 10;
        std::atomic<std::size_t> visited = 0;
        const auto run = [&] {
            parallelFor(Count, [&](std::size_t i) {
                ++visited;
                if (i == Bad)
                    throw std::bad_alloc();
            });
        };
        QVERIFY_EXCEPTION_THROWN(run(), std::bad_alloc);
        setThreadCount(0);
        QVERIFY(visited > Bad);
        QVERIFY(visited < Count); // the rest was not begun
    }
};

SANDREEL_TEST(TestProgress)
#include "tst_progress.moc"
