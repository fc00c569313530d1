// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/terrainscript.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/io/terrain/terrains.h"
#include "tests/support/testmain.h"

#include <QRegularExpression>

#include <cmath>

using namespace model;
using namespace model::io;
using namespace model::terrain;

namespace {

Result<TerrainScript> parse(const QByteArray &text)
{
    return parseScript({reinterpret_cast<const std::uint8_t *>(text.data()), std::size_t(text.size())});
}

Result<Terrain> play(const QByteArray &text, ScriptReport *report = nullptr)
{
    const auto script = parse(text);
    if (!script)
        return fail(script.error());
    Result<Terrain> terrain = makeTerrain(std::get<NewTerrain>(script->start));
    if (!terrain)
        return terrain;
    const auto done = runScript(*script, *terrain);
    if (!done)
        return fail(done.error());
    if (report)
        *report = *done;
    return terrain;
}

constexpr const char *Box =
    R"("terrain": {"new": {"size": [10, 10], "spacing": 0.5, "layers": [{"material": "dry sand", "thickness": 2}]}})";

} // namespace

class TestTerrainScript final : public QObject
{
    Q_OBJECT

private slots:
    void everyToolPlays_data()
    {
        QTest::addColumn<QByteArray>("stroke");
        for (const char *stroke :
             {R"("tool": "imprint", "radius": 0.8, "depth": 0.1, "outline": "wedge", "follows_direction": true)",
              R"("tool": "imprint", "outline": [[-1, -1], [1, -1], [0, 1]], "rim": {"critical_angle": 30})",
              R"("tool": "imprint", "outline": "M 0 0 L 10 0 L 10 10 L 0 10 Z", "radius": 0.5)",
              R"("tool": "rake", "width": 1, "tines": 4, "depth": 0.05)",
              R"("tool": "raise", "radius": 1, "height": 0.2)",
              R"("tool": "lower", "radius": 1, "depth": 0.2, "falloff": "linear")",
              R"("tool": "flatten", "radius": 1, "strength": 0.5, "level": 0.1)",
              R"("tool": "smooth", "radius": 1, "mask": {"highest_slope": 80})",
              R"("tool": "noise", "radius": 2, "amplitude": 0.1, "octaves": 2, "seed": 7)",
              R"("tool": "ramp", "radius": 0.5, "from": 0, "to": 0.5)", R"("tool": "pour", "radius": 1, "volume": 0.1)",
              R"("tool": "scoop", "radius": 1, "depth": 0.1)", R"("tool": "breakline", "spacing": 0.5)",
              R"("tool": "raise", "radius": 1, "symmetry": {"kind": "radial", "centre": [5, 5], "copies": 5})"})
            QTest::newRow(stroke) << QByteArray(stroke);
    }
    void everyToolPlays()
    {
        QFETCH(QByteArray, stroke);
        ScriptReport report;
        const auto terrain = play(QByteArray("{") + Box + R"(, "steps": [{"stroke": {)" + stroke +
                                      R"(, "path": [[3, 3], [4, 5, 0.5], [7, 6, 1, 0.2]]}}, {"validate": true}]})",
                                  &report);
        QVERIFY2(terrain.has_value(), terrain ? "" : (terrain.error().args[0] + " " + terrain.error().args[1]).c_str());
        QCOMPARE(report.strokes, std::uint64_t(1));
        QVERIFY(findDefects(terrain->tin).empty());
        const double volume = terrain->tin.volume();
        QVERIFY(std::abs(volume - terrain->tin.ledger().expected()) < 1e-10);
        if (stroke.contains("raise") || stroke.contains("pour"))
            QVERIFY(volume > 0.05);
        if (stroke.contains("scoop")) {
            QVERIFY(report.scooped > 0.05);
            QVERIFY(std::abs(volume + report.scooped) < 1e-9);
        }
    }

