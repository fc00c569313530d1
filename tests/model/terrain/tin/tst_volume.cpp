// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/tinedit.h"
#include "model/terrain/tin/tinwriter.h"
#include "tests/model/terrain/tin/randomedits.h"
#include "tests/support/testmain.h"

#include <cmath>

using namespace model::terrain;

namespace {

/// A wavy square of about a thousand vertices.
BuiltTin waves()
{
    tests::PointSource source(tests::Ground::Random, 17);
    std::vector<Point3> points = source.points(1000);
    for (Point3 &p : points)
        p.z = 5 + 2 * std::sin(9 * p.x) * std::cos(7 * p.y);
    return std::move(*buildTin(points, source.domain()));
}

/// From the triangles, in long double: prisms under each.
double volumeOfTriangles(const TinArrays &tin)
{
    long double sum = 0;
    for (TriangleId t = 0; t < tin.triangleSlots(); ++t) {
        if (!tin.isTriangle(t) || tin.isVoid(t))
            continue;
        const VertexId *v = &tin.triangleVertices[3 * std::size_t(t)];
        const Point2 a = tin.points[v[0]], b = tin.points[v[1]], c = tin.points[v[2]];
        const long double area =
            ((long double)b.x - a.x) * ((long double)c.y - a.y) - ((long double)b.y - a.y) * ((long double)c.x - a.x);
        sum += area / 6 * ((long double)tin.heights[v[0]] + tin.heights[v[1]] + tin.heights[v[2]]);
    }
    return double(sum);
}

double relative(double a, double b)
{
    return std::abs(a - b) / std::abs(b);
}

void ring(TinEdit &edit, Point2 centre, double radius, int corners, OwnerId owner)
{
    VertexId first = None, last = None;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * i / corners;
        const VertexId v =
            edit.insert({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)}, last);
        if (last != None)
            QVERIFY(edit.constrain(last, v, owner, Crossing::Split));
        else
            first = v;
        last = v;
    }
    QVERIFY(edit.constrain(last, first, owner, Crossing::Split));
}

} // namespace

class TestVolume final : public QObject
{
    Q_OBJECT

private slots:
    void dualAreasGiveTheVolume()
    {
        const BuiltTin built = waves();
        QVERIFY(relative(built.tin.volume(), volumeOfTriangles(built.tin.arrays())) < 1e-14);
        QCOMPARE(built.tin.ledger().start, built.tin.volume());
    }

    /// What is displaced is owed, whatever the triangulation does meanwhile, until it is booked or given back.
    void displacedVolumeIsOwed()
    {
        BuiltTin built = waves();
        TinEdit edit(built.tin, VolumeRule::Keep);
        const double before = volumeOfTriangles(built.tin.arrays());
        const VertexId dug = edit.insert({0.5, 0.5}), heap = edit.insert({0.7, 0.5});
        edit.displace(dug, -3);
        edit.insert({0.51, 0.5}); // beside it
        QVERIFY(std::abs(edit.leak() - (volumeOfTriangles(built.tin.arrays()) - before)) < 1e-14);
        const double owed = edit.leak();
        QVERIFY(owed < -1e-4);
        edit.bookLeak(owed / 4);
        QVERIFY(std::abs(edit.leak() - owed * 0.75) < 1e-16);
        edit.giveBack(std::span(&heap, 1));
        edit.bookMoved(-owed * 0.75);
        edit.commit();
        QVERIFY(std::abs(volumeOfTriangles(built.tin.arrays()) - before - owed / 4) < 1e-14);
        QVERIFY(std::abs(built.tin.ledger().removed.value() + owed / 4) < 1e-16);
        QVERIFY(std::abs(built.tin.ledger().moved.value() + owed * 0.75) < 1e-16);
        QVERIFY(std::abs(built.tin.ledger().expected() - built.tin.volume()) < 1e-14);
    }

    /// The leak is worked out from tetrahedra and prisms, step by step; here from the whole surface.
    void theLeakIsWhatTheSurfaceGained()
    {
        BuiltTin built = waves();
        TinEdit edit(built.tin, VolumeRule::Keep);
        const double before = volumeOfTriangles(built.tin.arrays());
        tests::PointSource source(tests::Ground::Random, 3);
        ring(edit, {0.5, 0.5}, 0.2, 32, 1);
        const double afterRing = volumeOfTriangles(built.tin.arrays());
        QVERIFY(std::abs(afterRing - before) > 1e-6); // a leak that matters
        QVERIFY(std::abs(edit.leak() - (afterRing - before)) < 1e-14 * 10);
        for (VertexId v = 4; v < 500; ++v)
            if (edit.canRemove(v))
                edit.remove(v);
        QVERIFY(std::abs(edit.leak() - (volumeOfTriangles(built.tin.arrays()) - before)) < 1e-13);
        edit.releaseOwner(1);
        const double after = volumeOfTriangles(built.tin.arrays());
        QVERIFY(std::abs(edit.leak() - (after - before)) < 1e-13);
        edit.commit();
        QVERIFY(std::abs(built.tin.ledger().kept.value() - (after - before)) < 1e-13);
    }

