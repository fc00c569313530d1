// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/tinedit.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/terrain/tin/randomedits.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace model::terrain;

namespace {

constexpr Rectangle Domain{{0, 0}, {1, 1}};

/// A TIN with constraints, a void, and free slots of every kind.
Tin specimen()
{
    tests::PointSource source(tests::Ground::Random, 12);
    auto built = buildTin(source.points(100), Domain);
    TinEdit edit(built->tin);
    for (VertexId v = 20; v < 30; ++v)
        edit.remove(v);
    (void)edit.constrain(40, 60, 1, Crossing::Split);
    (void)edit.constrain(50, 70, 2, Crossing::Split);
    std::vector<TriangleId> some;
    for (TriangleId t = 0; t < built->tin.arrays().triangleSlots() && some.size() < 5; ++t)
        if (built->tin.arrays().isTriangle(t))
            some.push_back(t);
    edit.setVoid(some, true);
    edit.releaseOwner(2);
    edit.addLayer(0, 0);
    edit.addLayer(1, 1);
    edit.setLayer(50, 1, {0.5, 0.25F});
    edit.commit();
    return std::move(built->tin);
}

/// A corner whose edge is inside and as constrained as asked.
Corner innerCorner(const TinArrays &tin, bool isConstrained)
{
    for (TriangleId t = 0; t < tin.triangleSlots(); ++t)
        for (Corner c = cornerOf(t, 0); tin.isTriangle(t) && c <= cornerOf(t, 2); ++c)
            if (tin.opposite(c) != NoCorner && tin.isConstrained(c) == isConstrained &&
                tin.isVoid(t) == tin.isVoid(triangleOf(tin.opposite(c))))
                return c;
    return NoCorner;
}

VertexId innerVertex(const TinArrays &tin)
{
    for (VertexId v = 4;; ++v)
        if (tin.isVertex(v) && tin.constraints[v] == None)
            return v;
}

std::uint32_t someRecord(const TinArrays &tin)
{
    for (std::uint32_t r = 0;; ++r)
        if (tin.records[r].a != None && tin.records[r].owner == 1)
            return r;
}

struct Damage
{
    const char *name;
    TinRule rule;
    std::function<void(TinArrays &)> apply;
};

const std::vector<Damage> &damages()
{
    static const std::vector<Damage> list{
        {"a link to another triangle", TinRule::Links,
         [](TinArrays &tin) { tin.opposites[slotOf(innerCorner(tin, false))] = innerCorner(tin, true); }},
        {"a constrained bit on one side", TinRule::Links,
         [](TinArrays &tin) { tin.opposites[slotOf(innerCorner(tin, false))] |= ConstrainedBit; }},
        {"a link cut", TinRule::Links,
         [](TinArrays &tin) { tin.opposites[slotOf(innerCorner(tin, false))] = BorderOpposite; }},
        {"a triangle of no vertex", TinRule::VertexCorner,
         [](TinArrays &tin) { tin.triangleVertices[slotOf(innerCorner(tin, false))] = 9999; }},
        {"a triangle of a free vertex", TinRule::VertexCorner,
         [](TinArrays &tin) { tin.triangleVertices[slotOf(innerCorner(tin, false))] = tin.totals.freeVertex; }},
        {"a vertex at another's corner", TinRule::VertexCorner,
         [](TinArrays &tin) { tin.corners[innerVertex(tin)] = tin.corners[0]; }},
        {"a vertex moved away", TinRule::Orientation,
         [](TinArrays &tin) {
             tin.points[innerVertex(tin)] = {0.999, 0.9};
         }},
        {"an edge flipped", TinRule::EmptyCircle,
         [](TinArrays &tin) {
             Journal journal;
             TinWriter writer(tin, journal);
             for (TriangleId t = 0; t < tin.triangleSlots(); ++t) {
                 const Corner c = cornerOf(t, 0), o = tin.opposite(c);
                 if (!tin.isTriangle(t) || tin.isConstrained(c) ||
                     orientation(tin.pointAt(c), tin.pointAt(next(c)), tin.pointAt(o)) <= 0 ||
                     orientation(tin.pointAt(o), tin.pointAt(previous(c)), tin.pointAt(c)) <= 0)
                     continue;
                 writer.flip(c);
                 return;
             }
         }},
        {"a border vertex moved in", TinRule::Border,
         [](TinArrays &tin) {
             tin.points[0] = {0.0001, 0};
         }},
        {"a record that is gone", TinRule::Constraint,
         [](TinArrays &tin) {
             Journal journal;
             TinWriter writer(tin, journal);
             writer.setConstrained(innerCorner(tin, false), true);
         }},
        {"a constrained bit that is gone", TinRule::Constraint,
         [](TinArrays &tin) {
             Journal journal;
             TinWriter writer(tin, journal);
             writer.setConstrained(innerCorner(tin, true), false);
         }},
        {"a record in one list only", TinRule::RecordList,
         [](TinArrays &tin) { tin.constraints[tin.records[someRecord(tin)].b] = None; }},
        {"a record list in a circle", TinRule::RecordList,
         [](TinArrays &tin) {
             const std::uint32_t r = someRecord(tin);
             tin.records[r].nextOfA = r;
         }},
        {"an owner twice", TinRule::RecordList,
         [](TinArrays &tin) { std::swap(tin.records[someRecord(tin)].a, tin.records[someRecord(tin)].b); }},
        {"a triangle void by itself", TinRule::VoidBorder,
         [](TinArrays &tin) { tin.triangleFlags[triangleOf(innerCorner(tin, true))] ^= VoidTriangle; }},
        {"a free vertex left out", TinRule::FreeList,
         [](TinArrays &tin) { tin.totals.freeVertex = tin.corners[tin.totals.freeVertex] & ~FreeVertexBit; }},
        {"free vertices in a circle", TinRule::FreeList,
         [](TinArrays &tin) { tin.corners[tin.totals.freeVertex] = tin.totals.freeVertex | FreeVertexBit; }},
        {"a free triangle in use", TinRule::FreeList,
         [](TinArrays &tin) { tin.triangleFlags[tin.totals.freeTriangle] = 0; }},
        {"a free triangle that shows", TinRule::FreeList,
         [](TinArrays &tin) { tin.triangleVertices[slotOf(cornerOf(tin.totals.freeTriangle, 1))] = 5; }},
        {"a free record left out", TinRule::FreeList, [](TinArrays &tin) { tin.totals.freeRecord = None; }},
        {"a wrong count", TinRule::FreeList, [](TinArrays &tin) { ++tin.totals.triangles; }},
        {"arrays of different sizes", TinRule::FreeList, [](TinArrays &tin) { tin.heights.push(0); }},
        {"a height that is none", TinRule::Height, [](TinArrays &tin) { tin.heights[innerVertex(tin)] = NAN; }},
        {"a layer without values", TinRule::Layers, [](TinArrays &tin) { ++tin.totals.layers.count; }},
        {"more layers than there may be", TinRule::Layers,
         [](TinArrays &tin) {
             tin.totals.layers.count = MaxLayers + 1;
             tin.thicknesses.resize(tin.vertexSlots() * (MaxLayers + 1));
             tin.humidities.resize(tin.vertexSlots() * (MaxLayers + 1));
         }},
        {"a layer of less than nothing", TinRule::Thickness,
         [](TinArrays &tin) { tin.thicknesses[tin.layerSlot(innerVertex(tin), 1)] = -1e-300; }},
        {"a thickness that is none", TinRule::Thickness,
         [](TinArrays &tin) { tin.thicknesses[tin.layerSlot(innerVertex(tin), 0)] = NAN; }},
        {"a layer without end", TinRule::Thickness,
         [](TinArrays &tin) { tin.thicknesses[tin.layerSlot(innerVertex(tin), 0)] = INFINITY; }},
        {"wetter than water", TinRule::Humidity,
         [](TinArrays &tin) { tin.humidities[tin.layerSlot(innerVertex(tin), 0)] = 1.0001F; }},
        {"drier than dry", TinRule::Humidity,
         [](TinArrays &tin) { tin.humidities[tin.layerSlot(innerVertex(tin), 0)] = -0.01F; }},
        {"a humidity that is none", TinRule::Humidity,
         [](TinArrays &tin) { tin.humidities[tin.layerSlot(innerVertex(tin), 1)] = NAN; }},
    };
    return list;
}

} // namespace

