// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/erosion/team.h"
#include "tests/support/testmain.h"

#include <stdexcept>
#include <vector>

using namespace model;
using namespace model::terrain;

class TestTeam final : public QObject
{
    Q_OBJECT

private slots:
    void cleanup() { setThreadCount(0); }

    void everyItemIsDoneOnce_data()
    {
        QTest::addColumn<unsigned>("threads");
        for (const unsigned threads : {1u, 2u, 3u, 8u})
            QTest::addRow("%u threads", threads) << threads;
    }
    /// Many short steps of different sizes: a late helper must not take what belongs to another step.
    void everyItemIsDoneOnce()
    {
        QFETCH(unsigned, threads);
        setThreadCount(threads);
        int led = 0;
        Team::run([&](Team &team) {
            ++led;
            for (std::size_t step = 0; step < 3000; ++step) {
                std::vector<std::uint32_t> done(step % 17);
                team.forEach(done.size(), [&](std::size_t i) { done[i] += std::uint32_t(step + 1); });
                for (const std::uint32_t times : done)
                    QCOMPARE(times, std::uint32_t(step + 1));
            }
        });
        QCOMPARE(led, 1);
    }

    void whatABodyThrowsComesToTheLeader()
    {
        setThreadCount(2);
        bool isCaught = false, isDone = false;
        Team::run([&](Team &team) {
            try {
                team.forEach(10, [](std::size_t i) {
                    if (i == 3)
                        throw std::runtime_error("3");
                });
            } catch (const std::runtime_error &) {
                isCaught = true;
            }
            team.forEach(1, [&](std::size_t) { isDone = true; });
        });
        QVERIFY(isCaught && isDone);
    }
};

SANDREEL_TEST(TestTeam)
#include "tst_team.moc"
