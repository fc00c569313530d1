// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/tinedit.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/terrain/tin/randomedits.h"
#include "tests/support/testmain.h"

#include <cmath>

using namespace model::terrain;

namespace {

/// A square of side 3 at height 10, with gravel 0.5 deep under sand 0.25 deep.
struct Layered
{
    Tin tin{Rectangle{{0, 0}, {3, 3}}};
    VertexId middle = None;

    Layered()
    {
        TinEdit edit(tin);
        middle = edit.insert({1, 1});
        edit.addLayer(0, 4);
        edit.addLayer(1, 2);
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v) {
            edit.setHeight(v, 10);
            edit.setLayer(v, 0, {0.5, 0.125F});
            edit.setLayer(v, 1, {0.25, 0.75F});
        }
        edit.commit();
    }
    double thickness(VertexId v, std::uint32_t layer) const { return tin.arrays().sample(v, layer).thickness; }
    float humidity(VertexId v, std::uint32_t layer) const { return tin.arrays().sample(v, layer).humidity; }
};

bool isNear(double a, double b)
{
    return std::abs(a - b) < 1e-14;
}

} // namespace

class TestLayerColumns final : public QObject
{
    Q_OBJECT

private slots:
    void aLayerSaidLeavesTheSurface()
    {
        Layered ground;
        QCOMPARE(ground.tin.volume(), 90.0);
        QCOMPARE(ground.tin.arrays().bedrock(ground.middle), 9.25);
        QCOMPARE(ground.tin.layerVolume(0), 4.5);
        QCOMPARE(ground.tin.layerVolume(1), 2.25);
        QVERIFY(validate(ground.tin));
    }

    void diggingGoesThroughTheLayersIntoTheBedrock()
    {
        Layered ground;
        TinEdit edit(ground.tin);
        edit.setHeight(ground.middle, 9.875);
        QCOMPARE(ground.thickness(ground.middle, 1), 0.125);
        QCOMPARE(ground.thickness(ground.middle, 0), 0.5);
        edit.setHeight(ground.middle, 9.5);
        QCOMPARE(ground.thickness(ground.middle, 1), 0.0);
        QCOMPARE(ground.thickness(ground.middle, 0), 0.25);
        QCOMPARE(ground.tin.arrays().bedrock(ground.middle), 9.25);
        edit.setHeight(ground.middle, 8);
        QCOMPARE(ground.thickness(ground.middle, 0), 0.0);
        QCOMPARE(ground.tin.arrays().bedrock(ground.middle), 8.0);
        edit.setHeight(ground.middle, 8.5);
        QCOMPARE(ground.thickness(ground.middle, 1), 0.5);
        QCOMPARE(ground.thickness(ground.middle, 0), 0.0);
        QCOMPARE(ground.tin.arrays().bedrock(ground.middle), 8.0);
    }

    void aNewVertexIsOnEveryLayersPlane()
    {
        Layered ground;
        TinEdit edit(ground.tin);
        // Thickness and bedrock linear in x and y, as the heights are: so is everything in between.
        const auto plane = [](Point2 p, double a) { return 0.5 + 0.1 * p.x + a * p.y; };
        for (VertexId v = 0; v < ground.tin.arrays().vertexSlots(); ++v) {
            const Point2 p = ground.tin.arrays().points[v];
            edit.setHeight(v, plane(p, 1));
            edit.setLayer(v, 0, {plane(p, 0.2), 0.5F});
            edit.setLayer(v, 1, {plane(p, 0.3), 0.25F});
        }
        tests::PointSource source(tests::Ground::Random, 6);
        for (int i = 0; i < 200; ++i) {
            Point2 p = source.point();
            p = {3 * p.x, i % 7 == 0 ? 0.0 : 3 * p.y}; // on the border too
            const VertexId v = edit.insert(p);
            QVERIFY(isNear(ground.thickness(v, 0), plane(p, 0.2)));
            QVERIFY(isNear(ground.thickness(v, 1), plane(p, 0.3)));
            QVERIFY(isNear(ground.tin.arrays().bedrock(v), plane(p, 1) - plane(p, 0.2) - plane(p, 0.3)));
            QCOMPARE(ground.humidity(v, 0), 0.5F);
            QCOMPARE(ground.humidity(v, 1), 0.25F);
        }
        for (VertexId v = 4; v < 100; ++v)
            if (edit.canRemove(v))
                edit.remove(v);
        edit.insert({1.5, 1.25});
        edit.commit();
        QVERIFY(validate(ground.tin));
    }

