// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/mesh/edgesides.h"
#include "model/mesh/manifoldlinks.h"
#include "tests/support/rows.h"
#include "tests/support/surfaces.h"
#include "tests/support/testmain.h"

#include <map>
#include <set>

using namespace model;
using namespace tests;

namespace {

/// The links by looking every edge up in a map; nothing where the mesh is not clean.
std::optional<std::vector<Corner>> plainLinks(const Connectivity &mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, Corner> facing; // of each directed edge
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (unsigned i = 0; i < 3; ++i) {
            const std::uint32_t from = mesh.triangles[t][(i + 1) % 3], to = mesh.triangles[t][(i + 2) % 3];
            if (isDegenerate(mesh.triangles[t]) || !facing.insert({{from, to}, Corner(3 * t + i)}).second)
                return {};
        }
    std::vector<Corner> links(3 * mesh.triangles.size(), NoCorner);
    for (const auto &[edge, corner] : facing)
        if (const auto other = facing.find({edge.second, edge.first}); other != facing.end())
            links[corner] = other->second;
    return links;
}

/// Whether the triangles at each vertex hang together, by steps over the edges at it.
bool hasManyFans(const Connectivity &mesh, const std::vector<Corner> &links)
{
    std::map<std::uint32_t, std::set<std::size_t>> left; // triangles at each vertex
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const std::uint32_t v : mesh.triangles[t])
            left[v].insert(t);
    for (auto &[vertex, triangles] : left) {
        std::vector<std::size_t> reached{*triangles.begin()};
        triangles.erase(triangles.begin());
        while (!reached.empty()) {
            const std::size_t t = reached.back();
            reached.pop_back();
            for (Corner c = Corner(3 * t); c < 3 * t + 3; ++c)
                if (mesh.triangles[t][c % 3] != vertex && links[c] != NoCorner && triangles.erase(links[c] / 3))
                    reached.push_back(links[c] / 3);
        }
        if (!triangles.empty())
            return true;
    }
    return false;
}

} // namespace

class TestManifoldLinks final : public QObject
{
    Q_OBJECT

private slots:
    void cleanup() { setThreadCount(0); }

    void everySurface_data() { tests::addRows(namedSurfaces()); }
    void everySurface()
    {
        QFETCH(int, row);
        const Connectivity &mesh = namedSurfaces()[std::size_t(row)].mesh;
        check(mesh);
    }

    void randomSoups()
    {
        int clean = 0, fans = 0;
        for (std::uint32_t seed = 0; seed < 1000; ++seed) {
            const Connectivity mesh = soup(4 + seed % 37, 1 + seed % 9, seed);
            check(mesh);
            const auto links = manifoldLinks(mesh);
            clean += links.has_value();
            fans += links && links->hasManyFans;
        }
        QVERIFY(clean > 100); // so the soups tell something
        QVERIFY(fans > 30);
        QVERIFY(fans < clean);
    }

    void twoTrianglesWithTheSameDirectedEdge()
    {
        QVERIFY(!manifoldLinks({4, {{0, 1, 2}, {0, 1, 3}}}));
        QVERIFY(!manifoldLinks({5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}}));
        QVERIFY(!manifoldLinks({3, {{0, 0, 1}}}));
    }

    void oneVertexOfManyTriangles()
    {
        // A wheel: 32 spokes are linked, 33 are left to others.
        for (const std::uint32_t spokes : {8u, 9u, 31u, 32u, 33u}) {
            Connectivity mesh{spokes + 1, {}};
            for (std::uint32_t i = 0; i < spokes; ++i)
                mesh.triangles.push_back({spokes, i, (i + 1) % spokes});
            const auto links = manifoldLinks(mesh);
            QCOMPARE(links.has_value(), spokes <= 32);
            if (links) {
                QVERIFY(links->opposites == *plainLinks(mesh));
                QVERIFY(!links->hasManyFans);
            }
        }
    }

    void asManyThreadsAsThereAre()
    {
        const Connectivity mesh = sheet(300, 200);
        setThreadCount(1);
        const auto one = manifoldLinks(mesh);
        setThreadCount(3);
        const auto three = manifoldLinks(mesh);
        QVERIFY(one && three && one->opposites == three->opposites);
    }

private:
    void check(const Connectivity &mesh)
    {
        const auto links = manifoldLinks(mesh);
        const auto wanted = plainLinks(mesh);
        if (!wanted) {
            QVERIFY(!links);
        } else if (links) {
            QVERIFY(links->opposites == *wanted);
            QCOMPARE(links->hasManyFans, hasManyFans(mesh, *wanted));
        } else {
            std::map<std::uint32_t, int> degrees;
            int most = 0;
            for (const Triangle &t : mesh.triangles)
                for (const std::uint32_t v : t)
                    most = std::max(most, ++degrees[v]);
            QVERIFY(most > 32);
        }
    }
};

SANDREEL_TEST(TestManifoldLinks)
#include "tst_manifoldlinks.moc"
