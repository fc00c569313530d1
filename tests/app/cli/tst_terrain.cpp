// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/animationfiles.h"
#include "tests/app/cli/clirun.h"
#include "tests/support/realdata.h"
#include "tests/support/scarcity.h"
#include "tests/support/testmain.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <cmath>

#include <sys/stat.h>
#include <unistd.h>

class TestTerrain : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void makesMeasuresAndExports();
    void importsAndSimplifies();
    void refusesWithItsExitCode_data();
    void refusesWithItsExitCode();
    void outputThatCannotBeWritten();
    void realModelEndToEnd_data();
    void realModelEndToEnd();

private:
    QString path(const char *name) const { return mFolder.filePath(QString::fromUtf8(name)); }

    QTemporaryDir mFolder;
};

namespace {

void put(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

} // namespace

void TestTerrain::initTestCase()
{
    QByteArray grid = "ncols 40\nnrows 30\nxllcenter 500000\nyllcenter 5500000\ncellsize 2\n";
    for (int j = 0; j < 30; ++j)
        for (int i = 0; i < 40; ++i)
            grid += (i == 7 && j == 9 ? QByteArray("-9999")
                                      : QByteArray::number(100 + 8 * std::sin(i * 0.3) * std::cos(j * 0.2), 'f', 2)) +
                    (i == 39 ? '\n' : ' ');
    put(path("hills.asc"), grid);
    SANDREEL_RUN(run, 0, {"terrain", "import", path("hills.asc"), "-o", path("hills.terrain"), "--max-error", "0.25"});
}

void TestTerrain::makesMeasuresAndExports()
{
    SANDREEL_RUN(made, 0,
                 {"--json", "terrain", "new", "-o", path("box.terrain"), "--size", "10", "20", "--height", "3",
                  "--spacing", "1", "--layer", "dry sand:1.5", "--layer", "snow:0.5"});
    QCOMPARE(made.json()["vertices"].toInt(), 11 * 21);
    SANDREEL_RUN(valid, 0, {"--json", "terrain", "validate", path("box.terrain")});
    QVERIFY(valid.json()["valid"].toBool());
    SANDREEL_RUN(volume, 0, {"--json", "terrain", "volume", path("box.terrain")});
    const QJsonObject json = volume.json();
    QCOMPARE(json["volume"].toDouble(), 600.0);
    QCOMPARE(json["area"].toDouble(), 200.0);
    for (const char *key : {"added", "removed", "moved"})
        QCOMPARE(json[QLatin1String(key)].toDouble(-1), 0.0);
    QVERIFY(json["drift_relative"].toDouble(1) < 1e-12);
    SANDREEL_RUN(info, 0, {"--json", "terrain", "info", path("box.terrain")});
    const QJsonArray layers = info.json()["layers"].toArray();
    QCOMPARE(layers.size(), 2);
    QCOMPARE(layers[0]["material"].toString(), QStringLiteral("dry sand"));
    QCOMPARE(layers[1]["volume"].toDouble(), 100.0);
    for (const char *ending : {"obj", "ply", "stl", "asc", "tif", "png", "geojson"}) {
        const QString out = path("box.") + QLatin1String(ending);
        SANDREEL_RUN(exported, 0, {"terrain", "export", path("box.terrain"), "-o", out, "--cell", "1"});
        QVERIFY(QFile(out).size() > 0);
    }
}

void TestTerrain::importsAndSimplifies()
{
    SANDREEL_RUN(info, 0, {"--json", "terrain", "info", path("hills.terrain")});
    const QJsonObject json = info.json();
    QCOMPARE(json["origin"].toArray()[0].toDouble(), 500000.0);
    QCOMPARE(json["origin"].toArray()[1].toDouble(), 5500000.0);
    QVERIFY(json["void_triangles"].toInt() > 0);
    QCOMPARE(json["area"].toDouble(), 78.0 * 58 - 4 * 4);
    SANDREEL_RUN(
        simple, 0,
        {"--json", "terrain", "simplify", path("hills.terrain"), "-o", path("simple.terrain"), "--max-error", "2"});
    QVERIFY(simple.json()["vertices"].toInt() < json["vertices"].toInt());
    SANDREEL_RUN(valid, 0, {"terrain", "validate", path("simple.terrain")});
    SANDREEL_RUN(text, 0, {"terrain", "info", path("simple.terrain")});
    QVERIFY2(text.out.contains("vertices") && text.out.contains("void"), text.out.constData());
}

void TestTerrain::refusesWithItsExitCode_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("says");
    put(path("broken.terrain"), "PK\x03\x04 nothing");
    put(path("wall.obj"), "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
    put(path("four.raw"), "abcd");
    put(path("bad.json"), "{\"steps\": [{\"validate\": true}, {\"stroke\": {\"tool\": \"spoon\"}}]}");
    QTest::newRow("a script with a wrong tool")
        << QStringList{"terrain", "run", path("bad.json"), "-o", path("w.terrain")} << 2 << "steps[1].stroke.tool";
    QTest::newRow("no sub-command") << QStringList{"terrain"} << 2 << "";
    QTest::newRow("no file") << QStringList{"terrain", "info", path("none.terrain")} << 4 << "no such file";
    QTest::newRow("a broken file") << QStringList{"terrain", "validate", path("broken.terrain")} << 3
                                   << "broken.terrain";
    QTest::newRow("a wall") << QStringList{"terrain", "import", path("wall.obj"), "-o", path("w.terrain")} << 3
                            << "stands upright";
    QTest::newRow("another ending") << QStringList{"terrain", "import", path("hills.asc"), "-o", path("w.anim")} << 2
                                    << "--output";
    QTest::newRow("onto itself") << QStringList{"terrain", "import", path("hills.terrain"), "-o", path("hills.terrain")}
                                 << 2 << "";
    QTest::newRow("an error below 0") << QStringList{"terrain", "import",          path("hills.asc"),
                                                     "-o",      path("w.terrain"), "--max-error",
                                                     "-1"}
                                      << 2 << "--max-error";
    QTest::newRow("a RAW without a size")
        << QStringList{"terrain", "import", path("four.raw"), "-o", path("w.terrain")} << 2 << "COLUMNSxROWS";
    QTest::newRow("a RAW too short") << QStringList{"terrain",    "import", path("four.raw"), "-o", path("w.terrain"),
                                                    "--raw-size", "9x9"}
                                     << 3 << "too early";
    QTest::newRow("no number") << QStringList{"terrain",  "import", path("hills.asc"), "-o", path("w.terrain"),
                                              "--nodata", "x"}
                               << 2 << "--nodata";
    QTest::newRow("an unknown material") << QStringList{"terrain", "new", "-o", path("w.terrain"), "--layer", "gold:1"}
                                         << 2 << "dry sand";
    QTest::newRow("too many vertices") << QStringList{"terrain", "new",       "-o", path("w.terrain"), "--size", "1e9",
                                                      "1e9",     "--spacing", "1"}
                                       << 5 << "";
    QTest::newRow("an unknown export") << QStringList{"terrain", "export", path("hills.terrain"), "-o", path("w.doc")}
                                       << 2 << "geojson";
    QTest::newRow("too fine a raster") << QStringList{"terrain", "export", path("hills.terrain"), "-o", path("w.tif"),
                                                      "--cell",  "1e-6"}
                                       << 5 << "";
    QTest::newRow("contours beyond counting")
        << QStringList{"terrain", "export", path("hills.terrain"), "-o", path("w.geojson"), "--interval", "1e-7"} << 5
        << "";
}

void TestTerrain::refusesWithItsExitCode()
{
    QFETCH(const QStringList, arguments);
    QFETCH(const int, code);
    QFETCH(const QString, says);
    const QStringList before = tests::contentsOf(mFolder.path());
    SANDREEL_RUN(run, code, arguments);
    QVERIFY2(QString::fromUtf8(run.err).contains(says), run.err.constData());
    QCOMPARE(run.out, QByteArray());
    QCOMPARE(tests::contentsOf(mFolder.path()), before);
}

void TestTerrain::outputThatCannotBeWritten()
{
    SANDREEL_RUN(gone, 4,
                 {"terrain", "simplify", path("hills.terrain"), "-o", path("gone/x.terrain"), "--max-error", "1"});
    // A full disk: the file that was there stays.
    QVERIFY(QFile::copy(path("hills.terrain"), path("kept.terrain")));
    const QByteArray before = tests::readFile(path("kept.terrain"));
    {
        const tests::FileSizeLimit disk(100);
        SANDREEL_RUN(full, 4,
                     {"terrain", "simplify", path("hills.terrain"), "-o", path("kept.terrain"), "--max-error", "1"});
        SANDREEL_RUN(mesh, 4, {"terrain", "export", path("hills.terrain"), "-o", path("full.obj")});
    }
    QVERIFY(!QFile::exists(path("full.obj")));
    QCOMPARE(tests::readFile(path("kept.terrain")), before);
    if (geteuid() != 0) {
        QVERIFY(QDir().mkdir(path("locked")));
        QCOMPARE(chmod(qPrintable(path("locked")), 0500), 0);
        SANDREEL_RUN(locked, 4, {"terrain", "new", "-o", path("locked/x.terrain")});
    }
}

void TestTerrain::realModelEndToEnd_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("maxError");
    QTest::newRow("Mount St Helens") << "st_helens_2004.tif" << 2.0;
    QTest::newRow("a gully with voids") << "west_bijou_gully.asc" << 0.1;
}

