// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/reel/coarsetofine.h"
#include "tests/model/codec/animations.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>

using namespace model;
using namespace model::codec;

namespace {

using Graph = std::vector<std::map<std::uint32_t, std::uint32_t>>; // neighbour -> length

Connectivity grid(std::uint32_t width, std::uint32_t height)
{
    Connectivity mesh{width * height, {}};
    for (std::uint32_t y = 0; y + 1 < height; ++y)
        for (std::uint32_t x = 0; x + 1 < width; ++x) {
            const std::uint32_t a = y * width + x;
            mesh.triangles.push_back({a, a + 1, a + width});
            mesh.triangles.push_back({a + 1, a + width + 1, a + width});
        }
    return mesh;
}

Connectivity fan(std::uint32_t count)
{
    Connectivity mesh{count + 1, {}};
    for (std::uint32_t i = 1; i < count; ++i)
        mesh.triangles.push_back({0, i, i + 1});
    return mesh;
}

Connectivity clique(std::uint32_t count)
{
    Connectivity mesh{count, {}};
    for (std::uint32_t a = 0; a < count; ++a)
        for (std::uint32_t b = 0; b < a; ++b)
            mesh.triangles.push_back({a, b, (a + 1) % count});
    return mesh;
}

Connectivity soup(std::uint32_t vertices, std::uint32_t triangles, unsigned seed)
{
    std::mt19937 random(seed);
    Connectivity mesh{vertices, {}};
    for (std::uint32_t t = 0; t < triangles; ++t)
        mesh.triangles.push_back({std::uint32_t(random() % vertices), std::uint32_t(random() % vertices),
                                  std::uint32_t(random() % vertices)});
    return mesh;
}

struct Named
{
    const char *name;
    Connectivity mesh;
};

std::vector<Named> meshes()
{
    Connectivity apart = grid(5, 4);
    apart.vertexCount += 7; // without a triangle
    return {{"one vertex", {1, {}}},
            {"no triangles", {5, {}}},
            {"one triangle", {3, {{0, 1, 2}}}},
            {"repeated index", {3, {{0, 0, 2}}}},
            {"grid", grid(17, 13)},
            {"with lone vertices", apart},
            {"fan", fan(60)},
            {"clique", clique(20)},
            {"soup", soup(60, 90, 1)},
            {"sparse soup", soup(300, 90, 2)}};
}

/// Removes the nodes from the last to the first, as the format says, and checks what each saw.
void replay(const Connectivity &mesh, const CoarseToFine &nodes)
{
    std::vector<std::uint32_t> nodeOf(mesh.vertexCount, ~0u);
    for (std::uint32_t i = 0; i < nodes.size(); ++i)
        nodeOf[nodes.vertices[i]] = i;
    Graph graph(nodes.size());
    for (const Triangle &t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            if (const std::uint32_t a = nodeOf[t[i]], b = nodeOf[t[(i + 1) % 3]]; a != b) {
                graph[a][b] = UnitLength;
                graph[b][a] = UnitLength;
            }
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        std::set<std::uint32_t> expected;
        for (const auto &[other, length] : graph[i])
            expected.insert(other);
        const auto adjacent = nodes.adjacent[i];
        QVERIFY(std::set<std::uint32_t>(adjacent.begin(), adjacent.end()) == expected);
        QCOMPARE(adjacent.size(), expected.size());
    }
    for (std::uint32_t i = std::uint32_t(nodes.size()); i-- > 0;) {
        const bool isRoot = nodes.levels[i] == 0;
        const auto ring = nodes.ring[i], ringLengths = nodes.ringLengths[i];
        const auto known = nodes.known[i], lengths = nodes.lengths[i];
        QCOMPARE(ring.size(), ringLengths.size());
        QCOMPARE(known.size(), lengths.size());
        QVERIFY(known.size() <= MaxKnown);
        QVERIFY(ring.size() <= 12);
        if (!isRoot) {
            QCOMPARE(ring.size(), graph[i].size());
            for (std::size_t j = 0; j < ring.size(); ++j) {
                QVERIFY(graph[i].count(ring[j]) == 1);
                QCOMPARE(ringLengths[j], graph[i][ring[j]]);
            }
            // The nearest by Dijkstra's method, over the whole graph.
            std::set<std::pair<std::uint32_t, std::uint32_t>> open{{0, i}};
            std::map<std::uint32_t, std::uint32_t> done;
            while (!open.empty()) {
                const auto [distance, at] = *open.begin();
                open.erase(open.begin());
                if (!done.emplace(at, distance).second)
                    continue;
                for (const auto &[to, length] : graph[at])
                    open.insert({distance + length, to});
            }
            done.erase(i);
            std::vector<std::uint32_t> distances;
            for (const auto &[to, distance] : done)
                distances.push_back(distance);
            std::sort(distances.begin(), distances.end());
            if (distances.empty()) {
                QCOMPARE(known.size(), std::size_t(i > 0));
            } else {
                QCOMPARE(known.size(), std::min(distances.size(), MaxKnown));
                for (std::size_t j = 0; j < known.size(); ++j) {
                    QCOMPARE(lengths[j], distances[j]);
                    QCOMPARE(done.at(known[j]), lengths[j]);
                }
            }
        }
        for (const std::uint32_t other : known)
            QVERIFY(other < i);
        for (const std::uint32_t other : ring) {
            QVERIFY(other < i);
            QVERIFY(isRoot || nodes.levels[other] < nodes.levels[i]);
        }
        // Its links go to the neighbour with the fewest, the first of those in the order of the ring.
        const auto links = graph[i];
        for (const auto &[other, length] : links)
            graph[other].erase(i);
        if (links.empty() || isRoot)
            continue;
        std::uint32_t heir = ring[0];
        for (const std::uint32_t other : ring)
            if (graph[other].size() < graph[heir].size())
                heir = other;
        for (const auto &[other, length] : links)
            if (other != heir && graph[other].count(heir) == 0)
                graph[other][heir] = graph[heir][other] = length + links.at(heir);
    }
}

} // namespace

