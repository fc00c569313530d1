// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/mesh/analysis/meshreport.h"
#include "tests/model/mesh/analysis/slowreport.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <numbers>
#include <random>

using namespace model;
using namespace tests;

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

MeshReport reportOf(const Faces &faces, const std::vector<Vec3f> &positions)
{
    Result<MeshReport> report = analyseMesh(faces, positions);
    return report ? std::move(*report) : MeshReport();
}
MeshReport reportOf(const TriangleMesh &mesh)
{
    return reportOf(Faces(mesh.connectivity), mesh.positions);
}
MeshReport reportOf(const Connectivity &connectivity)
{
    return reportOf(Faces(connectivity), somewhere(connectivity.vertexCount));
}

std::set<std::uint32_t> firsts(const MeshReport &report, ProblemKind kind)
{
    std::set<std::uint32_t> ids;
    for (const ProblemIds &at : report.of(kind))
        ids.insert(at[0]);
    return ids;
}
std::set<std::array<std::uint32_t, 2>> pairs(const MeshReport &report, ProblemKind kind)
{
    return {report.of(kind).begin(), report.of(kind).end()};
}

/// That the formulas that join the numbers hold.
void checkFormulas(const MeshReport &report)
{
    std::size_t loops = 0;
    for (const ComponentReport &c : report.components) {
        loops += c.boundaryLoops;
        QCOMPARE(c.genus.has_value(), c.isManifold);
        if (c.genus)
            QCOMPARE(c.euler(), 2 - (c.isOrientable ? 2 : 1) * std::int64_t(*c.genus) - std::int64_t(c.boundaryLoops));
        QVERIFY(!c.volume || (c.boundaryLoops == 0 && c.isOrientable && c.isManifold));
        QVERIFY(!c.genus || *c.genus < 1000000);
    }
    QCOMPARE(report.holes.size(), loops);
    if (const auto genus = report.genus(); genus && report.isManifold())
        QCOMPARE(report.euler(), 2 * std::int64_t(report.components.size()) - 2 * std::int64_t(*genus) -
                                     std::int64_t(report.holes.size()));
}

void compareWithSlow(const Faces &faces)
{
    const MeshReport report = reportOf(faces, somewhere(faces.vertexCount()));
    checkFormulas(report);
    const SlowReport slow = slowReport(faces);
    QCOMPARE(report.vertices, faces.vertexCount());
    QCOMPARE(report.faces, faces.faceCount());
    QCOMPARE(std::size_t(report.edges), slow.sidesOf.size());
    QCOMPARE(report.components.size(), slow.components.size());
    std::size_t borderEdges = 0;
    for (std::size_t c = 0; c < slow.components.size(); ++c) {
        const ComponentReport &a = report.components[c];
        const SlowReport::Component &b = slow.components[c];
        QCOMPARE(std::size_t(a.vertices), b.vertices.size());
        QCOMPARE(std::size_t(a.edges), b.edges.size());
        QCOMPARE(std::size_t(a.faces), b.faces.size());
        QCOMPARE(std::size_t(a.boundaryEdges), b.borderEdges.size());
        QCOMPARE(a.isManifold, b.isManifold);
        QCOMPARE(a.isOrientable, b.isOrientable);
        borderEdges += b.borderEdges.size();
        for (const std::uint32_t f : b.faces)
            QCOMPARE(report.componentOfFace[f], std::uint32_t(c));
    }
    QVERIFY(firsts(report, ProblemKind::NonManifoldVertex) == slow.manyFans);
    QVERIFY(firsts(report, ProblemKind::IsolatedVertex) == slow.isolated);
    QVERIFY(firsts(report, ProblemKind::DegenerateFace) == slow.degenerate);
    QVERIFY(pairs(report, ProblemKind::NonManifoldEdge) == slow.crowded);
    QVERIFY(pairs(report, ProblemKind::InconsistentEdge) == slow.inconsistent);

    // Each border edge lies in one loop; a closed one comes back along edges that join its vertices.
    std::set<std::array<std::uint32_t, 2>> seen;
    for (const HoleReport &hole : report.holes) {
        const BorderLoop &loop = hole.loop;
        for (std::size_t i = 0; i < loop.sides.size(); ++i) {
            const std::uint32_t a = faces.vertex(loop.sides[i]), b = faces.sideEnd(loop.sides[i]);
            QVERIFY(seen.insert({std::min(a, b), std::max(a, b)}).second);
            if (!loop.isClosed)
                continue;
            const std::uint32_t from = loop.vertices[i], to = loop.vertices[(i + 1) % loop.vertices.size()];
            QVERIFY((a == from && b == to) || (a == to && b == from));
        }
        QVERIFY(loop.isClosed || !slow.crowded.empty() || !slow.degenerate.empty());
    }
    QCOMPARE(seen.size(), borderEdges);
}

