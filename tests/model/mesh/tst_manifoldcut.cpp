// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/manifoldcut.h"
#include "tests/support/rows.h"
#include "tests/support/surfaces.h"
#include "tests/support/testmain.h"

#include <map>

using namespace model;
using namespace tests;

namespace {

/// What is broken in a corner table, by the definition of each rule.
QStringList brokenRules(const CornerTable &table)
{
    QStringList broken;
    const auto v = [&](Corner c) { return table.vertex(c); };
    for (Corner c = 0; c < table.cornerCount(); ++c) {
        if (v(c) >= table.vertexCount())
            broken << QString("corner %1: no such vertex").arg(c);
        const Corner o = table.opposite(c);
        if (o == NoCorner)
            continue;
        if (o >= table.cornerCount() || table.opposite(o) != c)
            broken << QString("corner %1: the link is not mutual").arg(c);
        else if (v(table.next(c)) != v(table.previous(o)) || v(table.previous(c)) != v(table.next(o)))
            broken << QString("corner %1: the edge is another on the other side").arg(c);
        else if (c / 3 == o / 3)
            broken << QString("corner %1: its own neighbour").arg(c);
    }
    return broken;
}

/// Those of a manifold in addition.
QStringList brokenManifoldRules(const CornerTable &table)
{
    QStringList broken = brokenRules(table);
    // The corners of a vertex are one: those that are joined by steps over an edge, united one by one.
    std::vector<Corner> root(table.cornerCount());
    for (Corner c = 0; c < root.size(); ++c)
        root[c] = c;
    const auto rootOf = [&](Corner c) {
        while (root[c] != c)
            c = root[c] = root[root[c]];
        return c;
    };
    for (Corner c = 0; c < table.cornerCount(); ++c)
        for (const Corner step : {table.counterClockwise(c), table.clockwise(c)})
            if (step != NoCorner)
                root[rootOf(step)] = rootOf(c);
    std::map<std::uint32_t, Corner> fanOf;
    for (Corner c = 0; c < table.cornerCount(); ++c)
        if (fanOf.emplace(table.vertex(c), rootOf(c)).first->second != rootOf(c))
            broken << QString("vertex %1: more than one fan").arg(table.vertex(c));
    return broken;
}

std::vector<Triangle> weldedTriangles(const ManifoldCut &cut)
{
    std::vector<Triangle> triangles;
    for (Corner c = 0; c < cut.corners.cornerCount(); c += 3) {
        Triangle t{cut.inputVertex(cut.corners.vertex(c)), cut.inputVertex(cut.corners.vertex(c + 1)),
                   cut.inputVertex(cut.corners.vertex(c + 2))};
        if (cut.isFlipped(c / 3))
            std::swap(t[1], t[2]);
        triangles.push_back(t);
    }
    return triangles;
}

std::size_t flippedCount(const ManifoldCut &cut)
{
    return std::size_t(std::count(cut.flipped.begin(), cut.flipped.end(), true));
}

const Connectivity &surface(const std::string &name)
{
    for (const NamedSurface &s : namedSurfaces())
        if (s.name == name)
            return s.mesh;
    qFatal("no such surface");
}

} // namespace

class TestManifoldCut final : public QObject
{
    Q_OBJECT

private slots:
    void everySurface_data() { tests::addRows(namedSurfaces()); }
    void everySurface()
    {
        QFETCH(int, row);
        const NamedSurface &named = namedSurfaces()[std::size_t(row)];
        QCOMPARE(brokenRules(CornerTable::of(named.mesh)), QStringList());
        const ManifoldCut cut = cutIntoManifold(named.mesh);
        QCOMPARE(brokenManifoldRules(cut.corners), QStringList());
        QVERIFY(weldedTriangles(cut) == named.mesh.triangles);
        QCOMPARE(cut.inputVertexCount, named.mesh.vertexCount);
        if (named.facts) {
            QCOMPARE(cut.copied.size(), std::size_t(0));
            QVERIFY(cut.flipped.empty());
            const TopologyCounts counts = topologyOf(cut.corners);
            QCOMPARE(std::int64_t(counts.components), named.facts->components);
            QCOMPARE(std::int64_t(counts.borders), named.facts->borders);
            QCOMPARE(counts.genus(), named.facts->genus);
        }
    }

    void randomSoups()
    {
        for (std::uint32_t seed = 0; seed < 500; ++seed) {
            const Connectivity mesh = soup(3 + seed % 17, 1 + seed % 50, seed);
            const ManifoldCut cut = cutIntoManifold(mesh);
            QCOMPARE(brokenManifoldRules(cut.corners), QStringList());
            QVERIFY(weldedTriangles(cut) == mesh.triangles);
        }
    }

