// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/servo/servocore.h"
#include "tests/model/haptics/handloop.h"
#include "tests/support/testmain.h"

using namespace model::haptics;

/// Where the loop of ground, device and hand is stable.
class TestHandLoop final : public QObject
{
    Q_OBJECT

private slots:
    /// A spring that answers late by d takes K d of the damping: K < b / (d + T / 2), the half period being the hold
    /// between two steps (Colgate and Schenkel 1994; Gil and others 2004 for delays).
    void isStableUpToWhatTheDampingPays_data()
    {
        QTest::addColumn<int>("delay");
        QTest::addColumn<double>("damping");
        for (const int delay : {0, 1, 2, 5})
            for (const double damping : {1.5, 3.0})
                QTest::addRow("%d ms, %g N s/m", delay, damping) << delay << damping;
    }
    void isStableUpToWhatTheDampingPays()
    {
        QFETCH(int, delay);
        QFETCH(double, damping);
        SimulatedHand hand;
        hand.damping = damping;
        const double found = tests::stiffestStable(delay, hand), expected = damping / ((delay + 0.5) * 0.001);
        QVERIFY2(found > 0.7 * expected && found < 1.4 * expected,
                 qPrintable(QString("%1 N/m, expected %2").arg(found).arg(expected)));
    }

    /// What the servo allows at its rate, it can render: with a device that answers 2 ms late, and no yielding.
    void whatTheServoAllowsIsStable()
    {
        const double allowed = 2 * 0.5 * Capabilities().damping / seconds(ServoPeriod);
        QCOMPARE(allowed, 1000.0);
        for (const int delay : {0, 1, 2})
            QVERIFY(tests::comesToRest(allowed, delay));
        for (const model::terrain::MaterialPreset preset : model::terrain::EveryMaterialPreset)
            QVERIFY(feelOf(model::terrain::material(preset), 0).elasticity <= allowed);
    }
};

SANDREEL_TEST(TestHandLoop)
#include "tst_handloop.moc"
