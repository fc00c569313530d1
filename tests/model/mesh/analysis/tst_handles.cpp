// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/mesh/analysis/closedsurface.h"
#include "model/mesh/analysis/handles.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <numbers>
#include <random>
#include <set>

using namespace model;
using namespace tests;

namespace {

using Loop = HandleReport::Loop;

/// Flat positions would make all loops alike.
std::vector<Vec3f> somewhere(std::uint32_t count)
{
    std::mt19937 random(count);
    std::uniform_real_distribution<float> unit(-1, 1);
    std::vector<Vec3f> positions(count);
    for (Vec3f &p : positions)
        p = {unit(random), unit(random), unit(random)};
    return positions;
}

std::vector<HandleReport> handlesOf(const Faces &faces, const std::vector<Vec3f> &positions)
{
    const auto report = analyseMesh(faces, positions);
    auto handles = findHandles(faces, positions, *report);
    return handles ? std::move(*handles) : std::vector<HandleReport>();
}

/// The half-edges of a loop in the surface, empty if some edge is none.
std::vector<std::uint32_t> halfEdgesOf(const ClosedSurface &surface, const Loop &loop)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> halfEdge;
    for (std::uint32_t h = 0; h < surface.halfEdgeCount(); ++h)
        halfEdge[{surface.inputVertex[surface.start[h]], surface.inputVertex[surface.end(h)]}] = h;
    std::vector<std::uint32_t> result;
    for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
        const auto found = halfEdge.find({loop.vertices[i], loop.vertices[(i + 1) % loop.vertices.size()]});
        if (found == halfEdge.end())
            return {};
        result.push_back(found->second);
    }
    return result;
}

/// Faces, lids among them, that are joined without crossing the loop.
std::uint32_t piecesWithout(const ClosedSurface &surface, const std::vector<std::uint32_t> &loop)
{
    std::set<std::uint32_t> cut;
    for (const std::uint32_t h : loop) {
        cut.insert(h);
        cut.insert(surface.opposite[h]);
    }
    std::vector<std::uint32_t> root(surface.faceCount);
    for (std::uint32_t f = 0; f < root.size(); ++f)
        root[f] = f;
    const auto rootOf = [&](std::uint32_t f) {
        while (root[f] != f)
            f = root[f];
        return f;
    };
    std::uint32_t pieces = surface.faceCount;
    for (std::uint32_t h = 0; h < surface.halfEdgeCount(); ++h) {
        const std::uint32_t a = rootOf(surface.face[h]), b = rootOf(surface.face[surface.opposite[h]]);
        if (!cut.contains(h) && a != b) {
            root[a] = b;
            --pieces;
        }
    }
    return pieces;
}

/// How often a way through the faces just left of loop b crosses loop a.
std::size_t crossings(const ClosedSurface &surface, const std::vector<std::uint32_t> &a,
                      const std::vector<std::uint32_t> &b)
{
    std::set<std::uint32_t> edges;
    for (const std::uint32_t h : a) {
        edges.insert(h);
        edges.insert(surface.opposite[h]);
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < b.size(); ++i)
        // From the face on the left, around the vertex, to the left of the next edge.
        for (std::uint32_t h = surface.next[b[i]]; h != b[(i + 1) % b.size()]; h = surface.next[surface.opposite[h]])
            count += edges.contains(h);
    return count;
}

/// The rank, over the field of two elements, of what bounds faces and of the loops together.
std::size_t rankOf(const ClosedSurface &surface, const std::vector<std::vector<std::uint32_t>> &loops)
{
    std::vector<std::set<std::uint32_t>> rows(surface.faceCount);
    const auto toggle = [&](std::set<std::uint32_t> &row, std::uint32_t h) {
        const std::uint32_t edge = std::min(h, surface.opposite[h]);
        if (!row.erase(edge))
            row.insert(edge);
    };
    for (std::uint32_t h = 0; h < surface.halfEdgeCount(); ++h)
        toggle(rows[surface.face[h]], h);
    for (const auto &loop : loops) {
        rows.emplace_back();
        for (const std::uint32_t h : loop)
            toggle(rows.back(), h);
    }
    std::map<std::uint32_t, std::set<std::uint32_t>> pivots;
    for (std::set<std::uint32_t> &row : rows)
        while (!row.empty()) {
            const auto [at, isNew] = pivots.emplace(*row.begin(), row);
            if (isNew)
                break;
            for (const std::uint32_t edge : at->second)
                if (!row.erase(edge))
                    row.insert(edge);
        }
    return pivots.size();
}

