// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/tinedit.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/terrain/tin/cgaljudge.h"
#include "tests/model/terrain/tin/randomedits.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <cmath>

using namespace model;
using namespace model::terrain;

namespace {

QString firstDefect(const Tin &tin)
{
    const auto valid = validate(tin);
    return valid ? QString()
                 : QString::fromStdString(valid.error().args[0]) + ": " + QString::fromStdString(valid.error().args[1]);
}

void everyGround()
{
    QTest::addColumn<int>("ground");
    for (const tests::Ground ground : tests::EveryGround)
        QTest::newRow(tests::nameOf(ground)) << int(ground);
}

/// A square of side 4 with a constraint of owner 7 across the middle, west to east.
struct Crossed
{
    Tin tin{Rectangle{{0, 0}, {4, 4}}};
    VertexId west, east, south, north;

    Crossed()
    {
        TinEdit edit(tin);
        west = edit.insert({1, 2});
        east = edit.insert({3, 2});
        south = edit.insert({2.25, 1});
        north = edit.insert({2.25, 3});
        if (!edit.constrain(west, east, 7))
            qFatal("the constraint was refused");
        edit.commit();
    }
};

} // namespace

class TestTinEdit final : public QObject
{
    Q_OBJECT

private slots:
    void mixedEditsStayCgalsTriangulation_data() { everyGround(); }
    void mixedEditsStayCgalsTriangulation()
    {
        QFETCH(int, ground);
        for (unsigned seed = 0; seed < 4; ++seed) {
            tests::PointSource source(tests::Ground(ground), seed);
            auto built = buildTin(source.points(seed * 40), source.domain());
            QVERIFY(built);
            Tin &tin = built->tin;
            for (int i = 0; i < 400; ++i) {
                {
                    TinEdit edit(tin);
                    tests::randomStep(edit, source);
                    edit.commit();
                }
                QCOMPARE(firstDefect(tin), QString());
                if (i % 10 == 9)
                    QCOMPARE(tests::differenceFromCgal(tin), std::string());
            }
        }
    }

    void removingEverythingLeavesTheDomain_data() { everyGround(); }
    void removingEverythingLeavesTheDomain()
    {
        QFETCH(int, ground);
        tests::PointSource source(tests::Ground(ground), 9);
        auto built = buildTin(source.points(500), source.domain());
        QVERIFY(built);
        TinEdit edit(built->tin);
        for (VertexId v = 4; v < built->tin.arrays().vertexSlots(); ++v) {
            QVERIFY(edit.canRemove(v));
            edit.remove(v);
            if (v % 50 == 0)
                QCOMPARE(tests::differenceFromCgal(built->tin), std::string());
        }
        QCOMPARE(built->tin.vertexCount(), 4u);
        QCOMPARE(built->tin.triangleCount(), 2u);
        edit.commit();
        QCOMPARE(firstDefect(built->tin), QString());
    }

    /// A hub of so many edges that its ears are kept in a queue; all on one circle but for rounding.
    void aHubOfManyEdgesIsRemoved()
    {
        Tin tin(Rectangle{{-2, -2}, {2, 2}});
        TinEdit edit(tin);
        const VertexId hub = edit.insert({0, 0});
        for (int i = 0; i < 500; ++i)
            edit.insert({std::cos(i * 0.0125663706), std::sin(i * 0.0125663706)});
        edit.remove(hub);
        QCOMPARE(tests::differenceFromCgal(tin), std::string());
        edit.commit();
        QCOMPARE(firstDefect(tin), QString());
    }

    void cornersAndConstrainedVerticesStay()
    {
        Crossed crossed;
        TinEdit edit(crossed.tin);
        for (VertexId v = 0; v < 4; ++v)
            QVERIFY(!edit.canRemove(v));
        QVERIFY(!edit.canRemove(crossed.west));
        QVERIFY(edit.canRemove(crossed.south));
        const VertexId border = edit.insert({2, 0});
        QVERIFY(edit.canRemove(border));
        edit.release(crossed.west, crossed.east, 7);
        QVERIFY(edit.canRemove(crossed.west));
    }

