// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/terrainexport.h"
#include "model/io/terrain/terrainimport.h"
#include "model/terrain/tin/tinedit.h"
#include "tests/model/io/terrain/terrains.h"
#include "tests/support/scarcity.h"
#include "tests/support/testmain.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include <cmath>
#include <cstring>

using namespace model;
using namespace model::io;
using namespace model::terrain;

namespace {

/// Heights that floats and short decimals hold exactly, a void, and an origin.
Terrain hill()
{
    std::vector<Point3> points;
    for (int j = 0; j <= 8; ++j)
        for (int i = 0; i <= 8; ++i)
            points.push_back({double(i), double(j), double((i * 3 + j * 5) % 7) * 0.25});
    Terrain terrain(buildTin(points, {{0, 0}, {8, 8}})->tin);
    TinEdit edit(terrain.tin, VolumeRule::Keep);
    std::vector<TriangleId> some;
    for (TriangleId t = 0; t < terrain.tin.arrays().triangleSlots(); ++t) {
        Point2 centre;
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c)
            centre = {centre.x + terrain.tin.arrays().pointAt(c).x / 3,
                      centre.y + terrain.tin.arrays().pointAt(c).y / 3};
        if (centre.x > 3 && centre.x < 5 && centre.y > 2 && centre.y < 4)
            some.push_back(t);
    }
    edit.setVoid(some, true);
    edit.commit();
    terrain.geoReference.originX = 4096;
    terrain.geoReference.originY = -8192;
    return terrain;
}

} // namespace

