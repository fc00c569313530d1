// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/journal/earlier.h"
#include "tests/model/terrain/tin/randomedits.h"
#include "tests/support/testmain.h"

#include <QTest>

#include <cmath>

using namespace model::terrain;

class TestEarlier final : public QObject
{
    Q_OBJECT

private slots:
    void saysWhatACopyWouldSay_data()
    {
        QTest::addColumn<int>("ground");
        for (const tests::Ground ground : tests::EveryGround)
            QTest::newRow(tests::nameOf(ground)) << int(ground);
    }
    /// Against a copy of the TIN, at random points, at its vertices and in the middle of its edges.
    void saysWhatACopyWouldSay()
    {
        QFETCH(int, ground);
        tests::PointSource source(tests::Ground(ground), 4);
        const auto points = source.points(300);
        Tin tin = std::move(buildTin(points, source.domain())->tin);
        const Tin copy = tin;
        EarlierSurface earlier(tin);
        QVERIFY(earlier.isNow());
        int changed = 0;
        for (int round = 0; round < 12; ++round) {
            TinEdit edit(tin);
            for (int step = 0; step < 25; ++step)
                tests::randomStep(edit, source);
            earlier.note(edit.commit());
            std::vector<Point2> places;
            for (int i = 0; i < 100; ++i)
                places.push_back(source.point());
            const TinArrays &arrays = copy.arrays();
            for (int i = 0; i < 50; ++i) {
                const VertexId v = source.below(arrays.vertexSlots());
                places.push_back(arrays.points[v]);
                const Corner c = arrays.corners[v];
                const Point2 a = arrays.pointAt(next(c));
                places.push_back({(arrays.points[v].x + a.x) / 2, (arrays.points[v].y + a.y) / 2});
            }
            for (const Point2 p : places) {
                QCOMPARE(earlier.heightAt(p), copy.heightAt(p));
                changed += tin.heightAt(p) != copy.heightAt(p);
                if (copy.locate(p).kind == Location::Kind::Vertex)
                    continue; // any triangle around it will do
                const Gradient g = copy.gradientAt(p);
                QCOMPARE(earlier.slopeAt(p), std::atan(std::hypot(g.x, g.y)) * 180 / M_PI);
            }
        }
        QVERIFY(!earlier.isNow());
        QVERIFY(changed > 100); // the test saw what it is meant to see
    }
    void theSlopeAtAVertexDoesNotDependOnWhatWasAsked()
    {
        tests::PointSource source(tests::Ground::Grid, 9);
        Tin tin = std::move(buildTin(source.points(200), source.domain())->tin);
        const EarlierSurface before(tin);
        std::vector<double> slopes;
        for (VertexId v = 0; v < 100; ++v)
            slopes.push_back(before.slopeAt(tin.arrays().points[v]));
        const Tin copy = tin;
        EarlierSurface earlier(tin);
        for (int round = 0; round < 8; ++round) {
            TinEdit edit(tin);
            for (int step = 0; step < 40; ++step)
                tests::randomStep(edit, source);
            earlier.note(edit.commit());
        }
        for (VertexId v = 100; v-- > 0;)
            QCOMPARE(earlier.slopeAt(copy.arrays().points[v]), slopes[v]);
    }
};

SANDREEL_TEST(TestEarlier)
#include "tst_earlier.moc"
