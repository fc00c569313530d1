// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/timemap.h"
#include "tests/support/testmain.h"

#include <cmath>

using namespace model;

class TestTimeMap final : public QObject
{
    Q_OBJECT

    static bool isNear(const TimeMap &map, const std::vector<double> &expected, double tolerance = 1e-12)
    {
        if (map.frameCount() != expected.size())
            return false;
        for (std::size_t i = 0; i < expected.size(); ++i)
            if (std::abs(map.sourcePosition(std::uint32_t(i)) - expected[i]) > tolerance)
                return false;
        return true;
    }

private slots:
    void identityShowsEveryFrameOnce()
    {
        const TimeMap map = TimeMap::identity(4);
        QVERIFY(map == TimeMap({0, 1, 2, 3}));
        QVERIFY(map.isIdentity(4));
        QVERIFY(!map.isIdentity(3));
        QVERIFY(!map.isIdentity(5));
        QVERIFY(!TimeMap({0, 2, 1, 3}).isIdentity(4));
        QVERIFY(!TimeMap({0, 1, 2, 2.5}).isIdentity(4));
    }

    void trimmingKeepsBothEnds()
    {
        const TimeMap map({0, 0.5, 1, 1.5, 2});
        QVERIFY(map.trimmed(1, 3) == TimeMap({0.5, 1, 1.5}));
        QVERIFY(map.trimmed(4, 4) == TimeMap({2}));
        QVERIFY(map.trimmed(0, 4) == map);
    }

    void reversingTwiceChangesNothing()
    {
        const TimeMap map({0, 0.25, 3, 1});
        QVERIFY(map.reversed() == TimeMap({1, 3, 0.25, 0}));
        QVERIFY(map.reversed().reversed() == map);
    }

    void resampledByHand()
    {
        const TimeMap five = TimeMap::identity(5);
        QVERIFY(five.resampled(25, 50) == TimeMap({0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4}));
        QVERIFY(five.resampled(24, 12) == TimeMap({0, 2, 4}));
        QVERIFY(isNear(five.resampled(30, 24), {0, 4.0 / 3, 8.0 / 3, 4})); // 4 * 24 / 30 = 3.2 steps: 3
        QVERIFY(isNear(five.resampled(24, 30), {0, 0.8, 1.6, 2.4, 3.2, 4}));
        QVERIFY(five.resampled(24, 24) == five);
        QVERIFY(five.resampled(100, 1) == TimeMap({0, 4})); // both ends stay
        QVERIFY(TimeMap({3}).resampled(1, 100) == TimeMap({3}));
    }

    void endsAreExactAndStepsEven_data()
    {
        QTest::addColumn<int>("frames");
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        for (const int frames : {2, 3, 187, 201, 1999})
            for (const double from : {1.0, 23.976, 25.0, 120.0})
                for (const double to : {1.0, 24.0, 29.97, 30.0, 119.88})
                    QTest::addRow("%d frames %g to %g", frames, from, to) << frames << from << to;
    }
    void endsAreExactAndStepsEven()
    {
        QFETCH(int, frames);
        QFETCH(double, from);
        QFETCH(double, to);
        const TimeMap map = TimeMap::identity(std::uint32_t(frames)).resampled(from, to);
        const std::uint32_t last = map.frameCount() - 1;
        QCOMPARE(std::uint64_t(map.frameCount()), TimeMap::resampledFrameCount(std::uint32_t(frames), from, to));
        QCOMPARE(map.sourcePosition(0), 0.0);
        QCOMPARE(map.sourcePosition(last), double(frames - 1));
        // The duration is kept to half a frame of the new rate, or there is one step.
        QVERIFY(last == 1 || std::abs(last / to - (frames - 1) / from) <= 0.5 / to + 1e-9);
        for (std::uint32_t i = 0; i <= last; ++i) {
            const long double exact = (long double)(i) * (frames - 1) / last;
            QVERIFY(std::abs(map.sourcePosition(i) - double(exact)) <= 2e-9);
        }
    }

