// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/haptics/grounds.h"
#include "tests/support/testmain.h"

using namespace model;
using namespace model::haptics;
using namespace std::chrono_literals;
using tests::lengthOf;

namespace {

SafetyInput goodInput(Vec3d wanted)
{
    SafetyInput input;
    input.wanted = wanted;
    input.elapsed = ServoPeriod;
    return input;
}

SafetyGate openGate()
{
    SafetyGate gate;
    SafetyLimits limits;
    limits.userForce = 10;
    limits.power = 1000;
    gate.setLimits(limits);
    gate.start();
    for (int i = 0; i < 2100; ++i)
        gate.filter(goodInput({}));
    return gate;
}

/// Steps with `input` until the force is at rest; the last force.
Vec3d settled(SafetyGate &gate, const SafetyInput &input)
{
    Vec3d force;
    for (int i = 0; i < 200; ++i)
        force = gate.filter(input);
    return force;
}

} // namespace

class TestSafetyGate final : public QObject
{
    Q_OBJECT

private slots:
    void thereIsNoForceBeforeTheStart()
    {
        SafetyGate gate;
        QCOMPARE(settled(gate, goodInput({0, 0, 0.1})), Vec3d());
        QCOMPARE(gate.state(), SafetyState::Stopped);
        QCOMPARE(gate.cause(), SafetyCause::Stopped);
    }

    /// A force that is there already at the start would jump at the hand.
    void waitsForASmallForceAndRisesOverTwoSeconds()
    {
        SafetyGate gate;
        gate.start();
        QCOMPARE(settled(gate, goodInput({0, 0, 3})), Vec3d());
        QCOMPARE(gate.state(), SafetyState::Waiting);
        for (int i = 0; i < 3; ++i)
            gate.filter(goodInput({0, 0, 0.19}));
        QCOMPARE(gate.state(), SafetyState::Waiting);
        gate.filter(goodInput({0, 0, 0.19}));
        QCOMPARE(gate.state(), SafetyState::Rising);
        for (int i = 0; i < 1000; ++i)
            gate.filter(goodInput({0, 0, 2}));
        const Vec3d half = gate.filter(goodInput({0, 0, 2}));
        QVERIFY2(half.z > 0.98 && half.z < 1.02, qPrintable(QString::number(half.z)));
        for (int i = 0; i < 1000; ++i)
            gate.filter(goodInput({0, 0, 2}));
        QCOMPARE(gate.state(), SafetyState::On);
        QCOMPARE(gate.filter(goodInput({0, 0, 2})).z, 2.0);
    }

    void dampsWhileItRises()
    {
        SafetyGate gate;
        gate.start();
        SafetyInput input = goodInput({});
        input.velocity = {0.1, 0, 0};
        const Vec3d force = settled(gate, input);
        QVERIFY2(force.x < -0.08 && force.x > -0.1, qPrintable(QString::number(force.x)));
        input.rate = 300; // a slow loop damps worse than not at all
        QVERIFY(lengthOf(settled(gate, input)) < 1e-9);
    }

    void clampsToTheLeastOfTheLimits()
    {
        SafetyGate gate = openGate();
        QCOMPARE(settled(gate, goodInput({0, 0, 1e9})).z, HardForceLimit);
        SafetyLimits limits = gate.limits();
        limits.userForce = 3;
        gate.setLimits(limits);
        QVERIFY(lengthOf(settled(gate, goodInput({300, 0, 400})) - Vec3d(1.8, 0, 2.4)) < 1e-12);
        limits.deviceForce = 2;
        gate.setLimits(limits);
        QCOMPARE(settled(gate, goodInput({0, 0, 8})).z, 2.0);
        limits.deviceForce = std::nan("");
        gate.setLimits(limits);
        QCOMPARE(settled(gate, goodInput({0, 0, 8})).z, 0.0);
    }

    void limitsThePower()
    {
        SafetyGate gate = openGate();
        SafetyLimits limits = gate.limits();
        limits.power = 2;
        gate.setLimits(limits);
        SafetyInput input = goodInput({0, 0, 8});
        input.velocity = {0, 0, -0.5};
        QCOMPARE(settled(gate, input).z, 4.0);
    }

    void wallsPushBackIntoTheWorkspace()
    {
        SafetyGate gate = openGate();
        SafetyInput input = goodInput({});
        input.position = {0.21, 0, 0};
        QVERIFY(std::abs(settled(gate, input).x + 1.5) < 1e-9);
        input.position = {0, -5, 0};
        QCOMPARE(settled(gate, input), Vec3d(0, 2, 0));
    }

    void slewsUpAndDown()
    {
        SafetyGate gate = openGate();
        QCOMPARE(gate.filter(goodInput({0, 0, 10})).z, 0.5);
        settled(gate, goodInput({0, 0, 10}));
        QCOMPARE(gate.filter(goodInput({0, 0, 1})).z, 8.0);
        // After a pause it goes on from where it was, not to where it would have been.
        SafetyInput late = goodInput({0, 0, 10});
        late.elapsed = 15ms;
        QCOMPARE(gate.filter(late).z, 9.0);
    }

