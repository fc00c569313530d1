// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/contours.h"
#include "model/terrain/tin/tinedit.h"
#include "tests/model/io/terrain/terrains.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <limits>

using namespace model;
using namespace model::io;
using namespace model::terrain;

class TestContours final : public QObject
{
    Q_OBJECT

private slots:
    void ofAPyramid()
    {
        Tin tin({{0, 0}, {10, 10}});
        TinEdit edit(tin);
        edit.insert({5, 5}, 5.0);
        edit.commit();
        const auto contours = contoursOf(tin, 2);
        QVERIFY(contours.has_value());
        // A vertex just at a level counts as above it: level 0 is no line, as all of the ground is at it or above.
        QCOMPARE(contours->size(), std::size_t(2));
        for (const Contour &contour : *contours) {
            QVERIFY(contour.isClosed);
            QCOMPARE(contour.points.size(), std::size_t(5));
            QCOMPARE(contour.points.front(), contour.points.back());
            double area = 0;
            for (std::size_t i = 0; i + 1 < contour.points.size(); ++i)
                area += contour.points[i].x * contour.points[i + 1].y - contour.points[i].y * contour.points[i + 1].x;
            // A square of side 2 (5 - level), around the higher ground counter-clockwise.
            QVERIFY(std::abs(area / 2 - 4 * (5 - contour.level) * (5 - contour.level)) < 1e-12);
        }
        QCOMPARE(contours->at(0).level, 2.0);
        QCOMPARE(contours->at(1).level, 4.0);
    }

    /// Every point lies on the surface at its level, and no line misses a crossed edge.
    void liesOnTheSurface_data()
    {
        QTest::addColumn<int>("ground");
        for (const tests::Ground ground : tests::EveryGround)
            QTest::newRow(tests::nameOf(ground)) << int(ground);
    }
    void liesOnTheSurface()
    {
        QFETCH(int, ground);
        const Terrain terrain = tests::specimenTerrain(tests::Ground(ground), 5, 200);
        const TinArrays &tin = terrain.tin.arrays();
        const double interval = 0.21;
        const auto contours = contoursOf(terrain.tin, interval);
        QVERIFY(contours.has_value() && !contours->empty());
        // A point is rounded, in a plane that may be as steep as a sliver is thin: that is a height too.
        double steepest = 0, farthest = 0;
        for (TriangleId t = 0; t < tin.triangleSlots(); ++t)
            if (tin.isTriangle(t)) {
                const Gradient g = gradientOf(tin, t);
                steepest = std::max(steepest, std::hypot(g.x, g.y));
            }
        for (VertexId v = 0; v < tin.vertexSlots(); ++v)
            farthest = std::max({farthest, std::abs(tin.points[v].x), std::abs(tin.points[v].y)});
        const double rounding = 4 * std::numeric_limits<double>::epsilon() * farthest * steepest;
        std::size_t points = 0;
        for (const Contour &contour : *contours) {
            for (const Point2 &p : contour.points) {
                const double off = std::abs(terrain.tin.heightAt(p) - contour.level);
                QVERIFY2(off < 1e-6 + rounding, qPrintable(QString("%1, rounding %2").arg(off).arg(rounding)));
            }
            points += contour.points.size() - contour.isClosed;
        }
        // Counted by edges: each that has ground beside it is crossed once by each level between its ends.
        std::size_t crossings = 0;
        for (TriangleId t = 0; t < tin.triangleSlots(); ++t)
            for (Corner c = cornerOf(t, 0); tin.isTriangle(t) && c <= cornerOf(t, 2); ++c) {
                const Corner o = tin.opposite(c);
                const bool isGround = !tin.isVoid(t), isOther = o != NoCorner && !tin.isVoid(triangleOf(o));
                if ((o != NoCorner && o < c) || (!isGround && !isOther))
                    continue;
                const double a = tin.heights[tin.vertex(next(c))], b = tin.heights[tin.vertex(previous(c))];
                for (double k = std::ceil(std::min(a, b) / interval); k * interval <= std::max(a, b); ++k)
                    crossings += (a >= k * interval) != (b >= k * interval);
            }
        QVERIFY(points <= crossings);
        QVERIFY2(double(points) > 0.95 * double(crossings), QByteArray::number(int(crossings - points)).constData());
    }

    void flatGroundHasNone() { QVERIFY(contoursOf(tests::plainTerrain().tin, 1)->empty()); }

    void tooMany()
    {
        Tin tin({{0, 0}, {10, 10}});
        TinEdit edit(tin);
        edit.insert({5, 5}, 5.0);
        edit.commit();
        SANDREEL_COMPARE_ERROR(contoursOf(tin, 1e-9), ErrorCode::LimitExceeded);
        const Progress progress;
        progress.cancel();
        SANDREEL_COMPARE_ERROR(contoursOf(tin, 1, 0, progress), ErrorCode::Cancelled);
    }
};

SANDREEL_TEST(TestContours)
#include "tst_contours.moc"