    void insertingTwiceFindsTheVertex()
    {
        Tin tin(Rectangle{{0, 0}, {1, 1}});
        TinEdit edit(tin);
        const VertexId v = edit.insert({0.5, 0.25}, 3.0);
        QCOMPARE(edit.insert({0.5, 0.25}), v);
        QCOMPARE(tin.arrays().heights[v], 3.0);
        QCOMPARE(edit.insert({0.5, 0.25}, 4.0), v);
        QCOMPARE(tin.arrays().heights[v], 4.0);
        QCOMPARE(edit.insert({1, 1}), 2u);
    }

    void aVertexOnAConstraintKeepsItOnBothSides()
    {
        Crossed crossed;
        TinEdit edit(crossed.tin);
        const VertexId v = edit.insert({1.5, 2});
        QCOMPARE(crossed.tin.ownersOf(crossed.west, v), std::vector<OwnerId>{7});
        QCOMPARE(crossed.tin.ownersOf(v, crossed.east), std::vector<OwnerId>{7});
        QVERIFY(crossed.tin.isConstrained(crossed.west, v));
        edit.commit();
        QCOMPARE(firstDefect(crossed.tin), QString());
    }

    void aLineGoesThroughTheVerticesOnIt()
    {
        Tin tin(Rectangle{{0, 0}, {4, 4}});
        TinEdit edit(tin);
        const VertexId a = edit.insert({1, 1}), b = edit.insert({2, 2}), c = edit.insert({3, 3});
        QVERIFY(edit.constrain(a, c, 1));
        QVERIFY(tin.isConstrained(a, b) && tin.isConstrained(b, c));
        QVERIFY(!tin.isConstrained(a, c));
        QVERIFY(edit.constrain(0, 1, 1)); // along the border
        QCOMPARE(tin.ownersOf(0, 1), std::vector<OwnerId>{1});
        edit.releaseAll(0, 1);
        QVERIFY(tin.isConstrained(0, 1)); // the border stays
        edit.commit();
        QCOMPARE(firstDefect(tin), QString());
    }

