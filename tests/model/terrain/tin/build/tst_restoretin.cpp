// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/build/restoretin.h"
#include "model/terrain/tin/tinedit.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/terrain/tin/randomedits.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

using namespace model;
using namespace model::terrain;

namespace {

/// The arrays of a TIN without free slots and without what restoreTin() makes itself; vertices and triangles numbered
/// anew at random, but for the corners.
struct Parts
{
    TinArrays arrays;
    std::vector<ConstrainedEdge> edges;
    std::vector<VertexId> vertexOf; ///< of the old number
};

Parts partsOf(const Tin &tin, unsigned seed)
{
    const TinArrays &from = tin.arrays();
    Parts parts;
    parts.arrays.totals.ledger = tin.ledger();
    std::vector<VertexId> vertices;
    std::vector<TriangleId> triangles;
    for (VertexId v = 4; v < from.vertexSlots(); ++v)
        if (from.isVertex(v))
            vertices.push_back(v);
    for (TriangleId t = 0; t < from.triangleSlots(); ++t)
        if (from.isTriangle(t))
            triangles.push_back(t);
    std::mt19937 random(seed);
    std::shuffle(vertices.begin(), vertices.end(), random);
    std::shuffle(triangles.begin(), triangles.end(), random);
    vertices.insert(vertices.begin(), {0, 1, 2, 3});
    parts.vertexOf.assign(from.vertexSlots(), None);
    std::vector<TriangleId> triangleOfOld(from.triangleSlots(), None);
    TinArrays &to = parts.arrays;
    to.totals.layers = from.totals.layers;
    to.resizeVertices(vertices.size());
    to.resizeTriangles(triangles.size());
    for (VertexId v = 0; v < vertices.size(); ++v) {
        parts.vertexOf[vertices[v]] = v;
        to.points[v] = from.points[vertices[v]];
        to.heights[v] = from.heights[vertices[v]];
        for (std::uint32_t l = 0; l < from.layerCount(); ++l) {
            to.thicknesses[to.layerSlot(v, l)] = from.sample(vertices[v], l).thickness;
            to.humidities[to.layerSlot(v, l)] = from.sample(vertices[v], l).humidity;
        }
    }
    for (TriangleId t = 0; t < triangles.size(); ++t)
        triangleOfOld[triangles[t]] = t;
    for (TriangleId t = 0; t < triangles.size(); ++t)
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner old = cornerOf(triangles[t], i), o = from.opposite(old);
            to.triangleVertices[slotOf(cornerOf(t, i))] = parts.vertexOf[from.vertex(old)];
            to.opposites[slotOf(cornerOf(t, i))] =
                o == NoCorner ? NoCorner : cornerOf(triangleOfOld[triangleOf(o)], o & 3);
            to.triangleFlags[t] = from.triangleFlags[triangles[t]];
        }
    for (const ConstrainedEdge &edge : constrainedEdges(from))
        parts.edges.push_back({parts.vertexOf[edge.a], parts.vertexOf[edge.b], edge.owner});
    return parts;
}

Tin specimen(tests::Ground ground, unsigned seed, bool hasVoid = true)
{
    tests::PointSource source(ground, seed);
    auto built = buildTin(source.points(300), source.domain());
    TinEdit edit(built->tin);
    edit.addLayer(0, 3);
    edit.addLayer(1, 5);
    for (int step = 0; step < 200; ++step)
        tests::randomStep(edit, source);
    std::vector<TriangleId> some;
    for (TriangleId t = 0; t < built->tin.arrays().triangleSlots() && hasVoid && some.size() < 20; ++t)
        if (built->tin.arrays().isTriangle(t))
            some.push_back(t);
    edit.setVoid(some, true);
    edit.commit();
    return std::move(built->tin);
}

} // namespace