/// Genus `genus` as a chain of tori, `holes` triangles taken out apart from one another.
Connectivity made(std::uint32_t genus, std::uint32_t holes)
{
    const auto torusOf = [](std::uint32_t n) { return sheet(n, n, Closing::Closed, Closing::Closed); };
    Connectivity mesh = tetrahedron().connectivity;
    for (std::uint32_t i = 0; i < genus; ++i)
        mesh = connectedSum(mesh, std::uint32_t(mesh.triangles.size()) - 1, torusOf(6 + i % 3), 5);
    if (holes > 0)
        mesh = connectedSum(mesh, 0, torusOf(12), 3);
    std::vector<std::uint32_t> taken;
    for (std::uint32_t i = 0; i < holes; ++i) // rows of the last torus, two apart
        taken.push_back(std::uint32_t(mesh.triangles.size()) - 8 - 48 * (i / 5) - 4 * (i % 5));
    return without(mesh, taken);
}

} // namespace

class TestMeshReport final : public QObject
{
    Q_OBJECT

private slots:
    void everySurfaceAgreesWithTheDefinitions_data()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < namedSurfaces().size(); ++i)
            QTest::newRow(namedSurfaces()[i].name.c_str()) << int(i);
    }
    void everySurfaceAgreesWithTheDefinitions()
    {
        QFETCH(int, index);
        const NamedSurface &named = namedSurfaces()[std::size_t(index)];
        compareWithSlow(Faces(named.mesh));
        if (!named.facts)
            return;
        const MeshReport report = reportOf(named.mesh);
        QCOMPARE(std::int64_t(report.components.size()), named.facts->components);
        QCOMPARE(std::int64_t(report.holes.size()), named.facts->borders);
        QCOMPARE(std::int64_t(report.genus().value_or(99)), named.facts->genus);
    }

    void randomSoupsAgreeWithTheDefinitions()
    {
        for (std::uint32_t seed = 0; seed < 300; ++seed)
            compareWithSlow(Faces(soup(3 + seed % 17, 1 + seed % 40, seed)));
    }

    void randomPolygonsAgreeWithTheDefinitions()
    {
        std::mt19937 random(7);
        for (int round = 0; round < 200; ++round) {
            Faces faces(4 + random() % 12);
            for (std::uint32_t f = 1 + random() % 20; f > 0; --f) {
                std::vector<std::uint32_t> face(1 + random() % 6);
                for (std::uint32_t &v : face)
                    v = random() % faces.vertexCount();
                faces.add(face);
            }
            compareWithSlow(faces);
        }
    }

    void genusHolesAndComponentsThatWereMade()
    {
        for (std::uint32_t genus = 0; genus <= 20; ++genus) {
            const std::uint32_t holes = genus % 4;
            const MeshReport report = reportOf(together(made(genus, holes), made(genus / 2, 0)));
            checkFormulas(report);
            QCOMPARE(report.components.size(), std::size_t(2));
            QCOMPARE(report.components[0].genus.value_or(99), genus + (holes > 0));
            QCOMPARE(report.components[1].genus.value_or(99), genus / 2);
            QCOMPARE(report.components[0].boundaryLoops, holes);
            QVERIFY(report.isManifold());
        }
    }

    void oneSidedSurfacesAreCalledWhatTheyAre()
    {
        const MeshReport moebius = reportOf(sheet(15, 3, Closing::Twisted));
        QVERIFY(!moebius.isOrientable());
        QVERIFY(moebius.isManifold());
        QCOMPARE(moebius.components[0].genus.value_or(99), 1u);
        QCOMPARE(moebius.holes.size(), std::size_t(1));
        QVERIFY(!moebius.genus());
        const MeshReport klein = reportOf(sheet(9, 9, Closing::Twisted, Closing::Closed));
        QVERIFY(!klein.isOrientable());
        QCOMPARE(klein.components[0].genus.value_or(99), 2u);
        QCOMPARE(klein.holes.size(), std::size_t(0));
        QVERIFY(!klein.components[0].volume);
    }

    void measuresOfACube()
    {
        const MeshReport report = reportOf(cube());
        QCOMPARE(report.components[0].area, 24.0);
        QCOMPARE(report.components[0].volume.value_or(0), 8.0);
        // Away from the origin, and turned inside out.
        TriangleMesh far = cube();
        for (Vec3f &p : far.positions)
            p = p + Vec3f{4096, -8192, 1024};
        for (Triangle &t : far.connectivity.triangles)
            std::swap(t[0], t[1]);
        const MeshReport turned = reportOf(far);
        QCOMPARE(turned.components[0].volume.value_or(0), -8.0);
        QVERIFY(turned.of(ProblemKind::InsideOutComponent) == (std::vector<ProblemIds>{{0, NoId}}));
        QVERIFY(report.of(ProblemKind::InsideOutComponent).empty());
    }

    void facesWoundAgainstTheOthersDoNotChangeTheVolume()
    {
        TriangleMesh mesh = cube();
        for (const std::size_t t : {0, 4, 5, 9})
            std::swap(mesh.connectivity.triangles[t][0], mesh.connectivity.triangles[t][1]);
        const MeshReport report = reportOf(mesh);
        QCOMPARE(report.components[0].volume.value_or(0), 8.0);
        QVERIFY(report.components[0].inconsistentEdges > 0);
    }

    void polygonsCountAsOneFaceEach()
    {
        // A cube of six squares.
        Faces faces(8);
        for (const std::array<std::uint32_t, 4> &f : std::vector<std::array<std::uint32_t, 4>>{
                 {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
            faces.add(f);
        std::vector<Vec3f> positions;
        for (int i = 0; i < 8; ++i)
            positions.push_back({float(i & 1), float(i >> 1 & 1), float(i >> 2 & 1)});
        const MeshReport report = reportOf(faces, positions);
        QCOMPARE(report.faces, 6u);
        QCOMPARE(report.edges, 12u);
        QCOMPARE(report.euler(), std::int64_t(2));
        QCOMPARE(report.components[0].area, 6.0);
        QCOMPARE(report.components[0].volume.value_or(0), 1.0);
        QVERIFY(report.problems == MeshReport().problems);
    }

    void measuresOfAHole()
    {
        TriangleMesh open = cube(); // without its two triangles at z = 1
        std::erase_if(open.connectivity.triangles, [&](const Triangle &t) {
            return open.positions[t[0]].z > 0 && open.positions[t[1]].z > 0 && open.positions[t[2]].z > 0;
        });
        const MeshReport report = reportOf(open);
        QCOMPARE(report.holes.size(), std::size_t(1));
        QCOMPARE(report.holes[0].length, 8.0);
        QCOMPARE(report.holes[0].area, 4.0);
        QCOMPARE(report.holes[0].loop.sides.size(), std::size_t(4));
        QVERIFY(report.holes[0].loop.isClosed);
        QVERIFY(!report.components[0].volume);
    }

    void loopsStayWithTheirFanWhereTheSurfaceTouchesItself()
    {
        const MeshReport report = reportOf(bowTie());
        QCOMPARE(report.components.size(), std::size_t(2));
        QCOMPARE(report.holes.size(), std::size_t(2));
        QCOMPARE(report.of(ProblemKind::NonManifoldVertex).size(), std::size_t(1));
        QVERIFY(report.components[0].isManifold); // each of them is; together they are not
        QVERIFY(!report.isManifold());
    }

    void chainsBetweenCrowdedEdgesAreOneHole()
    {
        const MeshReport report = reportOf(nonManifold());
        QCOMPARE(report.holes.size(), std::size_t(1));
        QVERIFY(!report.holes[0].loop.isClosed);
        QCOMPARE(report.holes[0].loop.sides.size(), std::size_t(6));
    }

    void duplicatesAreFoundWhicheverWayRound()
    {
        Faces faces(6);
        for (const std::vector<std::uint32_t> &f : std::vector<std::vector<std::uint32_t>>{
                 {0, 1, 2}, {2, 3, 4, 5}, {1, 2, 0}, {4, 3, 2, 5}, {0, 2, 1}, {2, 4, 3, 5}})
            faces.add(f);
        const MeshReport report = reportOf(faces, somewhere(6));
        // The last has the same vertices as the second, but not the same edges.
        QVERIFY(report.of(ProblemKind::DuplicateFace) == (std::vector<ProblemIds>{{2, 0}, {3, 1}, {4, 0}}));
    }

    void duplicatesInSoupsAgreeWithTheDefinition()
    {
        for (std::uint32_t seed = 0; seed < 100; ++seed) {
            Faces faces(6);
            const Connectivity mesh = soup(6, 30, seed);
            for (const Triangle &t : mesh.triangles)
                if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
                    faces.add(t);
            QCOMPARE(reportOf(faces, somewhere(6)).of(ProblemKind::DuplicateFace).size(), slowReport(faces).duplicates);
        }
    }

    void coincidentVerticesNameTheFirst()
    {
        Faces faces(6);
        const std::vector<Vec3f> positions{{0, 0, 0},     {1, 0, 0}, {-0.0f, 0, 0},
                                           {1, 1e-7f, 0}, {1, 0, 0}, {0, 0, -0.0f}};
        const MeshReport report = reportOf(faces, positions);
        QVERIFY(report.of(ProblemKind::CoincidentVertex) == (std::vector<ProblemIds>{{2, 0}, {4, 1}, {5, 0}}));
        QCOMPARE(report.of(ProblemKind::IsolatedVertex).size(), std::size_t(6));
    }

    void facesWithoutAreaAreNotDegenerate()
    {
        const MeshReport report =
            reportOf({{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {0, 1, 0}}, {4, {{0, 1, 2}, {0, 1, 3}, {0, 0, 3}}}});
        QVERIFY(report.of(ProblemKind::ZeroAreaFace) == (std::vector<ProblemIds>{{0, NoId}}));
        QVERIFY(report.of(ProblemKind::DegenerateFace) == (std::vector<ProblemIds>{{2, NoId}}));
    }

    void threadsDoNotChangeTheReport()
    {
        const Connectivity mesh = withRandomHoles(sheet(200, 200), 7);
        const auto digest = [&] {
            const MeshReport report = reportOf(mesh);
            std::vector<double> values;
            for (const HoleReport &hole : report.holes)
                values.push_back(hole.length + hole.area);
            for (const ComponentReport &c : report.components)
                values.push_back(c.area);
            for (const auto &list : report.problems)
                for (const ProblemIds &ids : list)
                    values.push_back(ids[0] + 0.5 * ids[1]);
            return values;
        };
        setThreadCount(1);
        const auto one = digest();
        setThreadCount(4);
        QVERIFY(digest() == one);
        setThreadCount(0);
        QVERIFY(one.size() > 100);
    }

    void aCancelIsAnError()
    {
        const Progress progress;
        progress.cancel();
        const auto report = analyseMesh(Faces(cube().connectivity), cube().positions, progress);
        QVERIFY(!report && report.error().code == ErrorCode::Cancelled);
    }
};

SANDREEL_TEST(TestMeshReport)
#include "tst_meshreport.moc"