    void waterIsSharedByWhatIsWet()
    {
        Layered ground;
        TinEdit edit(ground.tin);
        // Where there is nothing of a layer, its humidity has no say.
        edit.setLayer(0, 1, {0, 1.0F});
        edit.setLayer(1, 1, {0.5, 0.25F});
        const VertexId v = edit.insert({1.5, 0});
        QCOMPARE(ground.thickness(v, 1), 0.25);
        QCOMPARE(ground.humidity(v, 1), 0.25F);
    }

    void transfersKeepEachLayersVolumeAndWater()
    {
        Layered ground;
        tests::PointSource source(tests::Ground::Random, 5);
        TinEdit edit(ground.tin);
        for (VertexId v = 0; v < ground.tin.arrays().vertexSlots(); ++v)
            for (std::uint32_t l = 0; l < 2; ++l)
                edit.setLayer(v, l, {source.uniform(0, 1), float(source.uniform(0, 1))});
        const TinArrays &tin = ground.tin.arrays();
        const auto water = [&](std::uint32_t l) {
            double sum = 0;
            for (VertexId v = 0; v < tin.vertexSlots(); ++v)
                sum += dualArea(tin, v) * tin.sample(v, l).thickness * double(tin.sample(v, l).humidity);
            return sum;
        };
        const double volumes[] = {ground.tin.layerVolume(0), ground.tin.layerVolume(1)};
        const double waters[] = {water(0), water(1)};
        for (int i = 0; i < 1000; ++i) {
            const VertexId a = source.below(tin.vertexSlots()), b = source.below(tin.vertexSlots());
            const double volume = source.uniform(-1, 1);
            const VertexId from = volume > 0 ? a : b;
            if (a != b && std::abs(volume) < 0.99 * dualArea(tin, from) * tin.cover(from))
                edit.transfer(a, b, volume);
        }
        for (std::uint32_t l = 0; l < 2; ++l) {
            QVERIFY(std::abs(ground.tin.layerVolume(l) - volumes[l]) < 1e-13);
            QVERIFY(std::abs(water(l) - waters[l]) < 1e-5); // humidities are floats
        }
        QVERIFY(edit.tin().ledger().moved.value() > 1);
        edit.commit();
        QVERIFY(std::abs(ground.tin.volume() - 90) < 1e-12);
        QVERIFY(validate(ground.tin));
    }

    void rockThatIsMovedIsLooseAfterwards()
    {
        Layered ground;
        TinEdit edit(ground.tin);
        const double area = edit.areaOf(ground.middle), other = edit.areaOf(0);
        edit.transfer(ground.middle, 0, area * 2);
        QCOMPARE(ground.tin.arrays().cover(ground.middle), 0.0);
        QCOMPARE(ground.tin.arrays().bedrock(ground.middle), 8.0);
        QVERIFY(isNear(ground.thickness(0, 0), 0.5 + 0.5 * area / other));
        QVERIFY(isNear(ground.thickness(0, 1), 0.25 + (0.25 + 1.25) * area / other));
    }

    void whatIsPressedOutKeepsItsMass()
    {
        Layered ground;
        TinEdit edit(ground.tin);
        const double area = edit.areaOf(ground.middle);
        QCOMPARE(edit.press(ground.middle, 0.5), 0.5);
        QCOMPARE(ground.thickness(ground.middle, 1), 0.0);
        QCOMPARE(ground.thickness(ground.middle, 0), 0.25);
        QCOMPARE(edit.press(ground.middle, 9), 0.25); // and no deeper: the bedrock is there
        QCOMPARE(ground.tin.arrays().heights[ground.middle], 9.25);
        edit.commit();
        const TinTotals &totals = ground.tin.arrays().totals;
        QVERIFY(isNear(totals.compacted[1].value(), 0.25 * area));
        QVERIFY(isNear(totals.compacted[0].value(), 0.5 * area));
        QVERIFY(isNear(ground.tin.ledger().pressed.value(), 0.75 * area));
        QVERIFY(std::abs(ground.tin.volume() - ground.tin.ledger().expected()) < 1e-12);
    }

