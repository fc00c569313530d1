// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/connectivity/connectivitystage.h"
#include "model/io/inspection.h"
#include "model/io/polygonreader.h"
#include "tests/support/compareerror.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"
#include "tests/support/testmain.h"

#include <QJsonArray>

#include <random>

using namespace model;
using namespace model::io;

namespace {

std::vector<Vec3f> somewhere(std::uint32_t count)
{
    std::mt19937 random(count);
    std::uniform_real_distribution<float> unit(-1, 1);
    std::vector<Vec3f> positions(count);
    for (Vec3f &p : positions)
        p = {unit(random), unit(random), unit(random)};
    return positions;
}

} // namespace

class TestInspectionFormats final : public QObject
{
    Q_OBJECT

private slots:
    void theWalkSaysWhatTheMeshIs()
    {
        for (const tests::NamedSurface &named : tests::namedSurfaces()) {
            if (!named.facts)
                continue;
            const auto walk = codec::walkStatistics(named.mesh);
            QVERIFY(walk);
            QCOMPARE(std::int64_t(walk->handleSplits.size()), named.facts->genus);
            QCOMPARE(std::int64_t(walk->holes.size()), named.facts->borders);
            QCOMPARE(std::int64_t(walk->components), named.facts->components);
            QCOMPARE(walk->copies, 0u);
            // Every triangle has a symbol, but the first of each closed component.
            std::uint64_t symbols = 0, withOne = 0, without = 0;
            for (const std::uint64_t count : walk->symbolCounts)
                symbols += count;
            for (const auto &symbol : walk->symbolOf)
                symbol ? ++withOne : ++without;
            QCOMPARE(symbols, withOne);
            QVERIFY(without <= walk->components);
            QCOMPARE(walk->splits.size() + walk->handleSplits.size(),
                     std::size_t(walk->symbolCounts[int(codec::Clers::S)]));
            for (const std::uint32_t t : walk->handleSplits)
                QVERIFY(walk->symbolOf[t] == codec::Clers::S);
            QVERIFY(walk->bitsPerTriangle > 0);
        }
    }

    void watchingChangesNoByte()
    {
        const Connectivity mesh = tests::connectedSum(tests::torus().connectivity, 3, tests::torus().connectivity, 7);
        QCOMPARE(codec::walkStatistics(mesh)->bytes, codec::encodeConnectivity(mesh, Progress())->bytes.size());
    }

    void tablesNameTheirColumnsAndHaveEveryRow()
    {
        const Connectivity mesh =
            tests::together(tests::without(tests::torus().connectivity, {9}), tests::nonManifold().connectivity);
        const auto inspection = inspectMesh(Faces(mesh), somewhere(mesh.vertexCount));
        QVERIFY(inspection);
        const auto rows = [&](InspectionTable table) { return inspectionCsv(*inspection, table).size() - 1; };
        QCOMPARE(rows(InspectionTable::Components), 2);
        QCOMPARE(rows(InspectionTable::Holes), 2);
        QCOMPARE(rows(InspectionTable::Handles), 2);
        std::size_t problems = 0;
        for (const auto &list : inspection->report.problems)
            problems += list.size();
        QVERIFY(problems > 0);
        QCOMPARE(rows(InspectionTable::Problems), qsizetype(problems));
        for (const auto table : {InspectionTable::Components, InspectionTable::Holes, InspectionTable::Handles,
                                 InspectionTable::Problems}) {
            const QStringList lines = inspectionCsv(*inspection, table);
            for (const QString &line : lines)
                QCOMPARE(line.count(','), lines.front().count(','));
        }
    }

    void intersectionsNotLookedForAreNotNone()
    {
        const TriangleMesh cube = tests::cube();
        const Faces faces(cube.connectivity);
        const auto count = [&](bool look) {
            InspectionOptions options;
            options.selfIntersections = look;
            const QJsonObject json = inspectionJson(*inspectMesh(faces, cube.positions, options));
            return json["problems"]["self_intersections"]["count"];
        };
        QVERIFY(count(false).isNull());
        QCOMPARE(count(true).toDouble(-1), 0.0);
    }

    void polygonsStayWholeInEveryFormat()
    {
        const char *obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2\nf 3\nf -1 -2 -3\n";
        const char *off = "OFF\n4 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n2 0 1\n1 2\n3 3 2 1\n";
        const char *ply =
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n2 0 1\n1 2\n3 3 2 1\n";
        for (const auto &[kind, text] :
             {std::pair(MeshKind::Obj, obj), std::pair(MeshKind::Off, off), std::pair(MeshKind::Ply, ply)}) {
            const auto mesh = parsePolygonMesh(kind, text);
            QVERIFY(mesh);
            QCOMPARE(mesh->faces.faceCount(), 4u);
            QCOMPARE(mesh->faces.vertexCount(), 4u);
            const std::vector<std::vector<std::uint32_t>> expected{{0, 1, 2, 3}, {0, 1}, {2}, {3, 2, 1}};
            for (std::uint32_t f = 0; f < 4; ++f)
                QVERIFY(std::ranges::equal(mesh->faces.face(f), expected[f]));
            QVERIFY(!parseMesh(kind, text)); // an animation cannot have these
        }
    }

    void nothingIsAMeshToo()
    {
        QCOMPARE(parsePolygonMesh(MeshKind::Obj, "# nothing\n")->faces.faceCount(), 0u);
        const auto inspection = inspectMesh(Faces(), {});
        QVERIFY(inspection);
        QCOMPARE(inspectionJson(*inspection)["components"].toArray().size(), 0);
        SANDREEL_COMPARE_ERROR(parsePolygonMesh(MeshKind::Obj, "v 0 0 0\nf 1 2 9\n"), ErrorCode::IndexOutOfRange);
        SANDREEL_COMPARE_ERROR(parsePolygonMesh(MeshKind::Obj, "v 0 0 0\nf \n"), ErrorCode::SyntaxError);
    }

    void aCancelIsAnError()
    {
        const Progress progress;
        progress.cancel();
        SANDREEL_COMPARE_ERROR(inspectMesh(Faces(tests::torus().connectivity), tests::torus().positions, {}, progress),
                               ErrorCode::Cancelled);
    }
};

SANDREEL_TEST(TestInspectionFormats)
#include "tst_inspectionformats.moc"
