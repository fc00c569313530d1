// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/terrain/tools/strokes.h"
#include "tests/support/testmain.h"

using namespace model;
using namespace model::terrain;
using namespace tests;

namespace {

bool areHeightsFinite(const Tin &tin)
{
    for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
        if (tin.arrays().isVertex(v) && !std::isfinite(tin.arrays().heights[v]))
            return false;
    return true;
}

} // namespace

class TestHostileStrokes final : public QObject
{
    Q_OBJECT

private slots:
    void partlyAndFullyOutside()
    {
        for (const Tool &tool : everyTool(0.1)) {
            Tin tin = ground(800);
            drawAndCheck(tin, {tool, line({-0.3, 0.4}, {1.3, 0.6}), {}});
            drawAndCheck(tin, {tool, line({-0.03, -0.04}, {1.02, 0.01}), {}});
            QVERIFY2(areHeightsFinite(tin), nameOf(tool));
            const auto far = draw(tin, {tool, line({5, 5}, {6, 6}), {}});
            QVERIFY2(far && far->edit.isEmpty(), nameOf(tool));
        }
    }
    void largerThanTheTerrain()
    {
        for (const double radius : {0.6, 3.0, 1000.0})
            for (const Tool &tool : everyTool(radius)) {
                Tin tin = ground(300);
                drawAndCheck(tin, {tool, line({0.5, 0.5}, {0.6, 0.5}), {}});
                QVERIFY2(areHeightsFinite(tin), nameOf(tool));
            }
    }
    /// A sole that covers everything has no room for a rim: what it digs leaves the terrain, and is said to.
    void aToolOverEverythingLosesWhatItDigs()
    {
        Tin tin = ground(300, 0);
        Imprint tool;
        tool.outline = Outline::square();
        tool.radius = 100;
        tool.depth = 0.25;
        const auto report = drawAndCheck(tin, {tool, {{{0.5, 0.5}, 1, 0}}, {}});
        QVERIFY(std::abs(report.removed - 0.25) < 1e-12);
        QVERIFY(std::abs(tin.volume() - 0.75) < 1e-12);
        QCOMPARE(tin.vertexCount(), 4u);
    }
    void noOrTinyRadius()
    {
        for (const Tool &tool : everyTool(0)) {
            Tin tin = ground(50);
            const auto done = draw(tin, {tool, line({0.4, 0.5}, {0.5, 0.5}), {}});
            if (!std::holds_alternative<Breakline>(tool)) {
                QVERIFY2(!done, nameOf(tool));
                QCOMPARE(done.error().code, ErrorCode::BadSetting);
            }
        }
        for (const double radius : {1e-3, 1e-9, 1e-17, 1e-300}) {
            Tin tin = ground(50);
            Imprint tool;
            tool.radius = radius;
            drawAndCheck(tin, {tool, {{{0.4, 0.5}, 1, 0}}, {}});
        }
    }
    void aRingThroughVerticesThatAreThere()
    {
        // A grid whose vertices lie on the outline of a square tool and on its sole's.
        std::vector<Point3> points;
        for (int y = 0; y <= 20; ++y)
            for (int x = 0; x <= 20; ++x)
                points.push_back({x / 20.0, y / 20.0, 1 + 0.1 * ((x + y) % 2)});
        Tin tin = std::move(buildTin(points, {{0, 0}, {1, 1}})->tin);
        Imprint tool;
        tool.outline = *Outline::polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
        tool.radius = 0.25;
        tool.gap = 0.2; // 0.05: one grid cell
        tool.depth = 0.3;
        drawAndCheck(tin, {tool, {{{0.5, 0.5}, 1, 0}}, {}});
        QVERIFY(std::abs(tin.heightAt({0.5, 0.5}) - tin.heightAt({0.35, 0.65})) < 1e-12);
        drawAndCheck(tin, {tool, line({0.5, 0.5}, {0.75, 0.5}), {}});
    }
    void acrossVoids()
    {
        for (const Tool &tool : everyTool(0.15)) {
            Tin tin = ground(1500);
            DiscSearch search;
            search.search(tin, {0.55, 0.5}, 0.06);
            TinEdit edit(tin);
            edit.setVoid(search.triangles(), true);
            edit.commit();
            const std::uint64_t before = tin.fingerprint();
            const Stroke stroke{tool, line({0.3, 0.52}, {0.7, 0.5}), {}};
            if (std::holds_alternative<Breakline>(tool)) {
                QCOMPARE(draw(tin, stroke).error().code, ErrorCode::CrossingConstraints);
                QCOMPARE(tin.fingerprint(), before);
                continue;
            }
            drawAndCheck(tin, stroke);
            QVERIFY2(areHeightsFinite(tin), nameOf(tool));
            QVERIFY(tin.arrays().isVoid(tin.triangleAt({0.55, 0.5})));
        }
    }
    /// The 10,000 strokes of one who does not stop, and some that lie a little beside each other.
    void manyStrokesAtOneSpot()
    {
        for (const double jitter : {0.0, 0.01}) {
            Tin tin = ground(500);
            const double volume = tin.volume();
            std::mt19937 random(3);
            ToolMemory memory;
            OwnerId owner = 1;
            Imprint tool;
            tool.radius = 0.05;
            tool.depth = 0.001;
            std::size_t mostVertices = 0, mostRecords = 0;
            const int strokes = jitter == 0 ? 10000 : 1500;
            for (int i = 0; i < strokes; ++i) {
                const auto offset = [&] { return jitter * (random() / 4294967296.0 - 0.5); };
                const Point2 p{0.5 + offset(), 0.5 + offset()};
                const auto done = draw(tin, {tool, {{p, 1, 0}}, {}}, owner, memory);
                QVERIFY(done);
                owner = done->report.nextOwner;
                if (i < strokes / 2)
                    continue;
                mostVertices = std::max(mostVertices, std::size_t(tin.vertexCount()));
                mostRecords = std::max(mostRecords, std::size_t(tin.arrays().totals.records));
            }
            const auto defects = findDefects(tin);
            QVERIFY2(defects.empty(), defects.empty() ? "" : nameOf(defects[0].rule));
            QVERIFY(areHeightsFinite(tin));
            QVERIFY2(mostVertices < 2500, qPrintable(QString::number(mostVertices)));
            QVERIFY2(mostRecords < 1500, qPrintable(QString::number(mostRecords)));
            QVERIFY(std::abs(tin.volume() - volume) < 1e-10);
            QVERIFY(std::abs(tin.volume() - tin.ledger().expected()) < 1e-10);
        }
    }
    void everyToolManyTimesAtOneSpot()
    {
        for (const Tool &tool : everyTool(0.1)) {
            Tin tin = ground(300);
            ToolMemory memory;
            OwnerId owner = 1;
            std::uint32_t settled = 0;
            for (int i = 0; i < 200; ++i) {
                const auto done = draw(tin, {tool, line({0.45, 0.5}, {0.6, 0.53}), {}}, owner, memory);
                QVERIFY2(done, nameOf(tool));
                owner = done->report.nextOwner;
                if (i == 99)
                    settled = tin.vertexCount();
            }
            QVERIFY2(findDefects(tin).empty(), nameOf(tool));
            QVERIFY2(areHeightsFinite(tin), nameOf(tool));
            QVERIFY2(tin.vertexCount() < settled + settled / 10, nameOf(tool));
        }
    }
    void farFromTheOrigin()
    {
        for (const Tool &base : everyTool(5)) {
            std::vector<Point3> points;
            std::mt19937 random(2);
            for (int i = 0; i < 500; ++i)
                points.push_back({5.5e6 + 100 * (random() / 4294967296.0), 7.1e6 + 100 * (random() / 4294967296.0),
                                  300 + random() / 4294967296.0});
            Tin tin = std::move(buildTin(points, {{5.5e6, 7.1e6}, {5.5e6 + 100, 7.1e6 + 100}})->tin);
            drawAndCheck(tin, {base, line({5.5e6 + 30, 7.1e6 + 40}, {5.5e6 + 70, 7.1e6 + 45}), {}});
        }
    }
    /// Strokes of all kinds one upon the other, each undone and done again.
    void mixedStrokes()
    {
        Tin tin = ground(2000);
        std::mt19937 random(11);
        const auto unit = [&] { return random() / 4294967296.0; };
        OwnerId owner = 1;
        for (int i = 0; i < 40; ++i) {
            const std::vector<Tool> tools = everyTool(0.02 + 0.08 * unit());
            const Point2 a{unit(), unit()}, b{unit(), unit()};
            Stroke stroke{tools[random() % tools.size()], {{a, unit(), unit()}, {b, unit(), unit()}}, {}};
            stroke.symmetry.kind = Symmetry::Kind(random() % 5);
            stroke.symmetry.centre = {0.5, 0.5};
            owner = std::max(owner, drawAndCheck(tin, stroke, owner).nextOwner);
            QVERIFY(areHeightsFinite(tin));
        }
    }
};

SANDREEL_TEST(TestHostileStrokes)
#include "tst_hostilestrokes.moc"
