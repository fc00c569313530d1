// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/device/simulateddevice.h"
#include "model/haptics/servo/deadline.h"
#include "model/haptics/servo/histogram.h"
#include "tests/model/haptics/grounds.h"
#include "tests/support/testmain.h"

using namespace model;
using namespace model::haptics;
using namespace std::chrono_literals;
using tests::lengthOf;
using tests::VirtualLoop;

class TestServoCore final : public QObject
{
    Q_OBJECT

private slots:
    void forcesAreOffAtTheStart()
    {
        VirtualLoop loop;
        for (int i = 0; i < 5000; ++i)
            QCOMPARE(loop.step({0, 0, -0.03}).force, Vec3d());
    }

    void pressingIsAnswered()
    {
        VirtualLoop loop;
        loop.arm();
        ServoSample sample;
        for (int i = 0; i <= 1000; ++i)
            sample = loop.step({0, 0, 0.05 - 0.00008 * i}); // to 3 cm deep
        QCOMPARE(sample.state, SafetyState::On);
        QVERIFY(std::abs(sample.depth - 0.03) < 1e-9);
        const double expected = loop.feel.crust + loop.feel.resistance * 0.03 + loop.feel.damping * 0.08;
        QVERIFY2(std::abs(sample.force.z - expected) < 0.01, qPrintable(QString::number(sample.force.z)));
    }

    /// The tool stands still, the ground under it jumps: what is felt does not.
    void noJumpAtAChangeOfSnapshots_data()
    {
        QTest::addColumn<int>("period");
        QTest::addColumn<double>("step");
        for (const int period : {1, 5, 20, 45})
            for (const double step : {0.002, 0.02, 0.15})
                QTest::addRow("%d ms, %g m", period, step) << period << step;
    }
    void noJumpAtAChangeOfSnapshots()
    {
        QFETCH(int, period);
        QFETCH(double, step);
        VirtualLoop loop(LawKind::Reference2009); // without memory or yield: it would show every jump
        loop.arm();
        const Vec3d place(0, 0, -0.01);
        for (int i = 0; i < 300; ++i)
            loop.step(place);
        loop.refreshes = false;
        double before = loop.step(place).force.z, largest = 0, least = before, most = before;
        for (int i = 0; i < 3000; ++i) {
            if (i % period == 0)
                loop.refresh(i / period % 2 ? step : 0);
            const double force = loop.step(place).force.z;
            largest = std::max(largest, std::abs(force - before));
            least = std::min(least, force);
            most = std::max(most, force);
            before = force;
        }
        QVERIFY2(largest < 0.1, qPrintable(QString::number(largest)));
        if (period == 45)
            QVERIFY(most - least > 0.4 * std::min(50 * step, 2.0)); // it does follow
    }

    void staleGroundFades()
    {
        VirtualLoop loop;
        loop.arm();
        for (int i = 0; i <= 500; ++i)
            loop.step({0, 0, 0.01 - 0.00008 * i});
        loop.refreshes = false;
        loop.refresh(0);
        int steps = 0;
        ServoSample sample;
        do
            sample = loop.step({0, 0, -0.03});
        while (lengthOf(sample.force) > 0 && ++steps < 200);
        QVERIFY2(steps > 50 && steps <= 100, qPrintable(QString::number(steps)));
        QCOMPARE(sample.cause, SafetyCause::StaleSnapshot);
    }

    void latchedFaultNeedsTheSwitch()
    {
        VirtualLoop loop;
        loop.arm();
        loop.step({0, std::nan(""), 0});
        ServoSample sample;
        for (int i = 0; i < 3000; ++i)
            sample = loop.step({0, 0, 0.05});
        QCOMPARE(sample.state, SafetyState::Stopped);
        QCOMPARE(sample.cause, SafetyCause::BadNumber);
        loop.core.setForces(false);
        loop.step({0, 0, 0.05});
        loop.arm();
        QCOMPARE(loop.step({0, 0, 0.05}).state, SafetyState::On);
    }

    /// Off and on again within the fade: it is heeded when the fade is over.
    void quickSwitchingIsNotLost()
    {
        VirtualLoop loop;
        loop.arm();
        for (int i = 0; i <= 500; ++i)
            loop.step({0, 0, 0.01 - 0.00008 * i});
        loop.core.setForces(false);
        QVERIFY(lengthOf(loop.step({0, 0, -0.03}).force) > 0);
        loop.core.setForces(true);
        QCOMPARE(loop.step({0, 0, -0.03}).state, SafetyState::Fading);
        ServoSample sample;
        for (int i = 0; i < 100; ++i)
            sample = loop.step({0, 0, -0.03});
        QVERIFY(sample.state == SafetyState::Waiting || sample.state == SafetyState::Rising);
    }