class TestCoarseToFine final : public QObject
{
    Q_OBJECT

private slots:
    void nodesSeeWhatIsLeft_data()
    {
        QTest::addColumn<int>("row");
        const auto table = meshes();
        for (std::size_t i = 0; i < table.size(); ++i)
            QTest::newRow(table[i].name) << int(i);
    }
    void nodesSeeWhatIsLeft()
    {
        QFETCH(int, row);
        const Connectivity mesh = meshes()[std::size_t(row)].mesh;
        const auto nodes = coarseToFine(mesh, Progress());
        QVERIFY(nodes.has_value());
        std::vector<std::uint32_t> sorted = nodes->vertices;
        std::sort(sorted.begin(), sorted.end());
        std::vector<std::uint32_t> all(mesh.vertexCount);
        std::iota(all.begin(), all.end(), 0u);
        QVERIFY(sorted == all);
        QVERIFY(std::is_sorted(nodes->levels.begin(), nodes->levels.end()));
        QCOMPARE(nodes->levels.back(), nodes->finest);
        replay(mesh, *nodes);
    }

    void eachLevelIsAFractionOfTheNext()
    {
        const auto nodes = coarseToFine(grid(100, 100), Progress());
        // A triangulated grid has an independent set of a third; four colours would give a quarter.
        const auto finest = std::count(nodes->levels.begin(), nodes->levels.end(), nodes->finest);
        QVERIFY2(finest > 2500, qPrintable(QString::number(finest)));
        QVERIFY(nodes->finest < 30);
    }

    void aHubDoesNotTakeForever()
    {
        // Quadratic work would take minutes.
        const auto nodes = coarseToFine(fan(300000), Progress());
        QCOMPARE(nodes->size(), std::size_t(300001));
    }

    void cancels()
    {
        const Progress progress;
        progress.cancel();
        const auto nodes = coarseToFine(grid(50, 50), progress);
        QVERIFY(!nodes && nodes.error().code == ErrorCode::Cancelled);
    }

    void framesLieBetweenKnownOnes_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {1, 2, 3, 8, 9, 100})
            QTest::newRow(qPrintable(QString::number(count))) << count;
    }
    void framesLieBetweenKnownOnes()
    {
        QFETCH(int, count);
        const CoarseToFine nodes = coarseToFineInTime(std::uint32_t(count));
        QCOMPARE(nodes.size(), std::size_t(count));
        std::set<int> seen;
        std::uint8_t level = 0;
        std::set<int> coarser; // frames of the levels before
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const int frame = int(nodes.vertices[i]);
            if (nodes.levels[i] != level) {
                level = nodes.levels[i];
                coarser = seen;
            }
            QVERIFY(seen.insert(frame).second);
            // The five nearest of the coarser levels, of two the earlier one first.
            std::vector<int> nearest(coarser.begin(), coarser.end());
            std::stable_sort(nearest.begin(), nearest.end(),
                             [&](int a, int b) { return std::abs(a - frame) < std::abs(b - frame); });
            nearest.resize(std::min<std::size_t>(nearest.size(), 5));
            const auto known = nodes.known[i];
            QCOMPARE(known.size(), nearest.size());
            for (std::size_t j = 0; j < known.size(); ++j)
                QCOMPARE(int(nodes.vertices[known[j]]), nearest[j]);
            std::set<int> around;
            for (const std::uint32_t other : nodes.adjacent[i])
                around.insert(int(nodes.vertices[other]));
            std::set<int> expected;
            if (frame > 0)
                expected.insert(frame - 1);
            if (frame + 1 < count)
                expected.insert(frame + 1);
            QVERIFY(around == expected);
        }
    }
};

SANDREEL_TEST(TestCoarseToFine)
#include "tst_coarsetofine.moc"