void checkHandles(const Faces &faces, const std::vector<Vec3f> &positions)
{
    const auto report = analyseMesh(faces, positions);
    const auto handles = findHandles(faces, positions, *report);
    QVERIFY(handles);
    const FaceLinks links(faces);
    const MeshParts parts = findParts(links);
    SurfaceCutter cutter(links, parts);
    std::size_t expected = 0;
    for (std::uint32_t c = 0; c < report->components.size(); ++c) {
        const ComponentReport &component = report->components[c];
        if (!component.isOrientable || component.genus.value_or(0) == 0)
            continue;
        expected += *component.genus;
        const ClosedSurface surface = cutter.cut(c, positions);
        QCOMPARE(surface.genus(), *component.genus);
        std::vector<std::vector<std::uint32_t>> loops;
        for (const HandleReport &handle : *handles) {
            if (handle.component != c)
                continue;
            QVERIFY(handle.loops[0].length <= handle.loops[1].length);
            for (const Loop &loop : handle.loops) {
                QCOMPARE(std::set(loop.vertices.begin(), loop.vertices.end()).size(), loop.vertices.size()); // simple
                loops.push_back(halfEdgesOf(surface, loop));
                QVERIFY(!loops.back().empty()); // closed
                QCOMPARE(piecesWithout(surface, loops.back()), 1u);
                double length = 0;
                for (const std::uint32_t h : loops.back())
                    length += double(surface.length[h]);
                QVERIFY(std::abs(length - loop.length) <= 1e-6 * length);
            }
            QVERIFY(crossings(surface, loops[loops.size() - 2], loops.back()) % 2 == 1);
        }
        QCOMPARE(loops.size(), std::size_t(2 * *component.genus));
        QCOMPARE(rankOf(surface, loops), std::size_t(surface.faceCount - 1 + 2 * *component.genus));
    }
    QCOMPARE(handles->size(), expected);
}

/// A torus around the z axis: columns around the axis, rows around the tube.
TriangleMesh roundTorus(std::uint32_t columns, std::uint32_t rows, double radius, double tube)
{
    TriangleMesh mesh;
    mesh.connectivity = sheet(columns, rows, Closing::Closed, Closing::Closed);
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const double u = 2 * std::numbers::pi * column / columns, v = 2 * std::numbers::pi * row / rows;
            const double r = radius + tube * std::cos(v);
            mesh.positions.push_back({float(r * std::cos(u)), float(r * std::sin(u)), float(tube * std::sin(v))});
        }
    return mesh;
}

} // namespace

class TestHandles final : public QObject
{
    Q_OBJECT

private slots:
    void everySurface_data()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < namedSurfaces().size(); ++i)
            QTest::newRow(namedSurfaces()[i].name.c_str()) << int(i);
    }
    void everySurface()
    {
        QFETCH(int, index);
        const Connectivity &mesh = namedSurfaces()[std::size_t(index)].mesh;
        checkHandles(Faces(mesh), somewhere(mesh.vertexCount));
    }

    void twentyHandlesAndTurnedFaces()
    {
        Connectivity mesh = tetrahedron().connectivity;
        for (std::uint32_t i = 0; i < 20; ++i)
            mesh = connectedSum(mesh, std::uint32_t(mesh.triangles.size()) - 1,
                                sheet(5 + i % 2, 5, Closing::Closed, Closing::Closed), 5);
        for (std::size_t t = 0; t < mesh.triangles.size(); t += 1 + t % 3)
            std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
        checkHandles(Faces(together(mesh, mesh)), somewhere(2 * mesh.vertexCount));
    }

    void theLoopsOfATorusAreTheShortest()
    {
        // The tube's circumference, and the inner circle around the axis.
        const TriangleMesh torus = roundTorus(60, 24, 3, 1);
        const auto handles = handlesOf(Faces(torus.connectivity), torus.positions);
        QCOMPARE(handles.size(), std::size_t(1));
        const double around = 24 * 2 * std::sin(std::numbers::pi / 24),
                     inner = 60 * 2 * 2 * std::sin(std::numbers::pi / 60);
        QVERIFY(std::abs(handles[0].loops[0].length - around) < 1e-4);
        QVERIFY(std::abs(handles[0].loops[1].length - inner) < 1e-4);
        QCOMPARE(handles[0].loops[0].vertices.size(), std::size_t(24));
        QCOMPARE(handles[0].loops[1].vertices.size(), std::size_t(60));
    }

    void polygonsHaveHandlesToo()
    {
        Faces faces(36);
        for (std::uint32_t row = 0; row < 6; ++row)
            for (std::uint32_t column = 0; column < 6; ++column) {
                const auto at = [](std::uint32_t c, std::uint32_t r) { return r % 6 * 6 + c % 6; };
                faces.add(
                    std::array{at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)});
            }
        checkHandles(faces, somewhere(36));
        QCOMPARE(handlesOf(faces, somewhere(36)).size(), std::size_t(1));
    }

    void threadsDoNotChangeTheLoops()
    {
        const TriangleMesh torus = roundTorus(40, 20, 3, 1);
        const auto digest = [&] {
            std::vector<std::uint32_t> all;
            for (const HandleReport &handle : handlesOf(Faces(torus.connectivity), torus.positions))
                for (const Loop &loop : handle.loops)
                    all.insert(all.end(), loop.vertices.begin(), loop.vertices.end());
            return all;
        };
        setThreadCount(1);
        const auto one = digest();
        setThreadCount(4);
        QVERIFY(digest() == one);
        setThreadCount(0);
    }

    void aCancelIsAnError()
    {
        const TriangleMesh torus = roundTorus(20, 12, 3, 1);
        const Faces faces(torus.connectivity);
        const auto report = analyseMesh(faces, torus.positions);
        const Progress progress;
        progress.cancel();
        const auto handles = findHandles(faces, torus.positions, *report, progress);
        QVERIFY(!handles && handles.error().code == ErrorCode::Cancelled);
    }
};

SANDREEL_TEST(TestHandles)
#include "tst_handles.moc"