    void higherRateAndBackIsExact_data()
    {
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::newRow("25 to 30") << 25.0 << 30.0;
        QTest::newRow("24 to 25") << 24.0 << 25.0;
        QTest::newRow("23.976 to 59.94") << 23.976 << 59.94;
        QTest::newRow("7 to 120") << 7.0 << 120.0;
    }
    void higherRateAndBackIsExact()
    {
        QFETCH(double, from);
        QFETCH(double, to);
        for (const std::uint32_t frames : {1u, 2u, 5u, 97u, 201u, 5000u}) {
            const TimeMap map = TimeMap::identity(frames);
            QVERIFY(map.resampled(from, to).resampled(to, from).isIdentity(frames));
            QVERIFY(map.reversed().resampled(from, to).resampled(to, from).reversed().isIdentity(frames));
        }
    }

    void framesLeftOutComeBack()
    {
        const TimeMap every = TimeMap::identity(13);
        const TimeMap third = every.resampled(30, 10);
        QVERIFY(third == TimeMap({0, 3, 6, 9, 12}));
        QVERIFY(third.resampled(10, 30) == every);
        QVERIFY(third.reversed().resampled(10, 30) == every.reversed());
        QVERIFY(third.trimmed(1, 3).resampled(10, 30) == every.trimmed(3, 9));
    }

    void manyResamplingsDoNotDrift()
    {
        TimeMap map = TimeMap::identity(101);
        for (int i = 0; i < 50; ++i)
            map = map.resampled(24, 25).resampled(25, 60).resampled(60, 25).resampled(25, 24);
        QVERIFY(map.isIdentity(101));
    }

    void acrossACutNothingIsBlended_data()
    {
        QTest::addColumn<QList<double>>("positions");
        QTest::addColumn<QList<double>>("expected"); // at twice the rate
        QTest::newRow("cut forward") << QList<double>{0, 1, 2, 50, 51}
                                     << QList<double>{0, .5, 1, 1.5, 2, 50, 50, 50.5, 51};
        QTest::newRow("cut backward") << QList<double>{50, 51, 3, 4} << QList<double>{50, 50.5, 51, 3, 3, 3.5, 4};
        QTest::newRow("cut at the end") << QList<double>{0, 1, 9} << QList<double>{0, .5, 1, 9, 9};
        QTest::newRow("cut at the start") << QList<double>{9, 1, 0} << QList<double>{9, 1, 1, .5, 0};
        QTest::newRow("every fourth frame") << QList<double>{0, 4, 8} << QList<double>{0, 2, 4, 6, 8};
        QTest::newRow("there and back") << QList<double>{0, 2, 4, 2, 0} << QList<double>{0, 1, 2, 3, 4, 3, 2, 1, 0};
        QTest::newRow("held frame") << QList<double>{0, 0, 1, 1} << QList<double>{0, 0, 0, .5, 1, 1, 1};
        QTest::newRow("two frames alone") << QList<double>{0, 10} << QList<double>{0, 5, 10};
        QTest::newRow("half speed, then double")
            << QList<double>{0, .5, 1, 3, 5} << QList<double>{0, .25, .5, .75, 1, 2, 3, 4, 5};
    }
    void acrossACutNothingIsBlended()
    {
        QFETCH(QList<double>, positions);
        QFETCH(QList<double>, expected);
        const TimeMap map(std::vector<double>(positions.begin(), positions.end()));
        const TimeMap doubled = map.resampled(12, 24);
        QCOMPARE(QList<double>(doubled.sourcePositions().begin(), doubled.sourcePositions().end()), expected);
    }

    void resampledCountIsSafeForAnyRates()
    {
        QCOMPARE(TimeMap::resampledFrameCount(1, 1e-300, 1e300), quint64(1));
        QCOMPARE(TimeMap::resampledFrameCount(2, 1e300, 1e-300), quint64(2));
        QVERIFY(TimeMap::resampledFrameCount(1000, 1e-300, 1e300) > TimeMap::MaxFrameCount);
        QCOMPARE(TimeMap::resampledFrameCount(201, 25, 30), quint64(241));
    }
};

SANDREEL_TEST(TestTimeMap)
#include "tst_timemap.moc"
