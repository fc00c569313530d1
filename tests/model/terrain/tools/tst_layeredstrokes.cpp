// SPDX-License-Identifier: GPL-3.0-or-later
// Tools on ground with layers: gravel on the bedrock, sand on it, snow on top.
#include "model/terrain/terrain.h"
#include "tests/model/terrain/tools/strokes.h"
#include "tests/support/testmain.h"

#include <map>

using namespace model;
using namespace model::terrain;
using namespace tests;

namespace {

enum Layer : std::uint32_t { Gravel, Sand, Snow };

/// \param thickness  metres of gravel, sand and snow, in waves of their own if `isEven` is not set
Terrain layered(std::size_t count, std::array<double, 3> thickness, bool isEven, double waves)
{
    Terrain terrain(ground(count, waves));
    terrain.materials = {material(MaterialPreset::Gravel), material(MaterialPreset::MoistSand),
                         material(MaterialPreset::Snow)};
    TinEdit edit(terrain.tin);
    for (std::uint32_t l = 0; l < 3; ++l)
        edit.addLayer(l, std::uint8_t(l));
    const TinArrays &arrays = terrain.tin.arrays();
    for (VertexId v = 0; v < arrays.vertexSlots(); ++v)
        for (std::uint32_t l = 0; l < 3; ++l) {
            const Point2 p = arrays.points[v];
            const double share =
                isEven ? 1 : std::max(0.0, 0.5 + 0.7 * std::sin(7 * p.x + 2.0 * l) * std::cos(5 * p.y));
            edit.setLayer(v, l, {thickness[l] * share, float(0.1 + 0.2 * l)});
        }
    edit.commit();
    return terrain;
}

std::map<std::pair<double, double>, double> bedrockOf(const TinArrays &tin)
{
    std::map<std::pair<double, double>, double> bedrock;
    for (VertexId v = 0; v < tin.vertexSlots(); ++v)
        if (tin.isVertex(v))
            bedrock[{tin.points[v].x, tin.points[v].y}] = tin.bedrock(v);
    return bedrock;
}

double bedrockVolume(const TinArrays &tin)
{
    CompensatedSum sum;
    for (VertexId v = 0; v < tin.vertexSlots(); ++v)
        if (tin.isVertex(v))
            sum.add(tin.bedrock(v) * dualArea(tin, v));
    return sum.value();
}

/// Those of a bare surface, and what wets a layer.
std::vector<Tool> everyToolForLayers(double radius)
{
    std::vector<Tool> tools = everyTool(radius);
    Moisten moisten;
    moisten.brush.radius = radius;
    tools.push_back(moisten);
    return tools;
}

} // namespace

class TestLayeredStrokes final : public QObject
{
    Q_OBJECT

private slots:
    void everyToolKeepsItsPromises_data()
    {
        QTest::addColumn<int>("index");
        QTest::addColumn<bool>("isDeep");
        const std::vector<Tool> tools = everyToolForLayers(0.1);
        QCOMPARE(tools.size(), std::variant_size_v<Tool>);
        for (int i = 0; i < int(tools.size()); ++i)
            for (const bool isDeep : {false, true})
                QTest::addRow("%s, %s layers", nameOf(tools[i]), isDeep ? "deep" : "thin") << i << isDeep;
    }
    /// Valid, the ledger explains the volume, undo and redo are exact (drawAndCheck); layers and bedrock together are
    /// the surface, and rock only goes.
    void everyToolKeepsItsPromises()
    {
        QFETCH(int, index);
        QFETCH(bool, isDeep);
        const Tool tool = everyToolForLayers(0.1)[std::size_t(index)];
        Terrain terrain =
            isDeep ? layered(3000, {0.5, 0.5, 0.5}, false, 0.1) : layered(3000, {0.02, 0.03, 0.01}, false, 0.1);
        Tin &tin = terrain.tin;
        const auto before = bedrockOf(tin.arrays());
        const std::uint64_t untouched = tin.fingerprint();
        drawAndCheck(tin, {tool, line({0.25, 0.4}, {0.7, 0.55}), {}});
        drawAndCheck(tin, {tool, line({0.3, 0.7}, {0.6, 0.3}), {}});
        QVERIFY(tin.fingerprint() != untouched);
        QVERIFY(validate(terrain));
        const TinArrays &arrays = tin.arrays();
        CompensatedSum all;
        for (std::uint32_t l = 0; l < 3; ++l)
            all.add(tin.layerVolume(l));
        all.add(bedrockVolume(arrays));
        QVERIFY(std::abs(all.value() - tin.volume()) < 1e-12);
        for (VertexId v = 0; v < arrays.vertexSlots(); ++v)
            if (arrays.isVertex(v))
                if (const auto rock = before.find({arrays.points[v].x, arrays.points[v].y}); rock != before.end())
                    QVERIFY2(arrays.bedrock(v) <= rock->second + 1e-12, nameOf(tool));
    }

