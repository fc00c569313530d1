// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/vertexedges.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <set>

using namespace model;

class TestVertexEdges final : public QObject
{
    Q_OBJECT

private slots:
    /// Sets built by brute force, over the whole table of meshes.
    void asSetsSay_data()
    {
        QTest::addColumn<int>("mesh");
        for (std::size_t i = 0; i < tests::namedMeshes().size(); ++i)
            QTest::newRow(tests::namedMeshes()[i].name.c_str()) << int(i);
    }
    void asSetsSay()
    {
        QFETCH(int, mesh);
        const Connectivity &connectivity = tests::namedMeshes()[std::size_t(mesh)].mesh.connectivity;
        std::set<Edge> expected;
        for (const Triangle &t : connectivity.triangles)
            for (const auto &[a, b] : {std::pair(t[0], t[1]), std::pair(t[1], t[2]), std::pair(t[0], t[2])})
                if (a != b)
                    expected.insert({std::min(a, b), std::max(a, b)});
        const VertexEdges edges(connectivity);
        QVERIFY(std::ranges::equal(edges.edges(), expected));
        QCOMPARE(edges.vertexCount(), connectivity.vertexCount);

        const auto touches = [](const Edge &edge, const std::set<std::uint32_t> &vertices) {
            return vertices.contains(edge[0]) || vertices.contains(edge[1]);
        };
        for (std::uint32_t v = 0; v < connectivity.vertexCount; ++v) {
            std::set<std::uint32_t> ring{v};
            std::vector<std::uint32_t> at, around;
            for (std::uint32_t e = 0; e < expected.size(); ++e) {
                const Edge &edge = edges.edges()[e];
                if (!touches(edge, {v}))
                    continue;
                at.push_back(e);
                QCOMPARE(edges.otherEnd(e, v), edge[0] + edge[1] - v);
                ring.insert(edge.begin(), edge.end());
            }
            for (std::uint32_t e = 0; e < expected.size(); ++e)
                if (touches(edges.edges()[e], ring) && !at.empty())
                    around.push_back(e);
            QVERIFY(std::ranges::equal(edges.at(v), at));
            std::vector<std::uint32_t> found{99, 98}; // of a call before
            findEdgesAround(edges, v, found);
            QVERIFY(found == around);
        }
    }
};

SANDREEL_TEST(TestVertexEdges)
#include "tst_vertexedges.moc"