class TestValidate final : public QObject
{
    Q_OBJECT

private slots:
    void aSoundTinHasNoDefect()
    {
        const Tin tin = specimen();
        QVERIFY(tin.arrays().totals.freeVertex != NoFreeVertex);
        QVERIFY(tin.arrays().totals.freeTriangle != None);
        QVERIFY(tin.arrays().totals.freeRecord != None);
        QVERIFY(findDefects(tin).empty());
        QVERIFY(validate(tin));
    }

    void everyDamageIsFound_data()
    {
        QTest::addColumn<int>("damage");
        for (std::size_t i = 0; i < damages().size(); ++i)
            QTest::newRow(damages()[i].name) << int(i);
    }
    void everyDamageIsFound()
    {
        QFETCH(int, damage);
        TinArrays tin = specimen().arrays();
        damages()[std::size_t(damage)].apply(tin);
        const std::vector<TinDefect> defects = findDefects(tin, Domain, 100);
        QVERIFY(!defects.empty());
        bool isNamed = false;
        for (const TinDefect &defect : defects)
            isNamed |= defect.rule == damages()[std::size_t(damage)].rule;
        QVERIFY2(isNamed, nameOf(defects[0].rule));
    }

    /// Slots that belong to nothing break nothing but the count of what there has to be.
    void aHoleBreaksEulersRule()
    {
        TinArrays tin = specimen().arrays();
        Journal journal;
        TinWriter writer(tin, journal);
        const auto isInside = [&](VertexId v) {
            return tin.constraints[v] == None && tin.clockwise(tin.firstAround(v)) != NoCorner;
        };
        TriangleId t = 0;
        while (!tin.isTriangle(t) || !isInside(tin.vertex(cornerOf(t, 0))) || !isInside(tin.vertex(cornerOf(t, 1))) ||
               !isInside(tin.vertex(cornerOf(t, 2))))
            ++t;
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
            if (tin.opposite(c) != NoCorner)
                writer.link(tin.opposite(c), BorderOpposite);
            const Corner other = tin.counterClockwise(c);
            writer.setCornerOf(tin.vertex(c), other != NoCorner ? other : tin.clockwise(c));
        }
        writer.freeTriangle(t);
        std::vector<TinRule> rules;
        for (const TinDefect &defect : findDefects(tin, Domain, 100))
            rules.push_back(defect.rule);
        QVERIFY(std::count(rules.begin(), rules.end(), TinRule::Euler) == 1);
        QVERIFY(std::count(rules.begin(), rules.end(), TinRule::Border) > 0);
    }

    void theErrorNamesRuleAndIds()
    {
        tests::PointSource source(tests::Ground::Random, 12);
        auto built = buildTin(source.points(20), Domain);
        TinEdit edit(built->tin, VolumeRule::Keep);
        edit.setHeight(9, INFINITY);
        const auto broken = validate(built->tin);
        QVERIFY(!broken);
        QCOMPARE(broken.error().code, model::ErrorCode::BrokenTerrain);
        QCOMPARE(broken.error().args, (std::vector<std::string>{"height", "9"}));
    }

    void theListIsAsLongAsAskedFor()
    {
        TinArrays tin = specimen().arrays();
        for (VertexId v = 0; v < tin.vertexSlots(); ++v)
            tin.heights[v] = NAN;
        QCOMPARE(findDefects(tin, Domain, 3).size(), std::size_t(3));
        QVERIFY(findDefects(tin, Domain, 1000).size() > 50);
    }
};

SANDREEL_TEST(TestValidate)
#include "tst_validate.moc"