    /// Where no vertex comes or goes, what is added lies on top, and what is taken is the top's; nothing else changes.
    void onlyTheTopIsShaped()
    {
        Brush brush;
        brush.radius = 0.2;
        const std::vector<Tool> tools{Raise{brush, 0.02},
                                      Lower{brush, 0.02},
                                      Pour{brush, 0.001},
                                      Scoop{brush, 0.02},
                                      Noise{brush, 0.02, 0.3, 2, 1},
                                      Smooth{brush, 0.5}};
        for (const Tool &tool : tools) {
            Terrain terrain = layered(3000, {0.1, 0.1, 0.4}, true, 0.02);
            const Stroke stroke{tool, line({0.3, 0.4}, {0.6, 0.5}), {}};
            drawAndCheck(terrain.tin, stroke); // puts in the vertices that the brush needs
            const std::uint32_t vertices = terrain.tin.vertexCount();
            const std::array<double, 3> before{terrain.tin.layerVolume(Gravel), terrain.tin.layerVolume(Sand),
                                               terrain.tin.layerVolume(Snow)};
            const double rock = bedrockVolume(terrain.tin.arrays());
            const StrokeReport report = drawAndCheck(terrain.tin, stroke);
            QVERIFY2(report.added + report.removed + report.moved > 1e-9, nameOf(tool));
            QCOMPARE(terrain.tin.vertexCount(), vertices);
            QVERIFY2(std::abs(terrain.tin.layerVolume(Gravel) - before[Gravel]) < 1e-13, nameOf(tool));
            QVERIFY2(std::abs(terrain.tin.layerVolume(Sand) - before[Sand]) < 1e-13, nameOf(tool));
            QVERIFY2(std::abs(bedrockVolume(terrain.tin.arrays()) - rock) < 1e-13, nameOf(tool));
            QVERIFY2(std::abs(terrain.tin.layerVolume(Snow) - before[Snow] - report.added + report.removed) < 1e-13,
                     nameOf(tool));
        }
    }

    /// What goes through all layers takes the top ones first.
    void digsFromTheTop()
    {
        Brush brush;
        brush.radius = 0.2;
        Terrain terrain = layered(3000, {0.1, 0.05, 0.02}, true, 0);
        drawAndCheck(terrain.tin, {Lower{brush, 0.04}, {{{0.5, 0.5}, 1, 0}}, {}});
        const TinArrays &tin = terrain.tin.arrays();
        bool isSandDug = false;
        for (VertexId v = 0; v < tin.vertexSlots(); ++v) {
            if (!tin.isVertex(v))
                continue;
            QVERIFY(tin.sample(v, Gravel).thickness > 0.1 - 1e-12); // it was too far down
            QVERIFY(tin.sample(v, Sand).thickness > 0.05 - 1e-12 || tin.sample(v, Snow).thickness < 1e-12);
            isSandDug = isSandDug || tin.sample(v, Sand).thickness < 0.04;
        }
        QVERIFY(isSandDug);
    }

    /// A print in deep snow: part of what it displaces is pressed together, and weighs what it did.
    void printsInSnowKeepItsMass()
    {
        Terrain terrain = layered(4000, {0.1, 0.1, 0.5}, true, 0);
        const double gravel = terrain.mass(Gravel), sand = terrain.mass(Sand), snow = terrain.mass(Snow);
        const double density = terrain.bulkDensity(Snow);
        const Material *top = terrain.topMaterialAt({0.5, 0.5});
        QVERIFY(top && top->name == nameOf(MaterialPreset::Snow));
        Imprint tool;
        tool.radius = 0.06;
        tool.depth = 0.08;
        tool.rim = rimOf(*top);
        QCOMPARE(tool.rim.criticalAngle, top->outsideSlope);
        QCOMPARE(tool.rim.compressibility, top->compression);
        QVERIFY(tool.rim.compressibility > 0.1);
        const StrokeReport report = drawAndCheck(terrain.tin, {tool, line({0.3, 0.4}, {0.7, 0.6}), {}});
        QVERIFY(report.compressed > 1e-4);
        QVERIFY(report.removed < 1e-15 && report.added < 1e-15);
        QVERIFY(std::abs(terrain.tin.ledger().pressed.value() - report.compressed) < 1e-15);
        QVERIFY(std::abs(terrain.mass(Gravel) / gravel - 1) < 1e-12);
        QVERIFY(std::abs(terrain.mass(Sand) / sand - 1) < 1e-12);
        QVERIFY(std::abs(terrain.mass(Snow) / snow - 1) < 1e-12);
        QVERIFY(terrain.bulkDensity(Snow) > density);
    }

    void topMaterialIsTheTopmostThatIsThere()
    {
        Terrain terrain = layered(500, {0.1, 0.1, 0}, true, 0);
        QCOMPARE(terrain.topMaterialAt({0.5, 0.5}), &terrain.materialOf(Sand));
        Terrain bare = layered(500, {0, 0, 0}, true, 0);
        QCOMPARE(bare.topMaterialAt({0.5, 0.5}), static_cast<const Material *>(nullptr));
        QCOMPARE(Terrain(ground(100)).topMaterialAt({0.5, 0.5}), static_cast<const Material *>(nullptr));
    }
};

SANDREEL_TEST(TestLayeredStrokes)
#include "tst_layeredstrokes.moc"