    void depositsAreAddedAndMixed()
    {
        Layered ground;
        TinEdit edit(ground.tin);
        const double added = ground.tin.ledger().added.value();
        edit.deposit(ground.middle, 0, {0.5, 0.375F});
        QCOMPARE(ground.thickness(ground.middle, 0), 1.0);
        QCOMPARE(ground.humidity(ground.middle, 0), 0.25F);
        QCOMPARE(ground.tin.arrays().heights[ground.middle], 10.5);
        QCOMPARE(ground.tin.arrays().bedrock(ground.middle), 9.25);
        QVERIFY(isNear(ground.tin.ledger().added.value() - added, 0.5 * edit.areaOf(ground.middle)));
    }

    void layersComeAndGoBetweenOthers()
    {
        Layered ground;
        const TinArrays &tin = ground.tin.arrays();
        TinEdit edit(ground.tin);
        edit.press(ground.middle, 0.125);
        edit.addLayer(1, 7);
        QCOMPARE(tin.layerCount(), 3u);
        QCOMPARE(tin.totals.layers.materials[0], std::uint8_t(4));
        QCOMPARE(tin.totals.layers.materials[1], std::uint8_t(7));
        QCOMPARE(tin.totals.layers.materials[2], std::uint8_t(2));
        QCOMPARE(ground.thickness(3, 0), 0.5);
        QCOMPARE(ground.thickness(3, 1), 0.0);
        QCOMPARE(ground.thickness(3, 2), 0.25);
        QVERIFY(tin.totals.compacted[2].value() > 0 && tin.totals.compacted[1].value() == 0);
        edit.removeLayer(0);
        QCOMPARE(tin.layerCount(), 2u);
        QCOMPARE(tin.totals.layers.materials[1], std::uint8_t(2));
        QCOMPARE(ground.thickness(3, 1), 0.25);
        QCOMPARE(ground.humidity(3, 1), 0.75F);
        QCOMPARE(tin.bedrock(3), 9.75); // the gravel is rock now
        QCOMPARE(tin.heights[3], 10.0);
        QVERIFY(tin.totals.compacted[1].value() > 0);
        Edit done = edit.commit();
        QVERIFY(validate(ground.tin));
        ground.tin.swap(done);
        QCOMPARE(tin.layerCount(), 2u);
        QCOMPARE(ground.thickness(3, 0), 0.5);
        QVERIFY(validate(ground.tin));
    }

    void dirtyRangesNameTheColumns()
    {
        Layered ground;
        {
            TinEdit edit(ground.tin);
            edit.setLayer(2, 0, {1, 0});
            edit.setLayer(3, 1, {1, 0});
            const Edit done = edit.commit();
            QCOMPARE(done.dirtyRanges(TinPart::Layers), (std::vector<SlotRange>{{2, 2}}));
            QVERIFY(done.dirtyRanges(TinPart::Heights).empty());
            QVERIFY(!done.isEmpty());
        }
        {
            TinEdit edit(ground.tin);
            edit.setLayerMaterial(0, 9);
            QVERIFY(!edit.commit().isEmpty());
        }
        TinEdit edit(ground.tin);
        edit.addLayer(0, 1);
        edit.insert({2, 1});
        QCOMPARE(edit.commit().dirtyRanges(TinPart::Layers), (std::vector<SlotRange>{{0, 6}}));
    }

    /// The columns cost what their values do, and a TIN without layers pays nothing.
    void memoryIsThatOfTheValues()
    {
        tests::PointSource source(tests::Ground::Random, 5);
        auto built = buildTin(source.points(20000), source.domain());
        const double without = double(built->tin.byteSize()) / built->tin.vertexCount();
        QVERIFY2(without <= 96, qPrintable(QString::number(without)));
        TinEdit edit(built->tin);
        for (std::uint8_t l = 0; l < 3; ++l)
            edit.addLayer(l, l);
        for (VertexId v = 0; v < built->tin.arrays().vertexSlots(); ++v)
            edit.deposit(v, 1, {1, 0});
        edit.commit();
        const double with = double(built->tin.byteSize()) / built->tin.vertexCount();
        QVERIFY2(with <= 136 && with >= without + 36, qPrintable(QString::number(with)));
    }
};

SANDREEL_TEST(TestLayerColumns)
#include "tst_layercolumns.moc"
