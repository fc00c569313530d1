// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"
#include "views/widgets/rateplot.h"

#include <QSignalSpy>
#include <QTest>

using views::RatePlot;
using views::RatePoint;

class TestRatePlot final : public QObject
{
    Q_OBJECT

private:
    static void fill(RatePlot &plot)
    {
        plot.resize(400, 240);
        plot.addPoint({2, 1.0, 0.5, "one"});
        plot.addPoint({2, 0.1, 5.0, "two"});
        plot.addPoint({1, 10.0, 0.05, "three"});
    }

private slots:
    void axesAreLogarithmic()
    {
        RatePlot plot;
        fill(plot);
        const QPointF one = plot.placeOf(0), two = plot.placeOf(1), three = plot.placeOf(2);
        // A tenth of the size, ten times the error: as far to the other side.
        QVERIFY(std::abs((one.x() - two.x()) - (three.x() - one.x())) < 1e-6);
        QVERIFY(std::abs((one.y() - two.y()) - (three.y() - one.y())) < 1e-6);
        QVERIFY(two.x() < one.x() && two.y() < one.y()); // smaller is left, worse is above
        for (const QPointF place : {one, two, three})
            QVERIFY(QRectF(plot.rect()).contains(place));
    }

    void pointsComeOnce()
    {
        RatePlot plot;
        fill(plot);
        QCOMPARE(plot.addPoint({2, 0.1, 5.0, "two"}), 1);
        QCOMPARE(plot.points().size(), std::size_t(3));
        QCOMPARE(plot.addPoint({1, 0, 1, "no size"}), -1);
        QCOMPARE(plot.addPoint({1, 3, 0, "no error"}), 3);
        QVERIFY(QRectF(plot.rect()).contains(plot.placeOf(3)));
        plot.setCurrent(3);
        plot.clear();
        QCOMPARE(plot.points().size(), std::size_t(0));
        QCOMPARE(plot.current(), -1);
    }

    void clickChooses()
    {
        RatePlot plot;
        fill(plot);
        plot.show();
        QVERIFY(QTest::qWaitForWindowExposed(&plot));
        QSignalSpy chosen(&plot, &RatePlot::pointChosen);
        QTest::mouseClick(&plot, Qt::LeftButton, {}, plot.placeOf(1).toPoint());
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(chosen[0][0].toInt(), 1);
        QTest::mouseClick(&plot, Qt::LeftButton, {}, (plot.placeOf(1) + QPointF(40, 0)).toPoint());
        QTest::mouseClick(&plot, Qt::RightButton, {}, plot.placeOf(1).toPoint());
        QCOMPARE(chosen.size(), 1);
    }

    void keysWalkFromLeftToRight()
    {
        RatePlot plot;
        fill(plot);
        plot.show();
        QVERIFY(QTest::qWaitForWindowExposed(&plot));
        QSignalSpy chosen(&plot, &RatePlot::pointChosen);
        QTest::keyClick(&plot, Qt::Key_Return); // nothing is marked
        QCOMPARE(chosen.size(), 0);
        for (int i = 0; i < 5; ++i) {
            QTest::keyClick(&plot, Qt::Key_Right);
            QTest::keyClick(&plot, Qt::Key_Return);
        }
        QTest::keyClick(&plot, Qt::Key_Left);
        QTest::keyClick(&plot, Qt::Key_Space);
        QList<int> order;
        for (const auto &arguments : chosen)
            order << arguments[0].toInt();
        QCOMPARE(order, (QList<int>{1, 0, 2, 2, 2, 0}));
        QCOMPARE(plot.accessibleDescription(), QString("one"));
    }

    void pointsAreDrawnInTheColourOfTheirSeries()
    {
        RatePlot plot;
        fill(plot);
        const QImage picture = plot.grab().toImage();
        const auto colour = [&](int i) { return picture.pixelColor(plot.placeOf(i).toPoint()); };
        // What lies below shines through.
        QVERIFY(std::abs(colour(0).hslHueF() - colour(1).hslHueF()) < 0.02f);
        QVERIFY(std::abs(colour(0).hslHueF() - colour(2).hslHueF()) > 0.1f);
        QVERIFY(colour(0) != plot.palette().color(QPalette::Base));
    }

    void emptyPlotIsDrawn()
    {
        RatePlot plot;
        plot.resize(1, 1);
        plot.grab();
        plot.resize(300, 200);
        QVERIFY(!plot.grab().isNull());
        QVERIFY(!plot.accessibleName().isEmpty());
    }
};

SANDREEL_TEST(TestRatePlot)
#include "tst_rateplot.moc"