    void lateLoopIsSoft()
    {
        VirtualLoop loop;
        for (int i = 0; i < 3000; ++i)
            loop.step({0, 0, 0.05});
        QCOMPARE(loop.core.trustedPeriod(), ServoPeriod);
        for (int i = 0; i < 3; ++i)
            loop.step({0, 0, 0.05}, 7ms);
        QCOMPARE(loop.core.trustedPeriod(), Time(7ms));
        for (int i = 0; i < 2000; ++i)
            loop.step({0, 0, 0.05});
        QCOMPARE(loop.core.trustedPeriod(), ServoPeriod);
    }

    /// The whole loop, with all that can happen to it.
    void keepsItsPromisesWhateverHappens()
    {
        for (unsigned seed = 0; seed < 30; ++seed) {
            std::mt19937 random(seed);
            const auto between = [&](double low, double high) {
                return std::uniform_real_distribution<>(low, high)(random);
            };
            const auto chance = [&](double share) { return between(0, 1) < share; };
            VirtualLoop loop(EveryLaw[seed % std::size(EveryLaw)]);
            loop.settings.gain = between(0, 3);
            loop.settings.limits.userForce = between(1, 12);
            loop.settings.workspace.scale = std::pow(10, between(-1, 3));
            loop.core.publishSettings(loop.settings);
            const double most = std::min(10.0, loop.settings.limits.userForce);
            loop.core.setForces(true);
            Vec3d at(0, 0, 0.01), before;
            Time good = loop.now;
            int silent = 0;
            for (int i = 0; i < 6000; ++i) {
                at = at + Vec3d(between(-1, 1), between(-1, 1), between(-1, 1)) * 0.0005;
                if (chance(0.001))
                    at = Vec3d(between(-1, 1), between(-1, 1), between(-0.1, 0.1));
                if (chance(0.0005))
                    at.x = chance(0.5) ? std::nan("") : 1e300;
                else if (!std::isfinite(at.x) || std::abs(at.x) > 10)
                    at = {};
                if (chance(0.002))
                    loop.refreshes = !loop.refreshes;
                if (chance(0.003))
                    loop.refresh(chance(0.02) ? std::nan("") : between(-0.1, 0.1));
                loop.isConnected = !chance(0.001);
                if (chance(0.001))
                    loop.core.setForces(!loop.core.wantsForces());
                const Time elapsed =
                    chance(0.002) ? Time(std::int64_t(between(0, 3e8))) : Time(std::int64_t(between(0.7e6, 1.5e6)));
                Reading reading;
                loop.now += elapsed;
                if (silent > 0)
                    --silent;
                else if (chance(0.001))
                    silent = int(between(1, 300));
                if (!silent)
                    good = loop.now;
                if (loop.refreshes && i % 20 == 0)
                    loop.refresh(loop.height);
                reading.position = at;
                reading.time = good;
                reading.isConnected = loop.isConnected;
                const ServoSample sample = loop.core.step(reading, loop.now);
                const Vec3d force = sample.force;
                QVERIFY(std::isfinite(force.x) && std::isfinite(force.y) && std::isfinite(force.z));
                QVERIFY(lengthOf(force) <= most * (1 + 1e-12));
                const double dt = seconds(elapsed), shortDt = std::min(dt, 0.002);
                QVERIFY(lengthOf(force - before) <= std::max(2000 * shortDt, 10 / 0.030 * dt) + 1e-9);
                QVERIFY(lengthOf(force) - lengthOf(before) <= 500 * shortDt + 1e-9);
                if (loop.now - good > 100ms)
                    QCOMPARE(force, Vec3d());
                before = force;
            }
        }
    }

    void deadlinesStayOnTheirGrid()
    {
        Deadline deadline(0ms, 1ms);
        QCOMPARE(deadline.due(), Time(1ms));
        QCOMPARE(deadline.advance(1ms + 200us), 0u);
        QCOMPARE(deadline.advance(2ms + 999us), 0u);
        QCOMPARE(deadline.due(), Time(3ms));
        QCOMPARE(deadline.advance(7ms + 300us), 4u); // 4, 5, 6 and 7 have passed
        QCOMPARE(deadline.due(), Time(8ms));
        QCOMPARE(deadline.advance(7ms + 900us), 0u); // a clock that is early makes no burst
        QCOMPARE(deadline.due(), Time(9ms));
    }

    void percentilesAreThoseOfTheValues()
    {
        std::mt19937_64 random(3);
        std::vector<std::int64_t> values;
        Histogram histogram;
        QCOMPARE(histogram.percentile(0.5), Time(0));
        for (int i = 0; i < 20000; ++i) {
            values.push_back(std::int64_t(std::pow(10.0, std::uniform_real_distribution<>(0, 9)(random))));
            histogram.add(Time(values.back()));
        }
        std::sort(values.begin(), values.end());
        for (const double share : {0.001, 0.5, 0.99, 0.999, 1.0}) {
            const double expected = double(values[std::size_t(std::ceil(share * 20000)) - 1]);
            const double found = double(histogram.percentile(share).count());
            QVERIFY2(found >= expected && found <= expected * 1.016 + 1,
                     qPrintable(QString("%1 %2").arg(found).arg(expected)));
        }
        QCOMPARE(histogram.longest(), Time(values.back()));
        for (std::uint32_t bucket = 0; bucket + 1 < Histogram::BucketCount; ++bucket)
            QVERIFY(Histogram::endOf(bucket) < Histogram::endOf(bucket + 1));
    }