class TestRestoreTin final : public QObject
{
    Q_OBJECT

private slots:
    void whatIsTakenApartIsPutTogether_data()
    {
        QTest::addColumn<int>("ground");
        for (const tests::Ground ground : tests::EveryGround)
            QTest::newRow(tests::nameOf(ground)) << int(ground);
    }
    void whatIsTakenApartIsPutTogether()
    {
        QFETCH(int, ground);
        for (unsigned seed = 1; seed < 8; ++seed) {
            const Tin tin = specimen(tests::Ground(ground), seed);
            Parts parts = partsOf(tin, seed);
            const auto edges = parts.edges;
            const auto restored = restoreTin(std::move(parts.arrays), tin.domain(), edges, LedgerStart::Kept);
            QVERIFY2(restored.has_value(), restored ? "" : restored.error().args[0].c_str());
            const auto defects = findDefects(*restored);
            QVERIFY2(defects.empty(), defects.empty() ? "" : nameOf(defects[0].rule));
            QCOMPARE(restored->vertexCount(), tin.vertexCount());
            QCOMPARE(restored->triangleCount(), tin.triangleCount());
            QCOMPARE(restored->arrays().totals.records, tin.arrays().totals.records);
            QCOMPARE(restored->ledger().expected(), tin.ledger().expected());
            QCOMPARE(restored->arrays().totals.layers, tin.arrays().totals.layers);
            for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
                for (std::uint32_t l = 0; tin.arrays().isVertex(v) && l < 2; ++l)
                    QCOMPARE(restored->arrays().sample(parts.vertexOf[v], l), tin.arrays().sample(v, l));
            for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
                if (tin.arrays().isVertex(v))
                    QVERIFY(std::abs(dualArea(tin.arrays(), v) - dualArea(restored->arrays(), parts.vertexOf[v])) <=
                            1e-12 * dualArea(tin.arrays(), v));
            for (const ConstraintRecord &record : tin.arrays().records.values())
                if (record.a != None) {
                    auto before = tin.ownersOf(record.a, record.b);
                    auto after = restored->ownersOf(parts.vertexOf[record.a], parts.vertexOf[record.b]);
                    std::sort(before.begin(), before.end());
                    std::sort(after.begin(), after.end());
                    QCOMPARE(after, before);
                }
        }
    }

    /// Found by fuzzing: areas that underflow.
    void aDomainOfNextToNothingIsRefused()
    {
        const Rectangle domain{{0, 0}, {1e-300, 1}};
        Parts parts = partsOf(Tin(domain), 1);
        const auto restored = restoreTin(std::move(parts.arrays), domain, {});
        QVERIFY(!restored.has_value());
        QCOMPARE(restored.error().args[0], std::string(nameOf(TinRule::Border)));
    }

    void canBeEditedAfterwards()
    {
        const Tin tin = specimen(tests::Ground::Random, 3, false);
        Parts parts = partsOf(tin, 4);
        auto restored = restoreTin(std::move(parts.arrays), tin.domain(), parts.edges);
        QVERIFY(restored.has_value());
        QCOMPARE(restored->ledger().start, restored->volume());
        tests::PointSource source(tests::Ground::Random, 5);
        TinEdit edit(*restored);
        for (int step = 0; step < 300; ++step)
            tests::randomStep(edit, source);
        edit.commit();
        QVERIFY(findDefects(*restored).empty());
    }

