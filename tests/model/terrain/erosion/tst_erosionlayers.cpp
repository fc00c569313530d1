// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/terrain.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/terrain/erosion/heaps.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <random>

using namespace model;
using namespace model::terrain;

namespace {

double water(const Tin &tin, std::uint32_t layer)
{
    double sum = 0;
    for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v) {
        const LayerSample sample = tin.arrays().sample(v, layer);
        sum += dualArea(tin.arrays(), v) * sample.thickness * double(sample.humidity);
    }
    return sum;
}

std::vector<double> bedrockOf(const Tin &tin)
{
    std::vector<double> heights;
    for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
        heights.push_back(tin.arrays().bedrock(v));
    return heights;
}

double largestDifference(const std::vector<double> &a, const std::vector<double> &b)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

} // namespace

class TestErosionLayers final : public QObject
{
    Q_OBJECT

private slots:
    void aLayerOnRockBecomesTheSameCone_data()
    {
        QTest::addColumn<unsigned>("layers");
        QTest::newRow("one layer") << 1u;
        QTest::newRow("three layers") << 3u;
    }
    void aLayerOnRockBecomesTheSameCone()
    {
        QFETCH(unsigned, layers);
        Tin tin = tests::layeredColumn(8000, layers);
        const double volume = tin.volume();
        const Material sand = material(MaterialPreset::DrySand);
        Erosion erosion = *Erosion::create({}, std::span(&sand, 1));
        tests::settle(tin, erosion);
        QVERIFY(validate(tin));
        QVERIFY2(tests::steepestFace(tin) <= 30.1, qPrintable(QString::number(tests::steepestFace(tin))));
        QVERIFY(std::abs(tin.volume() - volume) < 1e-12 * volume);
        QVERIFY(std::abs(tin.layerVolume(layers - 1) - volume) < 1e-12 * volume);
        // The tip, as all its sides point to it.
        double tips = 0, below = 0;
        int sides = 0;
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v) {
            const Point2 p = tin.arrays().points[v];
            const double distance = std::hypot(p.x - 0.5, p.y - 0.5);
            if (distance > 0.05 && distance < 0.25) {
                tips += tin.arrays().heights[v] + distance * std::tan(M_PI / 6);
                ++sides;
            }
            below = std::max(below, std::abs(tin.arrays().bedrock(v)));
        }
        const double cone = std::cbrt(3 * volume * std::tan(M_PI / 6) * std::tan(M_PI / 6) / M_PI);
        const double top = tips / sides;
        QVERIFY2(std::abs(top / cone - 1) < 0.03, qPrintable(QString::number(top / cone)));
        QVERIFY(below < 1e-12);
    }

    /// Rough bedrock, three layers of random thickness and humidity.
    void bedrockStaysAndEachLayerKeepsVolumeAndWater()
    {
        Tin tin = tests::column(3000);
        std::mt19937 random(7);
        const auto unit = [&] { return double(random()) / 4294967296.0; };
        const std::vector<Material> materials{material(MaterialPreset::Gravel), material(MaterialPreset::DrySand),
                                              material(MaterialPreset::Snow)};
        TinEdit edit(tin);
        for (std::uint8_t l = 0; l < 3; ++l)
            edit.addLayer(l, l);
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v) {
            edit.setHeight(v, tin.arrays().heights[v] + 0.05 * unit());
            for (std::uint32_t l = 0; l < 3; ++l)
                edit.setLayer(v, l, {unit() < 0.3 ? 0 : 0.05 * unit(), float(unit())});
        }
        edit.commit();
        const std::vector<double> bedrock = bedrockOf(tin);
        double volumes[3], waters[3];
        for (std::uint32_t l = 0; l < 3; ++l) {
            volumes[l] = tin.layerVolume(l);
            waters[l] = water(tin, l);
        }
        const double volume = tin.volume();
        Erosion erosion = *Erosion::create({}, materials);
        ErosionStatistics statistics;
        tests::settle(tin, erosion, &statistics);
        QVERIFY(statistics.transfers > 10000);
        QVERIFY(validate(tin));
        QVERIFY(largestDifference(bedrockOf(tin), bedrock) < 1e-13);
        QVERIFY(std::abs(tin.volume() - volume) < 1e-12 * volume);
        for (std::uint32_t l = 0; l < 3; ++l) {
            QVERIFY(std::abs(tin.layerVolume(l) - volumes[l]) < 1e-12 * volumes[l]);
            QVERIFY2(std::abs(water(tin, l) - waters[l]) < 1e-4 * waters[l],
                     qPrintable(QString::number(water(tin, l) / waters[l] - 1)));
        }
        // Whatever is still steeper than the weakest of it stands has nothing to give, or stands stronger.
        Tin again = tin;
        tests::settle(again, erosion, &statistics);
        QVERIFY(tests::bytesOf(again) == tests::bytesOf(tin));
    }

    void humidityDecidesTheAngle_data()
    {
        QTest::addColumn<float>("humidity");
        for (const float humidity : {0.0F, 0.05F, 0.3F, 0.72F, 1.0F})
            QTest::addRow("%g", double(humidity)) << humidity;
    }
    void humidityDecidesTheAngle()
    {
        QFETCH(float, humidity);
        Tin tin = tests::layeredColumn(3000, 1, humidity);
        const Material sand = material(MaterialPreset::MoistSand);
        Erosion erosion = *Erosion::create({}, std::span(&sand, 1));
        tests::settle(tin, erosion);
        const double critical = criticalAngleAt(sand, double(humidity));
        const double steepest = tests::steepestFace(tin);
        QVERIFY2(steepest <= critical + 0.1 && steepest > critical - 0.5,
                 qPrintable(QString("%1 for %2").arg(steepest).arg(critical)));
    }

    void waterMovesWithTheSand()
    {
        // Wet sand at the top of a heap that dry sand surrounds.
        Tin tin = tests::layeredColumn(4000, 1);
        TinEdit edit(tin);
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
            if (tin.arrays().points[v].x < 0.5)
                edit.setLayer(v, 0, {tin.arrays().sample(v, 0).thickness, 0.9F});
        edit.commit();
        const double before = water(tin, 0);
        const Material sand = material(MaterialPreset::DrySand);
        Erosion erosion = *Erosion::create({}, std::span(&sand, 1));
        tests::settle(tin, erosion);
        QVERIFY(validate(tin));
        QVERIFY(std::abs(water(tin, 0) - before) < 1e-4 * before);
        const VertexId west = tin.arrays().vertex(tin.locate({0.3, 0.5}).corner);
        const VertexId east = tin.arrays().vertex(tin.locate({0.7, 0.5}).corner);
        QVERIFY(tin.arrays().sample(west, 0).humidity > 0.5F);
        QVERIFY(tin.arrays().sample(east, 0).humidity < 0.4F);
        // Saturated, it flows farther on its side.
        double moment = 0;
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
            moment += dualArea(tin.arrays(), v) * tin.arrays().heights[v] * (tin.arrays().points[v].x - 0.5);
        QVERIFY(moment < 0);
    }

    /// Mud flows off gravel that stays: a layer goes only as far down as it is the weaker one.
    void theStrongLayerBelowStays()
    {
        // A jittered grid: the needles along the border of random points stand steep with a breath of mud.
        std::mt19937 random(9);
        std::vector<Point3> points;
        for (int i = 0; i <= 40; ++i)
            for (int k = 0; k <= 40; ++k) {
                const auto jitter = [&](int at) {
                    return at == 0 || at == 40 ? at / 40.0 : (at + 0.5 * (double(random()) / 4294967296.0 - 0.5)) / 40;
                };
                points.push_back({jitter(i), jitter(k), 0});
            }
        Tin tin = std::move(buildTin(points, {{0, 0}, {1, 1}})->tin);
        TinEdit edit(tin);
        edit.addLayer(0, 0);
        edit.addLayer(1, 1);
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v) {
            const double height = 0.5 * tin.arrays().points[v].x; // 26.6 degrees
            edit.setHeight(v, height);
            edit.setLayer(v, 0, {0.2, 0});
            edit.setLayer(v, 1, {0.002, 0.9F}); // mud at 0.9: 10 degrees
        }
        edit.commit();
        const std::vector<Material> materials{material(MaterialPreset::Gravel), material(MaterialPreset::Mud)};
        Erosion erosion = *Erosion::create({}, materials);
        tests::settle(tin, erosion);
        QVERIFY(validate(tin));
        double mudAbove = 0, gravelMoved = 0;
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v) {
            gravelMoved += dualArea(tin.arrays(), v) * std::abs(tin.arrays().sample(v, 0).thickness - 0.2);
            if (tin.arrays().points[v].x > 0.8)
                mudAbove = std::max(mudAbove, tin.arrays().sample(v, 1).thickness);
        }
        QVERIFY2(gravelMoved < 1e-9, qPrintable(QString::number(gravelMoved)));
        QVERIFY2(mudAbove < 1e-3, qPrintable(QString::number(mudAbove)));
    }

    void nothingToMoveIsAtRest()
    {
        Tin tin = tests::column(1000);
        TinEdit edit(tin);
        edit.addLayer(0, 0);
        edit.commit();
        const std::string before = tests::bytesOf(tin);
        const Material sand = material(MaterialPreset::DrySand);
        Erosion erosion = *Erosion::create({}, std::span(&sand, 1));
        ErosionStatistics statistics;
        tests::settle(tin, erosion, &statistics);
        QVERIFY(statistics.isAtRest && statistics.transfers == 0);
        QVERIFY(tests::bytesOf(tin) == before);
        erosion.activateAll(tin);
        TinEdit run(tin);
        QVERIFY(erosion.run(run, 10)->isAtRest);
    }

    void aLayerOfAnUnknownMaterialIsRefused()
    {
        Tin tin = tests::column(500);
        TinEdit edit(tin);
        edit.addLayer(0, 3);
        Erosion erosion = *Erosion::create({}, {});
        const auto settled = erosion.settle(edit);
        QVERIFY(!settled);
        QCOMPARE(settled.error().code, ErrorCode::BadValue);
        QCOMPARE(settled.error().args[0], std::string("material of layer 0"));
        QVERIFY(!erosion.run(edit, 1));
    }
};

SANDREEL_TEST(TestErosionLayers)
#include "tst_erosionlayers.moc"