    void velocityIsThatOfTheLastFifteenMilliseconds()
    {
        VelocityWindow window;
        Vec3d velocity;
        for (int i = 0; i < 100; ++i)
            velocity = window.add({i < 50 ? 0.0 : (i - 50) * 0.0002, 0, 0}, i * 1ms);
        QVERIFY(std::abs(velocity.x - 0.2) < 1e-9);
        QCOMPARE(window.add({7, 7, 7}, 99ms), velocity); // said again
        VelocityWindow slow;                             // readings further apart than the window
        slow.add({0, 0, 0}, 0ms);
        QVERIFY(std::abs(slow.add({0.01, 0, 0}, 100ms).x - 0.1) < 1e-9);
    }

    void axesOf2009()
    {
        QCOMPARE(fromDevice2009({-100, 0, 100}), Vec3d(0, 0, 0));
        QCOMPARE(fromDevice2009({100, 100, -100}), Vec3d(1, 1, 0.5));
        QVERIFY(lengthOf(toDevice2009(fromDevice2009({12, -34, 56})) - Vec3d(12, -34, 56)) < 1e-12);
        QCOMPARE(forceToDevice2009({1, 2, 3}), Vec3d(1, 3, -2));
    }

    void trajectoriesAreRead()
    {
        const auto read = parseTrajectory("# down\n0 0 0 0.01\n\n1.5 0 0 -0.03 1 # pressed\r\n2 0.01 0 -0.03 1\n");
        QVERIFY(read.has_value());
        QCOMPARE(read->duration(), 2.0);
        QVERIFY(lengthOf(read->at(0.75).position - Vec3d(0, 0, -0.01)) < 1e-12);
        QCOMPARE(read->at(0.75).buttons, 0u);
        QCOMPARE(read->at(1.75).buttons, 1u);
        QCOMPARE(read->at(9).position, Vec3d(0.01, 0, -0.03));
        QCOMPARE(read->at(-1).position, Vec3d(0, 0, 0.01));
    }
    void wrongTrajectoriesAreRefused_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("code");
        QTest::addColumn<int>("line");
        const int syntax = int(ErrorCode::SyntaxError), value = int(ErrorCode::BadValue);
        QTest::newRow("empty") << QByteArray("# nothing\n") << syntax << -1;
        QTest::newRow("word") << QByteArray("0 0 0 0\n1 x 0 0") << syntax << 2;
        QTest::newRow("too few") << QByteArray("0 0 0") << syntax << 1;
        QTest::newRow("too many") << QByteArray("0 0 0 0 1 2") << syntax << 1;
        QTest::newRow("buttons") << QByteArray("0 0 0 0 -1") << syntax << 1;
        QTest::newRow("back in time") << QByteArray("1 0 0 0\n0.5 0 0 0") << value << 2;
        QTest::newRow("no time") << QByteArray("nan 0 0 0") << value << 1;
        QTest::newRow("never") << QByteArray("inf 0 0 0") << value << 1;
        QTest::newRow("far away") << QByteArray("0 0 11 0") << value << 1;
        QTest::newRow("nowhere") << QByteArray("0 0 nan 0") << value << 1;
    }
    void wrongTrajectoriesAreRefused()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, code);
        QFETCH(int, line);
        const auto read = parseTrajectory(text.toStdString());
        QVERIFY(!read);
        QCOMPARE(int(read.error().code), code);
        QCOMPARE(std::int64_t(read.error().line), std::int64_t(line));
    }

    /// The grip is a spring with a damper: against the solution of its equation.
    void handSwingsAsItsEquationSays()
    {
        SimulatedHand hand;
        hand.damping = 0.8; // swings
        const double m = hand.mass, b = hand.damping, k = hand.stiffness;
        const double decay = b / (2 * m), omega = std::sqrt(k / m - decay * decay);
        for (int i = 1; i <= 300; ++i) {
            hand.advance({0.01, 0, 0}, {0.3, 0, 0}, 0.001);
            const double end = 0.01 + 0.3 / k, t = i * 0.001;
            const double expected =
                end * (1 - std::exp(-decay * t) * (std::cos(omega * t) + decay / omega * std::sin(omega * t)));
            QVERIFY(std::abs(hand.position.x - expected) < 2e-5);
        }
    }
};

SANDREEL_TEST(TestServoCore)
#include "tst_servocore.moc"