    void crossingLinesAreRefused()
    {
        Crossed crossed;
        TinEdit edit(crossed.tin);
        const std::uint64_t before = crossed.tin.fingerprint();
        const auto refused = edit.constrain(crossed.south, crossed.north, 8);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::CrossingConstraints);
        QCOMPARE(refused.error().args[0], std::to_string(crossed.south));
        QCOMPARE(refused.error().args[1], std::to_string(crossed.north));
        std::vector<std::string> edge{refused.error().args[2], refused.error().args[3]};
        std::sort(edge.begin(), edge.end());
        QCOMPARE(edge, (std::vector{std::to_string(crossed.west), std::to_string(crossed.east)}));
        QCOMPARE(crossed.tin.fingerprint(), before);
    }

    void crossingLinesAreReleased()
    {
        Crossed crossed;
        TinEdit edit(crossed.tin);
        QVERIFY(edit.constrain(crossed.south, crossed.north, 8, Crossing::Release));
        QVERIFY(crossed.tin.isConstrained(crossed.south, crossed.north));
        QVERIFY(!crossed.tin.isConstrained(crossed.west, crossed.east));
        QCOMPARE(crossed.tin.arrays().totals.records, 1u);
    }

    void crossingLinesAreSplitAtTheHeightOfTheOlder()
    {
        Crossed crossed;
        TinEdit edit(crossed.tin, VolumeRule::Keep);
        edit.setHeight(crossed.west, 10);
        edit.setHeight(crossed.east, 20);
        QVERIFY(edit.constrain(crossed.south, crossed.north, 8, Crossing::Split));
        const Location middle = crossed.tin.locate({2.25, 2});
        QCOMPARE(middle.kind, Location::Kind::Vertex);
        const VertexId v = crossed.tin.arrays().vertex(middle.corner);
        QCOMPARE(crossed.tin.arrays().heights[v], 16.25);
        QCOMPARE(crossed.tin.ownersOf(crossed.west, v), std::vector<OwnerId>{7});
        QCOMPARE(crossed.tin.ownersOf(v, crossed.east), std::vector<OwnerId>{7});
        QCOMPARE(crossed.tin.ownersOf(crossed.south, v), std::vector<OwnerId>{8});
        QCOMPARE(crossed.tin.ownersOf(v, crossed.north), std::vector<OwnerId>{8});
        edit.commit();
        QCOMPARE(firstDefect(crossed.tin), QString());
    }

    void ownersShareAnEdgeAndLeaveOneByOne()
    {
        Crossed crossed;
        TinEdit edit(crossed.tin);
        const VertexId a = crossed.west, b = crossed.east;
        QVERIFY(edit.constrain(a, b, 9));
        QVERIFY(edit.constrain(a, b, 9)); // again: nothing more
        QCOMPARE(crossed.tin.ownersOf(a, b).size(), std::size_t(2));
        edit.release(a, b, 7);
        QVERIFY(crossed.tin.isConstrained(a, b));
        edit.release(a, b, 7); // gone already
        edit.releaseOwner(9);
        QVERIFY(!crossed.tin.isConstrained(a, b));
        QCOMPARE(crossed.tin.arrays().totals.records, 0u);
    }

    void voidsAreFencedAndDoNotCount()
    {
        Tin tin(Rectangle{{0, 0}, {4, 4}});
        std::vector<TriangleId> east;
        {
            TinEdit edit(tin, VolumeRule::Keep);
            for (int i = 0; i <= 4; ++i)
                for (int j = 0; j <= 4; ++j)
                    edit.insert({double(i), double(j)}, 1.0);
            for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t)
                if (tin.arrays().pointAt(cornerOf(t, 0)).x >= 3 || tin.arrays().pointAt(cornerOf(t, 1)).x >= 3)
                    east.push_back(t);
            edit.commit();
        }
        QCOMPARE(tin.volume(), 16.0);
        double eastArea = 0;
        for (const TriangleId t : east)
            eastArea += areaOf(tin.arrays(), t);
        QVERIFY(eastArea > 1);
        TinEdit edit(tin, VolumeRule::Keep);
        edit.setVoid(east, true);
        QVERIFY(std::abs(edit.leak() + eastArea) < 1e-12);
        // Nothing crosses the fence, and what is done beside it keeps it whole.
        VertexId fenceA = None, fenceB = None;
        for (const ConstraintRecord &record : tin.arrays().records.values())
            if (record.a != None && record.owner == VoidOwner) {
                fenceA = record.a;
                fenceB = record.b;
            }
        QVERIFY(fenceA != None);
        edit.releaseAll(fenceA, fenceB);
        QVERIFY(tin.isConstrained(fenceA, fenceB));
        const VertexId inside = edit.insert({0.1, 2.05}), outside = edit.insert({3.9, 2.35});
        for (const Crossing crossing : {Crossing::Refuse, Crossing::Release, Crossing::Split}) {
            const auto refused = edit.constrain(inside, outside, 5, crossing);
            QVERIFY(!refused && refused.error().code == ErrorCode::CrossingConstraints);
        }
        for (int i = 1; i < 40; ++i)
            edit.insert({i * 0.1, std::fmod(i * 0.73, 4.0)});
        QCOMPARE(tests::differenceFromCgal(tin), std::string());
        std::vector<TriangleId> all;
        for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t)
            if (tin.arrays().isVoid(t))
                all.push_back(t);
        edit.commit();
        QCOMPARE(firstDefect(tin), QString());
        QVERIFY(std::abs(tin.volume() - (16 - eastArea)) < 1e-12);
        TinEdit back(tin, VolumeRule::Keep);
        back.setVoid(all, false);
        back.commit();
        QCOMPARE(firstDefect(tin), QString());
        QCOMPARE(tin.arrays().totals.records, 0u);
        QVERIFY(std::abs(tin.volume() - 16) < 1e-12);
    }
};

SANDREEL_TEST(TestTinEdit)
#include "tst_tinedit.moc"
