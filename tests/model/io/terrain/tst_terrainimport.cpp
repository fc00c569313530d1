// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/meshes/pointsreader.h"
#include "model/io/terrain/terrainimport.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/io/terrain/terrains.h"
#include "tests/support/realdata.h"
#include "tests/support/testmain.h"

#include <QTemporaryDir>

#include <cmath>
#include <random>

using namespace model;
using namespace model::io;
using namespace model::terrain;

namespace {

/// The worst difference between a terrain and every sample of a grid that is ground, and how many void samples it has
/// ground at.
struct Differences
{
    double worst = 0;
    std::size_t samples = 0, groundInVoids = 0;
};

Differences differences(const ImportedTerrain &imported, const HeightGrid &grid)
{
    Differences result;
    const Tin &tin = imported.terrain.tin;
    for (std::uint32_t j = 0; j < grid.rows; ++j)
        for (std::uint32_t i = 0; i < grid.columns; ++i) {
            bool isGround = false;
            for (const auto &[di, dj] : {std::pair{0, 0}, {-1, 0}, {0, -1}, {-1, -1}}) {
                const int si = int(i) + di, sj = int(j) + dj;
                isGround = isGround || (si >= 0 && sj >= 0 && si + 1 < int(grid.columns) && sj + 1 < int(grid.rows) &&
                                        grid.isGround(std::uint32_t(si), std::uint32_t(sj)));
            }
            if (isGround) {
                ++result.samples;
                result.worst = std::max(result.worst, std::abs(tin.heightAt(grid.point(i, j)) - grid.height(i, j)));
            } else if (std::isnan(grid.height(i, j))) {
                result.groundInVoids += !tin.arrays().isVoid(tin.triangleAt(grid.point(i, j)));
            }
        }
    return result;
}

/// In UTM metres, with centimetres that no float has there; counter-clockwise.
std::vector<Point3> farSquare()
{
    return {{500000.01, 5500000.02, 312.11},
            {500009.87, 5500000.13, 313.07},
            {500010.23, 5500009.94, 314.9},
            {500000.36, 5500010.41, 312.43}};
}

} // namespace