    void whatIsSteepSlides()
    {
        ScriptReport report;
        const auto terrain = play(QByteArray("{") + Box + R"(, "steps": [
            {"stroke": {"tool": "pour", "radius": 1, "volume": 2, "path": [[5, 5]]}},
            {"erode": {"seconds": 0.1}}, {"settle": {}}, {"validate": true}]})",
                                  &report);
        QVERIFY2(terrain.has_value(), terrain ? "" : terrain.error().args[0].c_str());
        QVERIFY(report.transfers > 100);
        double steepest = 0;
        for (TriangleId t = 0; t < terrain->tin.arrays().triangleSlots(); ++t)
            if (terrain->tin.arrays().isTriangle(t))
                steepest = std::max(steepest, slopeOf(terrain->tin.arrays(), t) * 180 / M_PI);
        QVERIFY2(steepest < criticalAngleAt(terrain->materials[0], 0) + 0.1, QByteArray::number(steepest).constData());
        QVERIFY(std::abs(terrain->tin.volume() - 2) < 1e-9);
    }

    void materialsLayersAndRepeats()
    {
        const auto terrain = play(QByteArray("{") + Box + R"(, "comment": "x", "steps": [
            {"material": {"index": 1, "preset": "snow", "name": "old snow", "bulk_density": 400}},
            {"add_layer": {"material": 1, "thickness": 0.5, "humidity": 0.25}},
            {"repeat": 3, "steps": [{"stroke": {"tool": "raise", "radius": 1, "height": 0.1, "path": [[5, 5]]}}]},
            {"remove_layer": 0}, {"simplify": {"max_error": 0.01}}, {"validate": true}]})");
        QVERIFY2(terrain.has_value(), terrain ? "" : terrain.error().args[0].c_str());
        QCOMPARE(terrain->materials[1].name, std::string("old snow"));
        QCOMPARE(terrain->materials[1].bulkDensity, 400.0);
        QCOMPARE(terrain->tin.arrays().layerCount(), 1u);
        QVERIFY(std::abs(terrain->tin.heightAt({5, 5}) - 0.3) < 0.02);
        QVERIFY(std::abs(terrain->tin.layerVolume(0) - (50 + terrain->tin.volume())) < 1);
    }

    /// A terrain that was imported has no materials: a layer brings its own, and the same one again is not listed
    /// twice.
    void layersBringTheirMaterials()
    {
        const auto terrain = play(R"({"terrain": {"new": {"size": [10, 10]}}, "steps": [
            {"add_layer": {"material": "gravel", "thickness": 0.5}},
            {"add_layer": {"material": {"preset": "mud", "name": "silt"}, "thickness": 0.25}},
            {"add_layer": {"material": "gravel", "thickness": 0.125}}, {"validate": true}]})");
        QVERIFY2(terrain.has_value(), terrain ? "" : terrain.error().args[0].c_str());
        QCOMPARE(terrain->materials.size(), std::size_t(2));
        QVERIFY(terrain->materials[0] == material(MaterialPreset::Gravel));
        QCOMPARE(terrain->materials[1].name, std::string("silt"));
        const LayerTable &layers = terrain->tin.arrays().totals.layers;
        QCOMPARE(layers.count, 3u);
        for (const auto &[layer, place, thickness] : {std::tuple(0, 0, 0.5), {1, 1, 0.25}, {2, 0, 0.125}}) {
            QCOMPARE(int(layers.materials[std::size_t(layer)]), place);
            QVERIFY(std::abs(terrain->tin.layerVolume(std::uint32_t(layer)) - 100 * thickness) < 1e-9);
        }
        const auto unknown = parse(R"({"steps": [{"add_layer": {"material": "marble"}}]})");
        SANDREEL_COMPARE_ERROR(unknown, ErrorCode::BadSetting);
        QCOMPARE(unknown.error().args[0], std::string("steps[0].add_layer.material.preset"));
    }

    void restoreGoesBackToTheStart()
    {
        const auto terrain = play(QByteArray("{") + Box + R"(, "steps": [
            {"stroke": {"tool": "raise", "radius": 2, "height": 0.5, "path": [[5, 5]]}},
            {"stroke": {"tool": "restore", "radius": 4, "falloff": "constant", "strength": 1, "path": [[5, 5]]}}]})");
        QVERIFY2(terrain.has_value(), terrain ? "" : terrain.error().args[0].c_str());
        QVERIFY(std::abs(terrain->tin.heightAt({5, 5})) < 1e-9);
    }

    void sameScriptSameTerrain()
    {
        const QByteArray script = QByteArray("{") + Box + R"(, "steps": [
            {"stroke": {"tool": "noise", "radius": 3, "amplitude": 0.3, "path": [[3, 3], [7, 7]]}}, {"settle": {}}]})";
        QCOMPARE(play(script)->fingerprint(), play(script)->fingerprint());
    }

    void errorsSayWhere_data()
    {
        QTest::addColumn<QByteArray>("script");
        QTest::addColumn<QString>("path");
        const auto row = [](const char *script, const char *path) {
            QTest::newRow(script) << QByteArray(script) << path;
        };
        row("[]", "script");
        row(R"({"steps": 3})", "steps");
        row(R"({"stepz": []})", "stepz");
        row(R"({"steps": [3]})", "steps[0]");
        row(R"({"steps": [{"jump": 1}]})", "steps[0]");
        row(R"({"steps": [{"validate": 1}]})", "steps[0].validate");
        row(R"({"steps": [{"validate": true, "x": 1}]})", "steps[0].x");
        row(R"({"steps": [{"stroke": {}}]})", "steps[0].stroke.tool");
        row(R"({"steps": [{"stroke": {"tool": "spoon"}}]})", "steps[0].stroke.tool");
        row(R"({"steps": [{"validate": true}, {"stroke": {"tool": "rake", "tines": 1.5, "path": [[0, 0]]}}]})",
            "steps[1].stroke.tines");
        row(R"({"steps": [{"stroke": {"tool": "rake", "width": "a", "path": [[0, 0]]}}]})", "steps[0].stroke.width");
        row(R"({"steps": [{"stroke": {"tool": "raise", "radius": -1, "path": [[0, 0]]}}]})", "steps[0].stroke: radius");
        row(R"({"steps": [{"stroke": {"tool": "raise", "raduis": 1, "path": [[0, 0]]}}]})", "steps[0].stroke.raduis");
        row(R"({"steps": [{"stroke": {"tool": "raise", "path": [[0, 0], [1]]}}]})", "steps[0].stroke.path[1]");
        row(R"({"steps": [{"stroke": {"tool": "raise", "path": [[0, 0]], "mask": {"x": 1}}}]})",
            "steps[0].stroke.mask.x");
        row(R"({"steps": [{"stroke": {"tool": "raise", "falloff": "steep", "path": [[0, 0]]}}]})",
            "steps[0].stroke.falloff");
        row(R"({"steps": [{"stroke": {"tool": "imprint", "outline": 3, "path": [[0, 0]]}}]})",
            "steps[0].stroke.outline");
        row(R"({"steps": [{"erode": {"seconds": -1}}]})", "steps[0].erode.seconds");
        row(R"({"steps": [{"settle": {"relaxation": 9}}]})", "steps[0].settle: relaxation");
        row(R"({"steps": [{"material": {"index": 999}}]})", "steps[0].material.index");
        row(R"({"steps": [{"material": {"index": 0, "preset": "gold"}}]})", "steps[0].material.preset");
        row(R"({"steps": [{"material": {"index": 0, "humidity": 7}}]})", "steps[0].material: humidity");
        row(R"({"steps": [{"repeat": -1, "steps": []}]})", "steps[0].repeat");
        row(R"({"steps": [{"repeat": 2, "steps": [{"remove_layer": 77}]}]})", "steps[0].steps[0].remove_layer");
        row(R"({"terrain": {}})", "terrain");
        row(R"({"terrain": {"new": {"size": [1]}}})", "terrain.new.size");
        row(R"({"terrain": {"new": {"size": [0, 1]}}})", "terrain.new.size");
        row(R"({"terrain": {"new": {"layers": [{"material": "gold"}]}}})", "terrain.new.layers[0].material.preset");
        row(R"({"terrain": {"import": "a.tif", "max_error": -1}})", "terrain.max_error");
    }
    void errorsSayWhere()
    {
        QFETCH(QByteArray, script);
        QFETCH(QString, path);
        const auto parsed = parse(script);
        SANDREEL_COMPARE_ERROR(parsed, ErrorCode::BadSetting);
        QCOMPARE(QString::fromStdString(parsed.error().args[0]), path);
    }

    void errorsWhileItRuns()
    {
        const auto error = [](const char *steps) {
            const auto terrain = play(QByteArray("{") + Box + ", \"steps\": [" + steps + "]}");
            return terrain ? std::string() : terrain.error().args[0];
        };
        QCOMPARE(error(R"({"remove_layer": 3})"), std::string("steps[0].remove_layer"));
        QCOMPARE(error(R"({"add_layer": {"layer": 5}})"), std::string("steps[0].add_layer.layer"));
        QCOMPARE(error(R"({"add_layer": {"material": 5}})"), std::string("steps[0].add_layer.material"));
        QCOMPARE(error(R"({"material": {"index": 5, "preset": "mud"}})"), std::string("steps[0].material.index"));
        SANDREEL_COMPARE_ERROR(parse("{"), ErrorCode::SyntaxError);
        const auto script = parse(R"({"steps": [{"validate": true}]})");
        Terrain terrain = tests::plainTerrain();
        const Progress progress;
        progress.cancel();
        SANDREEL_COMPARE_ERROR(runScript(*script, terrain, progress), ErrorCode::Cancelled);
    }

    /// The example of the document plays.
    void documentedExamplePlays()
    {
        const QString document =
            QString::fromUtf8(tests::readFile(QStringLiteral(SANDREEL_SOURCE "/docs/terrain-script.md")));
        static const QRegularExpression block("```json\n([^`]*)```");
        const QByteArray example = block.match(document).captured(1).toUtf8();
        QVERIFY(!example.isEmpty());
        const auto terrain = play(example);
        QVERIFY2(terrain.has_value(), terrain ? "" : terrain.error().args[0].c_str());
        QVERIFY(terrain->tin.heightAt({5, 5}) < -0.01);
    }
};

SANDREEL_TEST(TestTerrainScript)
#include "tst_terrainscript.moc"