    void oneEditKeepsTheVolume()
    {
        for (int i = 0; i < 20; ++i) {
            BuiltTin built = waves();
            const double before = built.tin.volume();
            TinEdit edit(built.tin);
            ring(edit, {0.3 + 0.02 * i, 0.6 - 0.015 * i}, 0.04 + 0.01 * i, 12 + i, 1);
            edit.commit();
            QVERIFY(relative(built.tin.volume(), before) < 1e-13);
            QVERIFY(relative(volumeOfTriangles(built.tin.arrays()), before) < 1e-13);
            QVERIFY(relative(built.tin.volume(), built.tin.ledger().expected()) < 1e-13);
        }
    }

    void tenThousandEditsKeepTheBooks()
    {
        tests::PointSource source(tests::Ground::Random, 2);
        auto built = buildTin(source.points(400), source.domain());
        for (VertexId v = 0; v < built->tin.arrays().vertexSlots(); ++v) {
            TinEdit edit(built->tin);
            edit.setHeight(v, 5 + built->tin.arrays().heights[v]);
            edit.commit();
        }
        for (int i = 0; i < 10000; ++i) {
            TinEdit edit(built->tin);
            if (source.below(4) == 0) {
                const VertexId a = built->tin.arrays().triangleVertices[0], b = built->tin.arrays().triangleVertices[1];
                edit.transfer(a, b, source.uniform(-1e-4, 1e-4));
            } else {
                tests::randomStep(edit, source);
            }
            edit.commit();
        }
        const Ledger &ledger = built->tin.ledger();
        QVERIFY(ledger.added.value() > 1 && ledger.removed.value() > 1 && ledger.moved.value() > 0.01);
        QVERIFY(relative(built->tin.volume(), ledger.expected()) < 1e-12);
        QVERIFY(relative(volumeOfTriangles(built->tin.arrays()), ledger.expected()) < 1e-12);
        QVERIFY(std::abs(ledger.kept.value()) < 1e-12);
    }

    /// Needles beside large triangles: a rounded height on the one is a wrong volume under the other.
    void noGroundLosesVolume_data()
    {
        QTest::addColumn<int>("ground");
        for (const tests::Ground ground : tests::EveryGround)
            QTest::newRow(tests::nameOf(ground)) << int(ground);
    }
    void noGroundLosesVolume()
    {
        QFETCH(int, ground);
        tests::PointSource source(tests::Ground(ground), 14);
        auto built = buildTin(source.points(300), source.domain());
        const Rectangle domain = source.domain();
        const double size = (domain.high.x - domain.low.x) * (domain.high.y - domain.low.y);
        for (int i = 0; i < 1500; ++i) {
            TinEdit edit(built->tin, source.below(2) ? VolumeRule::GiveBack : VolumeRule::Keep);
            tests::randomStep(edit, source);
            edit.commit();
        }
        QVERIFY(std::abs(built->tin.volume() - built->tin.ledger().expected()) < 1e-13 * size);
        QVERIFY(std::abs(built->tin.volume() - volumeOfTriangles(built->tin.arrays())) < 1e-13 * size);
    }

    void theLedgerNamesWhatHappened()
    {
        Tin tin(Rectangle{{0, 0}, {2, 3}});
        TinEdit edit(tin);
        const double area0 = edit.areaOf(0), area1 = edit.areaOf(1);
        edit.setHeight(0, 2);
        edit.setHeight(1, -1);
        edit.transfer(0, 1, 0.25);
        edit.commit();
        QCOMPARE(tin.ledger().added.value(), 2 * area0);
        QCOMPARE(tin.ledger().removed.value(), area1);
        QCOMPARE(tin.ledger().moved.value(), 0.25);
        QCOMPARE(tin.arrays().heights[0], 2 - 0.25 / area0);
        QCOMPARE(tin.arrays().heights[1], -1 + 0.25 / area1);
        QVERIFY(std::abs(tin.volume() - (2 * area0 - area1)) < 1e-15);
    }

    void undoTakesTheLedgerBack()
    {
        Tin tin(Rectangle{{0, 0}, {1, 1}});
        TinEdit open(tin);
        open.setHeight(0, 1);
        Edit edit = open.commit();
        tin.swap(edit);
        QCOMPARE(tin.ledger().added.value(), 0.0);
        QCOMPARE(tin.volume(), 0.0);
    }

    void weightsSayWhoGivesBack()
    {
        BuiltTin built = waves();
        TinEdit edit(built.tin);
        ring(edit, {0.5, 0.5}, 0.2, 32, 1);
        const std::vector<VertexId> two{7, 8};
        const std::vector<double> heights{built.tin.arrays().heights[7], built.tin.arrays().heights[8]};
        const double leak = edit.leak();
        edit.giveBack(two, std::vector<double>{3, 1});
        const double up7 = built.tin.arrays().heights[7] - heights[0], up8 = built.tin.arrays().heights[8] - heights[1];
        QVERIFY(std::abs(up7 - 3 * up8) < 1e-12 * std::abs(up7));
        QVERIFY(up7 * leak < 0);
        QVERIFY(std::abs(edit.leak()) < 1e-15);
        const std::vector<double> none{0, 0};
        edit.giveBack(two, none);
    }

    void compensatedSumsLoseNothing()
    {
        CompensatedSum sum;
        double plain = 0;
        sum.add(1e16);
        plain += 1e16;
        for (int i = 0; i < 1000; ++i) {
            sum.add(0.5);
            plain += 0.5;
        }
        sum.add(-1e16);
        plain += -1e16;
        QCOMPARE(sum.value(), 500.0);
        QVERIFY(plain != 500.0);
    }
};

SANDREEL_TEST(TestVolume)
#include "tst_volume.moc"