class TestTerrainExport final : public QObject
{
    Q_OBJECT

private slots:
    /// Out, and in again: the same surface, void included.
    void meshesComeBack_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<bool>("isWorld");
        for (const char *ending : {"obj", "ply", "stl"})
            for (const bool isWorld : {false, true})
                QTest::newRow(qPrintable(QStringLiteral("%1, %2").arg(ending, isWorld ? "world" : "local")))
                    << ending << isWorld;
    }
    void meshesComeBack()
    {
        QFETCH(QString, ending);
        QFETCH(bool, isWorld);
        const QTemporaryDir folder;
        const QString path = folder.filePath("a." + ending);
        const Terrain terrain = hill();
        TerrainExportOptions options;
        options.isWorld = isWorld;
        const auto exported = exportTerrain(path, *terrainFormatOf(path), terrain, {}, options);
        QVERIFY(exported.has_value());
        QCOMPARE(exported->triangles, std::uint64_t(2 * 8 * 8 - 8));
        const auto back = importTerrain(path, {});
        QVERIFY(back.has_value());
        const bool isMoved = isWorld && ending != "stl";
        QCOMPARE(back->terrain.geoReference.originX, isMoved ? 4096.0 : 0.0);
        QCOMPARE(back->terrain.geoReference.originY, isMoved ? -8192.0 : 0.0);
        for (double y = 0.03; y < 8; y += 0.37)
            for (double x = 0.01; x < 8; x += 0.29) {
                const bool isVoid = terrain.tin.arrays().isVoid(terrain.tin.triangleAt({x, y}));
                QCOMPARE(back->terrain.tin.arrays().isVoid(back->terrain.tin.triangleAt({x, y})), isVoid);
                if (!isVoid)
                    QVERIFY(std::abs(back->terrain.tin.heightAt({x, y}) - terrain.tin.heightAt({x, y})) < 1e-12);
            }
    }

    void rastersComeBack_data()
    {
        QTest::addColumn<QString>("ending");
        for (const char *ending : {"asc", "tif", "png"})
            QTest::newRow(ending) << ending;
    }
    void rastersComeBack()
    {
        QFETCH(QString, ending);
        const QTemporaryDir folder;
        const QString path = folder.filePath("a." + ending);
        const Terrain terrain = hill();
        TerrainExportOptions options;
        options.cell = 0.5;
        const auto exported = exportTerrain(path, *terrainFormatOf(path), terrain, {}, options);
        QVERIFY(exported.has_value());
        QCOMPARE(exported->columns, 17u);
        RasterOptions read;
        if (ending == "png") {
            read.cellSize = 0.5;
            read.noData = 0;
            read.heightScale = exported->scale.scale;
            read.heightOffset = exported->scale.offset;
        }
        const auto raster = readRaster(path, read);
        QVERIFY(raster.has_value());
        QCOMPARE(raster->grid.columns, 17u);
        QCOMPARE(raster->grid.rows, 17u);
        if (ending != "png") {
            QCOMPARE(raster->geoReference.originX, 4096.0);
            QCOMPARE(raster->geoReference.originY, -8192.0);
            QCOMPARE(raster->grid.stepX, 0.5);
        }
        int voids = 0;
        for (std::uint32_t j = 0; j < 17; ++j)
            for (std::uint32_t i = 0; i < 17; ++i) {
                const Point2 p{i * 0.5, j * 0.5};
                const bool isInside = p.x > 3 && p.x < 5 && p.y > 2 && p.y < 4;
                voids += isInside;
                QCOMPARE(std::isnan(raster->grid.height(i, j)), isInside);
                if (!isInside)
                    QVERIFY(std::abs(raster->grid.height(i, j) - terrain.tin.heightAt(p)) <=
                            (ending == "png" ? exported->scale.scale / 2 + 1e-12 : 0));
            }
        QCOMPARE(voids, 9);
    }

    void contoursAreGeoJson()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.geojson");
        TerrainExportOptions options;
        options.interval = 0.5;
        const auto exported = exportTerrain(path, TerrainFormat::Contours, hill(), {}, options);
        QVERIFY(exported.has_value());
        const QJsonObject json = QJsonDocument::fromJson(tests::readFile(path)).object();
        QCOMPARE(json["type"].toString(), QStringLiteral("FeatureCollection"));
        const QJsonArray features = json["features"].toArray();
        QCOMPARE(std::uint64_t(features.size()), exported->lines);
        const Terrain terrain = hill();
        for (const QJsonValue &feature : features) {
            const double level = feature["properties"]["elevation"].toDouble();
            const QJsonArray line = feature["geometry"]["coordinates"].toArray();
            QVERIFY(line.size() >= 2);
            for (const QJsonValue &p : line)
                QVERIFY(std::abs(terrain.tin.heightAt({std::clamp(p[0].toDouble() - 4096, 0.0, 8.0),
                                                       std::clamp(p[1].toDouble() + 8192, 0.0, 8.0)}) -
                                 level) < 1e-9);
        }
    }

    void errors()
    {
        const QTemporaryDir folder;
        const Terrain terrain = hill();
        QVERIFY(!terrainFormatOf("a.doc"));
        TerrainExportOptions options;
        options.cell = 9;
        const QString path = folder.filePath("a.tif");
        SANDREEL_COMPARE_ERROR(exportTerrain(path, TerrainFormat::GeoTiff, terrain, {}, options),
                               ErrorCode::BadSetting);
        options.cell = 1e-6;
        SANDREEL_COMPARE_ERROR(exportTerrain(path, TerrainFormat::GeoTiff, terrain, {}, options),
                               ErrorCode::LimitExceeded);
        SANDREEL_COMPARE_ERROR(exportTerrain(folder.filePath("a.asc"), TerrainFormat::AsciiGrid, terrain, {1, 2}, {}),
                               ErrorCode::UnsupportedFeature);
        SANDREEL_COMPARE_ERROR(exportTerrain(folder.filePath("no/a.obj"), TerrainFormat::Obj, terrain, {}, {}),
                               ErrorCode::CannotOpen);
        const Progress progress;
        progress.cancel();
        for (const TerrainFormat format : {TerrainFormat::Obj, TerrainFormat::GeoTiff, TerrainFormat::Contours})
            SANDREEL_COMPARE_ERROR(exportTerrain(path, format, terrain, {1, 1}, {}, progress), ErrorCode::Cancelled);
        for (const char *name : {"a.obj", "a.ply", "a.stl", "a.asc", "a.tif", "a.png", "a.geojson"}) {
            const tests::FileSizeLimit full(20);
            SANDREEL_COMPARE_ERROR(exportTerrain(folder.filePath(name), *terrainFormatOf(name), terrain, {1, 1}, {}),
                                   ErrorCode::CannotWrite);
        }
        QVERIFY(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
    }
};

SANDREEL_TEST(TestTerrainExport)
#include "tst_terrainexport.moc"
