// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/connectivity/connectivitystage.h"
#include "model/io/animationreader.h"
#include "model/mesh/manifoldcut.h"
#include "tests/model/io/iotest.h"
#include "tests/support/realdata.h"
#include "tests/support/surfaces.h"
#include "tests/support/testmain.h"

#include <QDir>
#include <QFile>

using namespace model;
using namespace model::io;

namespace {

/// Fields of one line; commas inside quotes do not separate.
QStringList csvFields(const QString &line)
{
    QStringList fields{QString()};
    bool quoted = false;
    for (const QChar c : line) {
        if (c == QLatin1Char('"'))
            quoted = !quoted;
        else if (c == QLatin1Char(',') && !quoted)
            fields << QString();
        else
            fields.back() += c;
    }
    return fields;
}

/// Triangles of "3:32 4:468": number of corners, number of polygons.
int triangleCount(const QString &polygonSizes)
{
    int count = 0;
    for (const QString &entry : polygonSizes.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        const QStringList parts = entry.split(QLatin1Char(':'));
        count += (parts.at(0).toInt() - 2) * parts.at(1).toInt();
    }
    return count;
}

} // namespace

/// What real files of others hold, as independent scripts counted it.
class TestRealData final : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { SANDREEL_REQUIRE_DATA(); }

    void meshes_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("vertices");
        QTest::addColumn<int>("triangles");
        QTest::addColumn<bool>("manifold");
        QTest::addColumn<int>("components");
        QTest::addColumn<int>("loops");
        QTest::addColumn<int>("genus");
        const QStringList lines = QString::fromUtf8(tests::contents(tests::dataFolder() + "/meshes/expected.csv"))
                                      .split('\n', Qt::SkipEmptyParts);
        const QStringList names = csvFields(lines.at(0));
        for (qsizetype i = 1; i < lines.size(); ++i) {
            const QStringList fields = csvFields(lines[i]);
            const QString file = fields.at(names.indexOf("file"));
            QTest::newRow(qPrintable(file))
                << file << fields.at(names.indexOf("V")).toInt()
                << triangleCount(fields.at(names.indexOf("polygon_sizes"))) << isCleanManifold(fields, names)
                << fields.at(names.indexOf("components_edge")).toInt()
                << fields.at(names.indexOf("boundary_loops")).toInt()
                << int(fields.at(names.indexOf("genus_total")).toDouble());
        }
    }
    static bool isCleanManifold(const QStringList &fields, const QStringList &names)
    {
        return fields.at(names.indexOf("manifold")) == "True" && fields.at(names.indexOf("orientable")) == "True" &&
               fields.at(names.indexOf("inconsistent_edges")).toInt() == 0;
    }
    void meshes()
    {
        QFETCH(QString, file);
        QFETCH(int, vertices);
        QFETCH(int, triangles);
        const auto mesh = readMesh(tests::dataFolder() + "/meshes/" + file);
        if (file == "notenoughindices.obj") { // a "face" of two vertices
            SANDREEL_COMPARE_ERROR(mesh, ErrorCode::SyntaxError);
            QCOMPARE(mesh.error().line, std::uint64_t(9));
            return;
        }
        if (file == "empty.obj") {
            SANDREEL_COMPARE_ERROR(mesh, ErrorCode::NoVertices);
            return;
        }
        QVERIFY(mesh.has_value());
        QCOMPARE(int(mesh->positions.size()), vertices);
        QCOMPARE(int(mesh->connectivity.vertexCount), vertices);
        QCOMPARE(int(mesh->connectivity.triangles.size()), triangles);
        checkTopology(mesh->connectivity);
        checkCoding(mesh->connectivity);
    }
    static void checkTopology(const Connectivity &mesh)
    {
        QFETCH(bool, manifold);
        QFETCH(int, components);
        QFETCH(int, loops);
        QFETCH(int, genus);
        if (!manifold)
            return;
        const ManifoldCut cut = cutIntoManifold(mesh);
        QCOMPARE(cut.copied.size(), std::size_t(0));
        QVERIFY(cut.flipped.empty());
        const TopologyCounts counts = topologyOf(cut.corners);
        QCOMPARE(int(counts.components), components);
        QCOMPARE(int(counts.borders), loops);
        QCOMPARE(int(counts.genus()), genus);
    }
    static void checkCoding(const Connectivity &mesh)
    {
        const auto encoded = codec::encodeConnectivity(mesh, Progress());
        QVERIFY(encoded.has_value());
        const codec::Chunk chunk{"CLRS", encoded->bytes, 0, encoded->bytes.size(), 0};
        const auto decoded = codec::decodeConnectivity(chunk, mesh.vertexCount, std::uint32_t(mesh.triangles.size()),
                                                       std::uint64_t(1) << 30, Progress());
        QVERIFY(decoded.has_value());
        QVERIFY(tests::canonical(tests::renamed(decoded->connectivity.triangles, encoded->permutation)) ==
                tests::canonical(mesh.triangles));
        // At most 2 bits a triangle; the smallest meshes (below 50) need up to 6 bytes more.
        QVERIFY(8.0 * double(encoded->bytes.size()) <=
                2.0 * double(mesh.triangles.size()) + (mesh.triangles.size() < 50 ? 48 : 0));
    }

    void sequences_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<int>("frames");
        QTest::addColumn<int>("vertices");
        QTest::addColumn<int>("triangles");
        QTest::newRow("chicken") << "chicken/chicken.pc2" << 400 << 3030 << 5664;
        QTest::newRow("cow") << "cow/cow.pc2" << 204 << 2904 << 5804;
        QTest::newRow("dance") << "dance/dance.pc2" << 201 << 7061 << 14118;
        QTest::newRow("samba") << "samba/samba.pc2" << 175 << 9971 << 19938;
        QTest::newRow("horse-gallop") << "horse-gallop" << 48 << 8431 << 16843;
        QTest::newRow("cloth_honey") << "cloth_honey" << 60 << 2625 << 5168;
        QTest::newRow("bone") << "bone" << 400 << 754 << 1504;
        QTest::newRow("robot_dance") << "robot_dance" << 81 << 1820 << 3234;
        QTest::newRow("morph_columns") << "morph_columns" << 225 << 1224 << 2412;
        QTest::newRow("faerie_md2") << "faerie_md2" << 198 << 366 << 654;
        QTest::newRow("prism_rigid") << "prism_rigid" << 50 << 10 << 16;
    }
    void sequences()
    {
        QFETCH(QString, path);
        QFETCH(int, frames);
        QFETCH(int, vertices);
        QFETCH(int, triangles);
        const QString name = path.section('/', 0, 0);
        const auto read = readAnimation(tests::sequenceFolder(name) + path.mid(name.size()));
        QVERIFY(read.has_value());
        QCOMPARE(int((*read)->frameCount()), frames);
        QCOMPARE(int((*read)->vertexCount()), vertices);
        QCOMPARE(int((*read)->connectivity().triangles.size()), triangles);
        QCOMPARE((*read)->name(), name.toStdString());
    }

    void changingFacesAreRefused()
    {
        const QString folder = tests::sequenceFolder("varying_connectivity");
        const auto read = readAnimation(folder);
        SANDREEL_COMPARE_ERROR(read, ErrorCode::VertexCountDiffers);
        QCOMPARE(read.error().file, (folder + "/frame_0001.obj").toStdString());
        QCOMPARE(read.error().args.at(2), (folder + "/frame_0000.obj").toStdString());
    }
};

SANDREEL_TEST(TestRealData)
#include "tst_realdata.moc"