class TestTerrainImport final : public QObject
{
    Q_OBJECT

private slots:
    /// Read with nothing but the format's description at hand.
    void asciiGrid()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.asc");
        tests::writeFile(path, "NCOLS 3\nNROWS 2\nXLLCORNER 5500000.25\nYLLCORNER -1000.5\nCELLSIZE 0.5\n"
                               "NODATA_VALUE -1\n1 2 3\n4 5 -1\n");
        const auto raster = readRaster(path, {});
        QVERIFY(raster.has_value());
        const HeightGrid &grid = raster->grid;
        QCOMPARE(grid.columns, 3u);
        QCOMPARE(grid.rows, 2u);
        QCOMPARE(grid.height(0, 0), 4.0);
        QCOMPARE(grid.height(1, 0), 5.0);
        QVERIFY(std::isnan(grid.height(2, 0)));
        QCOMPARE(grid.height(0, 1), 1.0);
        QCOMPARE(grid.height(2, 1), 3.0);
        // Samples are in the middle of the cells.
        QCOMPARE(raster->geoReference.originX, 5500000.5);
        QCOMPARE(raster->geoReference.originY, -1000.25);
        QCOMPARE(grid.stepX, 0.5);
    }

    void noDataByDefaultAndByWish()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.asc");
        tests::writeFile(path, "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 1\n-9999 2\n7 4\n");
        QVERIFY(std::isnan(readRaster(path, {})->grid.height(0, 1)));
        RasterOptions options;
        options.noData = 7;
        const auto raster = readRaster(path, options);
        QVERIFY(std::isnan(raster->grid.height(0, 0)));
        QCOMPARE(raster->grid.height(0, 1), -9999.0);
        options = {};
        options.heightScale = 2;
        options.heightOffset = 1;
        QCOMPARE(readRaster(path, options)->grid.height(1, 1), 5.0);
    }

    void rawNumbers()
    {
        const std::uint8_t bytes[] = {0, 1, 0, 2, 0xff, 0xff, 1, 0};
        RawLayout layout{2, 2, RawType::Int16, true};
        RasterOptions options;
        options.noData = -1;
        options.cellSize = 3;
        auto raster = parseRaw(bytes, layout, options);
        QVERIFY(raster.has_value());
        QCOMPARE(raster->grid.height(0, 1), 1.0); // the first row is the northern one
        QCOMPARE(raster->grid.height(1, 1), 2.0);
        QVERIFY(std::isnan(raster->grid.height(0, 0)));
        QCOMPARE(raster->grid.height(1, 0), 256.0);
        QCOMPARE(raster->grid.stepX, 3.0);
        layout.isBigEndian = false;
        QCOMPARE(parseRaw(bytes, layout, {})->grid.height(0, 1), 256.0);
        layout.type = RawType::Uint16;
        QCOMPARE(parseRaw(bytes, layout, {})->grid.height(0, 0), 65535.0);
        const float one = 1.5f;
        std::uint8_t floats[4];
        std::memcpy(floats, &one, 4);
        QCOMPARE(parseRaw(floats, {1, 1, RawType::Float32, false}, {})->grid.height(0, 0), 1.5);
        layout.rows = 3;
        SANDREEL_COMPARE_ERROR(parseRaw(bytes, layout, {}), ErrorCode::Truncated);
        layout.rows = 1;
        SANDREEL_COMPARE_ERROR(parseRaw(bytes, layout, {}), ErrorCode::TrailingBytes);
        layout.rows = 0;
        SANDREEL_COMPARE_ERROR(parseRaw(bytes, layout, {}), ErrorCode::BadSetting);
        layout = {0xffffffff, 0xffffffff, RawType::Float64, false};
        SANDREEL_COMPARE_ERROR(parseRaw(bytes, layout, {}), ErrorCode::Truncated);
    }

    void points()
    {
        const auto points = parsePoints("\xEF\xBB\xBFX;Y;Z\r\n1;2;3\r\n# comment\n\n 4.5,+5e0\t-6 extra words\n7 8 9");
        QVERIFY(points.has_value());
        QCOMPARE(points->size(), std::size_t(3));
        QCOMPARE(points->at(1).x, 4.5);
        QCOMPARE(points->at(1).y, 5.0);
        QCOMPARE(points->at(1).z, -6.0);
        SANDREEL_COMPARE_ERROR(parsePoints("1 2 3\n4 5"), ErrorCode::SyntaxError);
        QCOMPARE(parsePoints("1 2 3\n4 5").error().line, std::uint64_t(2));
        SANDREEL_COMPARE_ERROR(parsePoints("1 2 3\nx y z\n"), ErrorCode::SyntaxError);
        SANDREEL_COMPARE_ERROR(parsePoints("1 nan 3\n"), ErrorCode::NonFinite);
        SANDREEL_COMPARE_ERROR(parsePoints("1 1e999 3\n"), ErrorCode::NonFinite);
        SANDREEL_COMPARE_ERROR(parsePoints("# nothing\n"), ErrorCode::NoVertices);
        SANDREEL_COMPARE_ERROR(parsePoints("1,5;2,5;3,5\n2 x"), ErrorCode::SyntaxError);
    }

    void cloudOfPoints()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("cloud.xyz");
        std::mt19937 random(6);
        std::vector<Point3> points;
        QByteArray text;
        for (int i = 0; i < 3000; ++i) {
            const Point3 p{512345.67 + random() % 100000 * 0.001, 5498765.43 + random() % 100000 * 0.001,
                           random() % 1000 * 0.01};
            points.push_back(p);
            text += QByteArray::number(p.x, 'f', 3) + ' ' + QByteArray::number(p.y, 'f', 3) + ' ' +
                    QByteArray::number(p.z, 'f', 2) + '\n';
        }
        tests::writeFile(path, text);
        TerrainImportOptions options;
        options.maxError = 0.5;
        const auto imported = importTerrain(path, options);
        QVERIFY(imported.has_value());
        QVERIFY(validate(imported->terrain).has_value());
        const GeoReference &place = imported->terrain.geoReference;
        // To a millimetre in the plane, and what that can make of the height of a needle is more than the error: so the
        // samples are looked for where they were put.
        std::size_t near = 0;
        for (const Point3 &p : points) {
            const Point2 local{p.x - place.originX, p.y - place.originY};
            const Rectangle domain = imported->terrain.tin.domain();
            const Point2 inside{std::clamp(local.x, domain.low.x, domain.high.x),
                                std::clamp(local.y, domain.low.y, domain.high.y)};
            near += std::abs(imported->terrain.tin.heightAt(inside) - p.z) <= 0.5 + 0.01;
        }
        QVERIFY2(near > 2990, QByteArray::number(int(near)).constData());
        QVERIFY(imported->terrain.tin.vertexCount() < 3000);
    }

    /// Void cells, a coordinate system and offsets of millions: centimetres are kept.
    void farAwayKeepsCentimetres()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("far.tif"), back = folder.filePath("back.tif");
        Raster raster;
        raster.grid = {40, 30, 0.25, 0.25, {}};
        for (int i = 0; i < 40 * 30; ++i)
            raster.grid.heights.push_back(i % 17 == 3 ? NAN : 300 + std::sin(i * 0.7));
        raster.geoReference.originX = 5'500'000.015;
        raster.geoReference.originY = -1'234'567.035;
        raster.geoReference.crs = *wktOfCrs("EPSG:5514");
        QVERIFY(writeRaster(path, raster, RasterFormat::GeoTiff).has_value());
        TerrainImportOptions options;
        options.maxError = 0.01;
        const auto imported = importTerrain(path, options);
        QVERIFY(imported.has_value());
        const GeoReference &place = imported->terrain.geoReference;
        QVERIFY(std::abs(place.originX - 5'500'000.015) < 1e-6 && std::abs(place.originY + 1'234'567.035) < 1e-6);
        QVERIFY(place.crs.find("Krovak") != std::string::npos);
        QCOMPARE(place.unit, std::string("metre"));
        QCOMPARE(imported->voids, std::uint64_t(std::count_if(raster.grid.heights.begin(), raster.grid.heights.end(),
                                                              [](double h) { return std::isnan(h); })));
        const Differences found = differences(*imported, raster.grid);
        QVERIFY(found.worst <= 0.01 && found.samples > 0);
        QCOMPARE(found.groundInVoids, std::size_t(0));
        // Out again, onto the same cells.
        const auto again = rasterOf(imported->terrain, imported->step);
        QVERIFY(again.has_value());
        QVERIFY(writeRaster(back, *again, RasterFormat::GeoTiff).has_value());
        const auto reread = readRaster(back, {});
        QVERIFY(reread.has_value());
        QCOMPARE(reread->grid.columns, 40u);
        QVERIFY(std::abs(reread->geoReference.originX - 5'500'000.015) < 1e-6);
        for (std::size_t i = 0; i < raster.grid.heights.size(); ++i)
            if (!std::isnan(raster.grid.heights[i]) && !std::isnan(reread->grid.heights[i]))
                QVERIFY(std::abs(raster.grid.heights[i] - reread->grid.heights[i]) <= 0.01);
    }

    void errors()
    {
        const QTemporaryDir folder;
        const auto file = [&](const char *name, const QByteArray &bytes) {
            tests::writeFile(folder.filePath(name), bytes);
            return folder.filePath(name);
        };
        SANDREEL_COMPARE_ERROR(importTerrain(folder.filePath("none.tif"), {}), ErrorCode::NotFound);
        SANDREEL_COMPARE_ERROR(importTerrain(folder.path(), {}), ErrorCode::CannotOpen);
        SANDREEL_COMPARE_ERROR(importTerrain(file("a.tif", "nonsense"), {}), ErrorCode::UnknownFormat);
        SANDREEL_COMPARE_ERROR(importTerrain(file("a.doc", "nonsense"), {}), ErrorCode::UnknownFormat);
        SANDREEL_COMPARE_ERROR(
            importTerrain(file("cut.png", QByteArray::fromHex("89504e470d0a1a0a0000000d49484452000000"
                                                              "10000000101000000000")),
                          {}),
            ErrorCode::ImporterFailed);
        SANDREEL_COMPARE_ERROR(
            importTerrain(file("row.asc", "ncols 3\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n"), {}),
            ErrorCode::BadValue);
        SANDREEL_COMPARE_ERROR(importTerrain(file("void.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n"
                                                              "-9999 -9999\n-9999 -9999\n"),
                                             {}),
                               ErrorCode::NoSurface);
        SANDREEL_COMPARE_ERROR(importTerrain(file("wall.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n"), {}),
                               ErrorCode::NotASurface);
        SANDREEL_COMPARE_ERROR(importTerrain(file("point.xyz", "1 2 3\n"), {}), ErrorCode::BadValue);
        TerrainImportOptions options;
        options.crs = "no such system";
        SANDREEL_COMPARE_ERROR(
            importTerrain(file("ok.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n"),
                          options),
            ErrorCode::BadSetting);
        options = {};
        options.raster.band = 2;
        SANDREEL_COMPARE_ERROR(importTerrain(folder.filePath("ok.asc"), options), ErrorCode::BadValue);
        // A file that names another file is not followed.
        SANDREEL_COMPARE_ERROR(
            importTerrain(file("a.vrt", "<VRTDataset rasterXSize=\"2\" rasterYSize=\"2\"><VRTRasterBand "
                                        "dataType=\"Float32\" band=\"1\"><SimpleSource><SourceFilename>"
                                        "ok.asc</SourceFilename></SimpleSource></VRTRasterBand></VRTDataset>"),
                          {}),
            ErrorCode::UnknownFormat);
    }

    /// Offsets of millions of metres leave a float half a metre; files that have more digits keep their centimetres.
    void meshesKeepCentimetres_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("content");
        QByteArray obj, stl = "solid ground\n", text = "ply\nformat ascii 1.0\n",
                        binary = "ply\nformat binary_little_endian 1.0\n", cloud;
        for (QByteArray *const ply : {&text, &binary})
            *ply += "element vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
                    "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
        for (const Point3 &p : farSquare()) {
            const QByteArray line = QByteArray::number(p.x, 'f', 2) + ' ' + QByteArray::number(p.y, 'f', 2) + ' ' +
                                    QByteArray::number(p.z, 'f', 2) + '\n';
            obj += "v " + line;
            text += line;
            for (const double value : {p.x, p.y, p.z})
                binary.append(reinterpret_cast<const char *>(&value), 8);
        }
        cloud = obj;
        for (const auto &[a, b, c] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
            obj += QStringLiteral("f %1 %2 %3\n").arg(a + 1).arg(b + 1).arg(c + 1).toLatin1();
            text += QStringLiteral("3 %1 %2 %3\n").arg(a).arg(b).arg(c).toLatin1();
            binary.append(char(3));
            stl += "facet normal 0 0 1\nouter loop\n";
            for (const int corner : {a, b, c}) {
                binary.append(reinterpret_cast<const char *>(&corner), 4);
                const Point3 p = farSquare()[std::size_t(corner)];
                stl += "vertex " + QByteArray::number(p.x, 'f', 2) + ' ' + QByteArray::number(p.y, 'f', 2) + ' ' +
                       QByteArray::number(p.z, 'f', 2) + '\n';
            }
            stl += "endloop\nendfacet\n";
        }
        stl += "endsolid ground\n";
        QTest::newRow("OBJ") << "far.obj" << obj;
        QTest::newRow("points in OBJ") << "cloud.obj" << cloud;
        QTest::newRow("PLY in text") << "text.ply" << text;
        QTest::newRow("PLY in binary") << "binary.ply" << binary;
        QTest::newRow("STL in text") << "far.stl" << stl;
    }
    void meshesKeepCentimetres()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        const QTemporaryDir folder;
        tests::writeFile(folder.filePath(name), content);
        TerrainImportOptions options;
        options.maxError = 0;
        const auto imported = importTerrain(folder.filePath(name), options);
        QVERIFY(imported.has_value());
        const Terrain &terrain = imported->terrain;
        QVERIFY(validate(terrain));
        for (const Point3 &p : farSquare()) {
            const Point2 local{p.x - terrain.geoReference.originX, p.y - terrain.geoReference.originY};
            double nearest = 1e9, height = 0;
            for (VertexId v = 0; v < terrain.tin.arrays().vertexSlots(); ++v) {
                const Point2 q = terrain.tin.arrays().points[v];
                if (const double distance = std::hypot(q.x - local.x, q.y - local.y); distance < nearest) {
                    nearest = distance;
                    height = terrain.tin.arrays().heights[v];
                }
            }
            QVERIFY2(nearest < 2e-3, qPrintable(QString::number(nearest)));
            QVERIFY(std::abs(height - p.z) < 1e-9);
        }
    }

    void realModels_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("maxError");
        QTest::addColumn<double>("noData");
        for (const auto &[name, error, noData] : {std::tuple{"crater_lake.asc", 5.0, -9999.0},
                                                  {"gobi_crop.asc", 1.0, -9999.0},
                                                  {"hugo_site_filled.asc", 0.5, -9999.0},
                                                  {"west_bijou_gully.asc", 0.25, 0.0},
                                                  {"west_bijou_gully.asc", 0.0, 0.0},
                                                  {"boulder_srtm.asc", 10.0, 0.0},
                                                  {"jacksboro_fault.asc", 8.0, -9999.0},
                                                  {"st_helens_2004.tif", 2.0, -9999.0}})
            QTest::newRow(qPrintable(QStringLiteral("%1 to %2").arg(name).arg(error))) << name << error << noData;
    }
    void realModels()
    {
        SANDREEL_REQUIRE_DATA();
        QFETCH(QString, name);
        QFETCH(double, maxError);
        QFETCH(double, noData);
        const QString path = tests::dataFolder() + "/terrain/" + name;
        TerrainImportOptions options;
        options.maxError = maxError;
        const auto imported = importTerrain(path, options);
        QVERIFY(imported.has_value());
        QVERIFY(validate(imported->terrain).has_value());
        // The samples by a reader of three lines; of the GeoTIFF, by the same grid as text beside it.
        QString ascii = path;
        ascii.replace(".tif", ".asc");
        const QList<QByteArray> words = tests::readFile(ascii).simplified().split(' ');
        HeightGrid grid;
        grid.columns = words[1].toUInt();
        grid.rows = words[3].toUInt();
        grid.stepX = imported->step.x;
        grid.stepY = imported->step.y;
        const qsizetype first = words.size() - qsizetype(grid.columns) * grid.rows;
        grid.heights.resize(std::size_t(grid.columns) * grid.rows);
        for (std::uint32_t j = 0; j < grid.rows; ++j)
            for (std::uint32_t i = 0; i < grid.columns; ++i) {
                const double height = words[first + qsizetype(grid.rows - 1 - j) * grid.columns + i].toDouble();
                grid.heights[grid.index(i, j)] = height == noData ? NAN : height;
            }
        const Differences found = differences(*imported, grid);
        QVERIFY(found.samples > 100);
        // The text of the GeoTIFF has two decimals.
        QVERIFY2(found.worst <= maxError + (name.endsWith(".tif") ? 0.0051 : 1e-9),
                 QByteArray::number(found.worst).constData());
        QCOMPARE(found.groundInVoids, std::size_t(0));
    }
};

SANDREEL_TEST(TestTerrainImport)
#include "tst_terrainimport.moc"