    void theRulesFindWhatIsBroken()
    {
        const auto table = [](std::vector<std::uint32_t> vertices, std::vector<Corner> opposites) {
            return CornerTable(4, std::move(vertices), std::move(opposites));
        };
        const Corner none = NoCorner;
        QCOMPARE(brokenManifoldRules(table({0, 1, 2, 3, 2, 1}, {3, none, none, 0, none, none})), QStringList());
        QVERIFY(!brokenRules(table({0, 1, 2, 3, 2, 1}, {3, none, none, none, none, none})).isEmpty());
        QVERIFY(!brokenRules(table({0, 1, 2, 3, 1, 2}, {3, none, none, 0, none, none})).isEmpty());
        QVERIFY(!brokenRules(table({0, 1, 9, 3, 2, 1}, {none, none, none, none, none, none})).isEmpty());
        QVERIFY(!brokenManifoldRules(table({0, 1, 2, 3, 2, 1}, {none, none, none, none, none, none})).isEmpty());
    }

    void aNonManifoldEdgeIsCutOnce()
    {
        // Two of three triangles stay linked: the third has its own copies of the edge's two vertices.
        const Connectivity mesh{5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
        const ManifoldCut cut = cutIntoManifold(mesh);
        QVERIFY(cut.copied == (std::vector<std::uint32_t>{0, 1}));
        QCOMPARE(topologyOf(cut.corners).components, 2u);
    }

    void aNonManifoldVertexIsCopiedOnce()
    {
        const ManifoldCut cut = cutIntoManifold({5, {{0, 1, 2}, {0, 3, 4}}});
        QVERIFY(cut.copied == std::vector<std::uint32_t>{0});
    }

    void turnedTrianglesAreFlippedNotCut()
    {
        const ManifoldCut cut = cutIntoManifold(surface("closed sheet with turned triangles"));
        QCOMPARE(cut.copied.size(), std::size_t(0));
        QVERIFY(flippedCount(cut) > 0 && 2 * flippedCount(cut) <= cut.flipped.size());
        QCOMPARE(topologyOf(cut.corners).genus(), std::int64_t(1));
    }

    void theSmallerNumberIsFlipped()
    {
        Connectivity mesh = sheet(10, 10);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            if (t != 7)
                std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
        const ManifoldCut cut = cutIntoManifold(mesh);
        QCOMPARE(flippedCount(cut), std::size_t(1));
        QVERIFY(cut.isFlipped(7));
    }

    void aOneSidedStripHasOneSeam()
    {
        const Connectivity &strip = surface("Moebius strip"); // 3 squares wide
        const ManifoldCut cut = cutIntoManifold(strip);
        QVERIFY(cut.copied.size() >= 4 && cut.copied.size() <= 8); // straight across it would be 4
        const TopologyCounts counts = topologyOf(cut.corners);
        QCOMPARE(counts.borders, 1u);
        QCOMPARE(counts.euler(), std::int64_t(1)); // a disc
    }

    void aRepeatedIndexIsAPartOfItsOwn()
    {
        const ManifoldCut cut = cutIntoManifold({3, {{0, 0, 1}, {0, 1, 2}}});
        QCOMPARE(topologyOf(cut.corners).components, 2u);
        QCOMPARE(cut.corners.vertexCount(), 6u);
    }

    void bordersAreWalkedInOrder()
    {
        const CornerTable table = CornerTable::of(sheet(3, 2));
        Corner first = 0;
        while (table.opposite(first) != NoCorner)
            ++first;
        std::uint32_t length = 0;
        Corner at = first;
        do {
            const Corner next = nextBorder(table, at);
            QCOMPARE(table.opposite(next), NoCorner);
            QCOMPARE(table.vertex(table.next(next)), table.vertex(table.previous(at)));
            at = next;
            ++length;
        } while (at != first && length < 100);
        QCOMPARE(length, 10u);
    }

    void aHubOfManyTrianglesIsFast()
    {
        // 300000 triangles at one edge: pairs are found without comparing each with each.
        Connectivity book{300002, {}};
        for (std::uint32_t i = 2; i < book.vertexCount; ++i)
            book.triangles.push_back(i % 2 > 0 ? Triangle{0, 1, i} : Triangle{1, 0, i});
        const ManifoldCut cut = cutIntoManifold(book);
        QCOMPARE(topologyOf(cut.corners).components, 150000u);
    }
};

SANDREEL_TEST(TestManifoldCut)
#include "tst_manifoldcut.moc"