    void fadesForItsCause_data()
    {
        QTest::addColumn<int>("cause");
        for (const SafetyCause cause : {SafetyCause::StaleSnapshot, SafetyCause::LateLoop, SafetyCause::DeviceSilent,
                                        SafetyCause::DeviceLost, SafetyCause::BadNumber, SafetyCause::Stopped})
            QTest::addRow("cause %d", int(cause)) << int(cause);
    }
    void fadesForItsCause()
    {
        QFETCH(int, cause);
        SafetyGate gate = openGate();
        settled(gate, goodInput({0, 0, 9}));
        SafetyInput bad = goodInput({0, 0, 9});
        switch (SafetyCause(cause)) {
        case SafetyCause::StaleSnapshot:
            bad.snapshotAge = 51ms;
            break;
        case SafetyCause::LateLoop:
            bad.elapsed = 21ms;
            break;
        case SafetyCause::DeviceSilent:
            bad.readingAge = 51ms;
            break;
        case SafetyCause::DeviceLost:
            bad.isConnected = false;
            break;
        case SafetyCause::BadNumber:
            bad.wanted.y = std::nan("");
            break;
        default:
            gate.stop();
        }
        const Vec3d first = gate.filter(bad);
        QVERIFY(first.z < 9 && first.z > 0);
        QCOMPARE(gate.state(), SafetyState::Fading);
        QCOMPARE(int(gate.cause()), cause);
        for (int i = 0; i < 30; ++i)
            gate.filter(bad);
        QCOMPARE(gate.filter(bad), Vec3d());

        // What heals begins again with a small force; the two that do not wait for the user.
        settled(gate, goodInput({0, 0, 0.01}));
        const bool isLatched = cause == int(SafetyCause::BadNumber) || cause == int(SafetyCause::Stopped);
        QCOMPARE(gate.state(), isLatched ? SafetyState::Stopped : SafetyState::Rising);
        QCOMPARE(int(gate.cause()), isLatched ? cause : int(SafetyCause::None));
        gate.start();
        settled(gate, goodInput({0, 0, 0.01}));
        QCOMPARE(gate.state(), SafetyState::Rising);
    }

    /// Any sequence of what can go wrong, in any order.
    void keepsItsPromisesWhateverComes()
    {
        for (unsigned seed = 0; seed < 100; ++seed) {
            std::mt19937 random(seed);
            const auto chance = [&](double share) { return std::uniform_real_distribution<>(0, 1)(random) < share; };
            const auto between = [&](double low, double high) {
                return std::uniform_real_distribution<>(low, high)(random);
            };
            const double scale = std::pow(10.0, between(-2, 6));
            const auto anyVector = [&] {
                Vec3d v(between(-scale, scale), between(-scale, scale), between(-scale, scale));
                if (chance(0.002))
                    v.x = std::nan("");
                if (chance(0.002))
                    v.y = INFINITY;
                if (chance(0.002))
                    v.z = 1e300;
                return v;
            };
            SafetyGate gate;
            SafetyLimits limits;
            limits.userForce = between(0.5, 20);
            limits.deviceForce = between(0.5, 20);
            limits.power = between(0.1, 100);
            gate.setLimits(limits);
            const double most = std::min({limits.userForce, limits.deviceForce, HardForceLimit});

            Vec3d before;
            SafetyInput input;
            Time snapshot{0}, reading{0}, now{0};
            Time lastGood{0};
            bool allowed = false;
            int trouble = 0; // steps in which snapshots or readings stay away
            for (int step = 0; step < 4000; ++step) {
                input.elapsed =
                    chance(0.003) ? Time(std::int64_t(between(0, 2e8))) : Time(std::int64_t(between(0.5e6, 1.6e6)));
                now += input.elapsed;
                if (chance(0.004))
                    trouble = int(between(1, 300));
                if (--trouble < 0 || (step % 7 == 0 && chance(0.5)))
                    snapshot = now;
                if (--trouble < 0)
                    reading = now;
                input.snapshotAge = now - snapshot;
                input.readingAge = now - reading;
                input.isConnected = !chance(0.002);
                input.position = chance(0.01) ? anyVector() : Vec3d();
                input.velocity = chance(0.01) ? anyVector() : Vec3d(between(-1, 1), 0, 0);
                if (chance(0.02))
                    input.wanted = anyVector();
                else if (chance(0.05))
                    input.wanted = {};
                if (chance(0.003)) {
                    gate.stop();
                    allowed = false;
                } else if (chance(0.02)) {
                    gate.start();
                    allowed = true;
                }
                const Vec3d force = gate.filter(input);
                QVERIFY(std::isfinite(force.x) && std::isfinite(force.y) && std::isfinite(force.z));
                QVERIFY2(lengthOf(force) <= most * (1 + 1e-12),
                         qPrintable(QString("seed %1 step %2").arg(seed).arg(step)));
                const double dt = seconds(input.elapsed), shortDt = std::min(dt, 0.002);
                QVERIFY(lengthOf(force - before) <= std::max(2000 * shortDt, 10 / 0.030 * dt) + 1e-9);
                QVERIFY(lengthOf(force) - lengthOf(before) <= 500 * shortDt + 1e-9);
                const bool isGood = input.isConnected && std::isfinite(lengthOf(input.wanted)) &&
                                    std::isfinite(lengthOf(input.position)) &&
                                    std::isfinite(lengthOf(input.velocity)) && allowed;
                if (isGood)
                    lastGood = std::min(snapshot, reading);
                if (now - lastGood > 100ms || now - std::min(snapshot, reading) > 100ms)
                    QVERIFY2(force == Vec3d(), qPrintable(QString("seed %1 step %2").arg(seed).arg(step)));
                before = force;
            }
        }
    }
};

SANDREEL_TEST(TestSafetyGate)
#include "tst_safetygate.moc"