    void brokenArraysAreRefused_data()
    {
        QTest::addColumn<int>("rule");
        QTest::addColumn<int>("kind");
        QTest::newRow("a height that is no number") << int(TinRule::Height) << 0;
        QTest::newRow("a point outside") << int(TinRule::Border) << 1;
        QTest::newRow("a corner elsewhere") << int(TinRule::Border) << 2;
        QTest::newRow("an index too large") << int(TinRule::VertexCorner) << 3;
        QTest::newRow("an opposite too large") << int(TinRule::Links) << 4;
        QTest::newRow("one-sided opposite") << int(TinRule::Links) << 5;
        QTest::newRow("clockwise") << int(TinRule::Orientation) << 6;
        QTest::newRow("a free triangle") << int(TinRule::FreeList) << 7;
        QTest::newRow("a vertex without triangles") << int(TinRule::Euler) << 8;
        QTest::newRow("an edge that is none") << int(TinRule::Constraint) << 9;
        QTest::newRow("an edge of no vertex") << int(TinRule::Constraint) << 10;
        QTest::newRow("not Delaunay") << int(TinRule::EmptyCircle) << 11;
        QTest::newRow("a hole") << int(TinRule::Border) << 12;
        QTest::newRow("a thickness below zero") << int(TinRule::Thickness) << 14;
        QTest::newRow("too wet") << int(TinRule::Humidity) << 15;
        QTest::newRow("layers without values") << int(TinRule::Layers) << 16;
        QTest::newRow("too few") << int(TinRule::FreeList) << 13;
    }
    void brokenArraysAreRefused()
    {
        QFETCH(int, rule);
        QFETCH(int, kind);
        tests::PointSource source(tests::Ground::Random, 6);
        const Tin tin = buildTin(source.points(100), source.domain())->tin;
        Parts parts = partsOf(tin, 4);
        TinArrays &a = parts.arrays;
        Corner inner = 0;
        while (a.opposite(inner) == NoCorner || (inner & 3) == 3)
            ++inner;
        switch (kind) {
        case 0:
            a.heights[20] = NAN;
            break;
        case 1:
            a.points[20].x = 7;
            break;
        case 2:
            a.points[2].x = std::nextafter(a.points[2].x, 0);
            break;
        case 3:
            a.triangleVertices[31] = a.vertexSlots();
            break;
        case 4:
            a.opposites[slotOf(inner)] = cornerOf(a.triangleSlots(), 0);
            break;
        case 5:
            a.opposites[slotOf(inner)] = cornerOf(triangleOf(a.opposite(inner)), ((a.opposite(inner) & 3) + 1) % 3);
            break;
        case 6:
            std::swap(a.triangleVertices[30], a.triangleVertices[31]);
            break;
        case 7:
            a.triangleFlags[9] = FreeTriangle;
            break;
        case 8:
            a.resizeVertices(a.vertexSlots() + 1);
            a.points[a.vertexSlots() - 1] = {0.5, 0.5};
            a.heights[a.vertexSlots() - 1] = 0;
            break;
        case 9:
            parts.edges.push_back({0, 2, 5});
            break;
        case 10:
            parts.edges.push_back({0, a.vertexSlots(), 5});
            break;
        case 11: {
            // A vertex pulled over: orientation holds, circles do not.
            a.points[a.triangleVertices[slotOf(inner)]] = a.points[a.triangleVertices[slotOf(inner)]];
            Tin constrained = tin;
            TinEdit edit(constrained);
            VertexId far = 4;
            while (cornerOfEdge(tin.arrays(), 10, far) != NoCorner || far == 10)
                ++far;
            QVERIFY(edit.constrain(10, far, 1).has_value());
            edit.commit();
            parts = partsOf(constrained, 4);
            parts.edges.clear();
            break;
        }
        case 12:
            a.opposites[slotOf(a.opposite(inner))] = NoCorner;
            a.opposites[slotOf(inner)] = NoCorner;
            break;
        case 14:
        case 15:
        case 16:
            a.totals.layers.count = 2;
            if (kind != 16)
                a.resizeVertices(a.vertexSlots());
            for (std::size_t i = 0; i < a.thicknesses.size(); ++i) {
                a.thicknesses[i] = kind == 14 && i == 50 ? -1 : 1;
                a.humidities[i] = kind == 15 && i == 51 ? 1.5f : 0.5f;
            }
            break;
        case 13:
            a.resizeVertices(3);
            break;
        }
        const auto restored = restoreTin(std::move(parts.arrays), tin.domain(), parts.edges);
        QVERIFY(!restored.has_value());
        QCOMPARE(restored.error().code, ErrorCode::BrokenTerrain);
        QCOMPARE(restored.error().args[0], std::string(nameOf(TinRule(rule))));
    }
};

SANDREEL_TEST(TestRestoreTin)
#include "tst_restoretin.moc"