/// A real elevation model through everything, checked at every step.
void TestTerrain::realModelEndToEnd()
{
    SANDREEL_REQUIRE_DATA();
    QFETCH(const QString, name);
    QFETCH(const double, maxError);
    const QString source = tests::dataFolder() + "/terrain/" + name, terrain = path("real.terrain");
    const auto validate = [&](const QString &file) { return tests::runCli({"terrain", "validate", file}).exitCode; };
    SANDREEL_RUN(imported, 0,
                 {"--json", "terrain", "import", source, "-o", terrain, "--max-error", QString::number(maxError)});
    QCOMPARE(validate(terrain), 0);
    SANDREEL_RUN(volume, 0, {"--json", "terrain", "volume", terrain});
    // Out as a raster and in again: the same cells, so the same ground to the error of both.
    SANDREEL_RUN(exported, 0, {"terrain", "export", terrain, "-o", path("real.tif")});
    SANDREEL_RUN(again, 0,
                 {"--json", "terrain", "import", path("real.tif"), "-o", path("again.terrain"), "--max-error",
                  QString::number(maxError)});
    QCOMPARE(validate(path("again.terrain")), 0);
    QCOMPARE(again.json()["samples"], imported.json()["samples"]);
    SANDREEL_RUN(volumeAgain, 0, {"--json", "terrain", "volume", path("again.terrain")});
    QCOMPARE(volumeAgain.json()["area"].toDouble(), volume.json()["area"].toDouble());
    QVERIFY(std::abs(volumeAgain.json()["volume"].toDouble() - volume.json()["volume"].toDouble()) <
            maxError * volume.json()["area"].toDouble());
    SANDREEL_RUN(infoOne, 0, {"--json", "terrain", "info", terrain});
    SANDREEL_RUN(infoTwo, 0, {"--json", "terrain", "info", path("again.terrain")});
    QCOMPARE(infoTwo.json()["origin"], infoOne.json()["origin"]);
    QCOMPARE(infoTwo.json()["crs"].toString().isEmpty(), infoOne.json()["crs"].toString().isEmpty());
    // A tool drawn across it and sand that slides, in its own layer; what was moved is neither lost nor made.
    SANDREEL_RUN(extent, 0, {"--json", "terrain", "info", terrain});
    const QJsonObject box = extent.json()["box"].toObject();
    const double width = box["max"][0].toDouble() - box["min"][0].toDouble(),
                 depth = box["max"][1].toDouble() - box["min"][1].toDouble();
    const auto number = [](double value) { return QByteArray::number(value, 'g', 12); };
    put(path("script.json"), "{\"terrain\": {\"open\": \"real.terrain\"}, \"steps\": [{\"material\": {\"index\": 0, "
                             "\"preset\": \"dry sand\"}},"
                             "{\"add_layer\": {\"material\": 0, \"thickness\": 0.5}}, {\"validate\": true},"
                             "{\"stroke\": {\"tool\": \"imprint\", \"depth\": 0.5, \"radius\": " +
                                 number(0.04 * width) + ", \"path\": [[" + number(0.4 * width) + "," +
                                 number(0.4 * depth) + "],[" + number(0.6 * width) + "," + number(0.6 * depth) +
                                 "]]}}, {\"validate\": true}, {\"erode\": {\"seconds\": 0.1}}, {\"validate\": true}]}");
    SANDREEL_RUN(played, 0, {"--json", "terrain", "run", path("script.json"), "-o", path("played.terrain")});
    QVERIFY(played.json()["stamps"].toInt() > 0);
    QCOMPARE(validate(path("played.terrain")), 0);
    SANDREEL_RUN(volumePlayed, 0, {"--json", "terrain", "volume", path("played.terrain")});
    QVERIFY2(volumePlayed.json()["drift_relative"].toDouble(1) < 1e-10, volumePlayed.out.constData());
    SANDREEL_RUN(playedOut, 0, {"terrain", "export", path("played.terrain"), "-o", path("played.tif")});
    SANDREEL_RUN(mesh, 0, {"terrain", "export", terrain, "-o", path("real.ply")});
    SANDREEL_RUN(
        simple, 0,
        {"terrain", "simplify", terrain, "-o", path("simple.terrain"), "--max-error", QString::number(4 * maxError)});
    QCOMPARE(validate(path("simple.terrain")), 0);
}

SANDREEL_TEST(TestTerrain)
#include "tst_terrain.moc"
