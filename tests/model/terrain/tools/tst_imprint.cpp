// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/terrain/tools/strokes.h"
#include "tests/support/testmain.h"

#include <set>

using namespace model;
using namespace model::terrain;
using namespace tests;

namespace {

Stroke pressAt(Point2 p, const Imprint &tool)
{
    return {tool, {{p, 1, 0}}, {}};
}

Imprint discTool()
{
    Imprint tool;
    tool.radius = 0.1;
    tool.depth = 0.05;
    return tool;
}

/// The volume between a regular polygon of radius R at the top, one of radius r below and the walls: a frustum.
double frustum(double corners, double R, double r, double depth)
{
    const double unit = corners / 2 * std::sin(2 * M_PI / corners);
    return depth / 3 * unit * (R * R + r * r + R * r);
}

std::size_t vertexCountNear(const Tin &tin, Point2 centre, double radius)
{
    DiscSearch search;
    search.search(tin, centre, radius);
    return search.vertices().size();
}

} // namespace

class TestImprint final : public QObject
{
    Q_OBJECT

private slots:
    /// The closed form of the hole, and the rim holds it all.
    void aDiscInFlatGroundDigsAFrustum()
    {
        for (const std::size_t count : {std::size_t(0), std::size_t(3000)}) {
            Tin tin = count ? ground(count, 0) : Tin({{0, 0}, {1, 1}});
            const double volume = tin.volume();
            const Imprint tool = discTool();
            const auto report = drawAndCheck(tin, pressAt({0.47, 0.53}, tool));
            // The sole's sides lie a gap inside those of the outline.
            const double apothem = 0.1 * std::cos(M_PI / 12), inner = 0.1 * (apothem - 0.05 * 0.1) / apothem;
            const double dug = frustum(12, 0.1, inner, 0.05);
            if (count == 0) // among other vertices, corners snap to neighbours
                QVERIFY2(std::abs(report.moved - dug) < 1e-12 * dug,
                         qPrintable(QString::number(report.moved / dug - 1)));
            else
                QVERIFY(std::abs(report.moved - dug) < 0.02 * dug);
            QVERIFY(std::abs(tin.volume() - volume) <= 1e-14);
            QCOMPARE(report.added, 0.0);
            QCOMPARE(report.removed, 0.0);
            QCOMPARE(report.stamps, 1u);
        }
    }
    void theSoleIsFlatAndItsVerticesAreGone()
    {
        Tin tin = ground(20000);
        const double level = tin.heightAt({0.5, 0.5}) - 0.2; // deeper than the waves
        Imprint tool = discTool();
        tool.depth = 0.2;
        drawAndCheck(tin, pressAt({0.5, 0.5}, tool));
        for (const double angle : {0.0, 1.0, 2.5, 4.0})
            for (const double r : {0.0, 0.05, 0.085}) {
                const double height = tin.heightAt({0.5 + r * std::cos(angle), 0.5 + r * std::sin(angle)});
                QVERIFY(std::abs(height - level) < 1e-12);
            }
        QCOMPARE(vertexCountNear(tin, {0.5, 0.5}, 0.08), std::size_t(0));
    }
    /// On ground that is not even, the outline stays where the ground was, within its tolerance.
    void theOutlineFollowsTheGround()
    {
        Tin tin = ground(20000);
        const Tin before = tin;
        const Imprint tool = discTool();
        drawAndCheck(tin, pressAt({0.4, 0.6}, tool));
        std::size_t edges = 0;
        for (std::size_t r = 0; r < tin.arrays().records.size(); ++r) {
            const ConstraintRecord &record = tin.arrays().records[r];
            if (record.a == None)
                continue;
            const Point2 a = tin.arrays().points[record.a], b = tin.arrays().points[record.b];
            if (std::min(std::hypot(a.x - 0.4, a.y - 0.6), std::hypot(b.x - 0.4, b.y - 0.6)) < 0.096)
                continue; // of the sole, whose corners lie 0.0948 from the centre
            for (const double t : {0.0, 0.3, 0.6, 1.0}) {
                const Point2 p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
                const double height = tin.arrays().heights[record.a] +
                                      t * (tin.arrays().heights[record.b] - tin.arrays().heights[record.a]);
                QVERIFY(std::abs(height - before.heightAt(p)) < 0.02 * 0.1 + 0.002);
            }
            ++edges;
        }
        QVERIFY(edges >= 12);
    }
    void theRimIsHighestAround()
    {
        Tin tin = ground(5000, 0);
        drawAndCheck(tin, pressAt({0.5, 0.5}, discTool()));
        double highest = 0;
        Point2 at;
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
            if (tin.arrays().isVertex(v) && tin.arrays().heights[v] > highest) {
                highest = tin.arrays().heights[v];
                at = tin.arrays().points[v];
            }
        QVERIFY(highest > 1.005);
        const double r = std::hypot(at.x - 0.5, at.y - 0.5);
        QVERIFY(r > 0.1 && r < 0.2);
        QVERIFY(std::abs(tin.heightAt({0.75, 0.5}) - 1) < 1e-12); // beyond the rim nothing moved
    }
    /// A tool in motion heaps before itself and leaves the trench behind it free.
    void aMovingToolPushesAhead()
    {
        Tin tin = ground(5000, 0);
        Imprint tool = discTool();
        tool.rim.directedSpeed = 0.1;
        const Stroke stroke{tool, {{{0.3, 0.5}, 1, 1}, {{0.6, 0.5}, 1, 1}}, {}};
        const double volume = tin.volume();
        drawAndCheck(tin, stroke);
        QVERIFY(std::abs(tin.volume() - volume) < 1e-13);
        double ahead = 1, behind = 1;
        for (double d = 0.1; d < 0.2; d += 0.005) {
            ahead = std::max(ahead, tin.heightAt({0.6 + d, 0.5}));
            behind = std::max(behind, tin.heightAt({0.3 - d, 0.5}));
        }
        QVERIFY2(ahead - 1 > 3 * (behind - 1), qPrintable(QString("%1 %2").arg(ahead).arg(behind)));
        for (double x = 0.3; x < 0.6; x += 0.02) // the trench is clean
            QVERIFY(std::abs(tin.heightAt({x, 0.5}) - 0.95) < 1e-9);
    }
    /// A tool a thirtieth as wide as the triangles are: what they gain by being divided anew is a hundred times what it
    /// digs, and once made a tower of the rim that the next stamp made worse.
    void onCoarseGroundNothingGoesBeyondTheTool()
    {
        std::vector<Point3> points;
        for (int y = 0; y <= 20; ++y)
            for (int x = 0; x <= 20; ++x)
                points.push_back({double(x), double(y), 1});
        Imprint tool;
        tool.radius = 1.0 / 30;
        tool.depth = 1.0 / 60;
        for (const auto &[y, speed] : {std::pair(10.0, 1.0), {10.3, 100.0}, {9.77, 100.0}, {10.0, 100.0}}) {
            Tin tin = std::move(buildTin(points, {{0, 0}, {20, 20}})->tin);
            const double volume = tin.volume();
            drawAndCheck(tin, {tool, {{{6, y}, 1, speed}, {{14, y + 0.02}, 1, speed}}, {}});
            const TinArrays &arrays = tin.arrays();
            double lowest = 1, highest = 1;
            for (VertexId v = 0; v < arrays.vertexSlots(); ++v)
                if (arrays.isVertex(v)) {
                    lowest = std::min(lowest, arrays.heights[v]);
                    highest = std::max(highest, arrays.heights[v]);
                }
            QVERIFY2(lowest > 1 - 2 * tool.depth, qPrintable(QString::number(lowest)));
            QVERIFY2(highest < 1 + 5 * tool.depth, qPrintable(QString::number(highest)));
            QVERIFY(std::abs(tin.volume() - volume) < 1e-12 * volume);
        }
    }
    void compressionTakesVolume()
    {
        Tin tin = ground(2000, 0);
        Imprint tool = discTool();
        tool.rim.compressibility = 0.75;
        const auto report = drawAndCheck(tin, pressAt({0.5, 0.5}, tool));
        QVERIFY(report.compressed > 0);
        QVERIFY(report.removed < 1e-15); // it is still there, denser
        QCOMPARE(tin.ledger().pressed.value(), report.compressed);
        QVERIFY(std::abs(report.moved - report.compressed / 3) < 1e-14);
    }
    void outlinesOfAnyShapeAreConstrained()
    {
        const auto star =
            Outline::polygon({{1, 0}, {0.3, 0.3}, {0, 1}, {-0.3, 0.3}, {-1, 0}, {-0.3, -0.3}, {0, -1}, {0.3, -0.3}});
        QVERIFY(star);
        for (const Outline &outline : {Outline::disc(), Outline::square(), Outline::wedge(), *star}) {
            Tin tin = ground(4000, 0.05);
            Imprint tool = discTool();
            tool.outline = outline;
            tool.rotation = 17;
            const auto report = drawAndCheck(tin, pressAt({0.5, 0.5}, tool), 7);
            const double area = doubleAreaOf(outline.points()) / 2 * 0.01;
            QVERIFY(report.moved > 0.7 * area * 0.05 && report.moved < 1.1 * area * 0.05);
            std::set<OwnerId> owners;
            for (std::size_t r = 0; r < tin.arrays().records.size(); ++r)
                if (tin.arrays().records[r].a != None)
                    owners.insert(tin.arrays().records[r].owner);
            QCOMPARE(owners, std::set<OwnerId>{7});
            QCOMPARE(report.nextOwner, 8u);
        }
    }
    void tooNarrowOutlinesAreRefused()
    {
        Imprint tool = discTool();
        tool.outline = *Outline::polygon({{-1, -1e-5}, {1, -1e-5}, {1, 1e-5}, {-1, 1e-5}});
        Tin tin = ground(10);
        QCOMPARE(draw(tin, pressAt({0.5, 0.5}, tool)).error().code, ErrorCode::BadSetting);
    }
    /// Older stamps leave nothing under a new one, and at one spot nothing piles up.
    void constraintsOfOlderStampsGo()
    {
        Tin tin = ground(2000);
        Imprint small = discTool();
        small.radius = 0.04;
        OwnerId owner = 1;
        ToolMemory memory;
        for (const Point2 p : {Point2{0.45, 0.5}, Point2{0.55, 0.5}, Point2{0.5, 0.55}})
            owner = draw(tin, pressAt(p, small), owner, memory)->report.nextOwner;
        QCOMPARE(owner, 4u);
        Imprint large = discTool();
        large.radius = 0.2;
        large.depth = 0.3;
        drawAndCheck(tin, pressAt({0.5, 0.5}, large), owner);
        for (std::size_t r = 0; r < tin.arrays().records.size(); ++r)
            if (tin.arrays().records[r].a != None)
                QCOMPARE(tin.arrays().records[r].owner, owner);
    }
    void theSameAtAnyInputRate()
    {
        const std::vector<PathPoint> path{{{0.2, 0.3}, 0.5, 0}, {{0.7, 0.4}, 1, 2}, {{0.5, 0.8}, 1, 0}};
        std::vector<PathPoint> dense{path[0]};
        for (std::size_t i = 1; i < path.size(); ++i)
            for (int k = 1; k <= 137; ++k) {
                const double t = k / 137.0;
                const PathPoint &a = path[i - 1], &b = path[i];
                dense.push_back({{a.at.x + t * (b.at.x - a.at.x), a.at.y + t * (b.at.y - a.at.y)},
                                 a.pressure + t * (b.pressure - a.pressure),
                                 a.speed + t * (b.speed - a.speed)});
                if (k == 137)
                    dense.back() = b;
            }
        Imprint imprint = discTool();
        imprint.radius = 0.05;
        Brush brush;
        brush.radius = 0.1;
        for (const Tool &tool :
             {Tool(imprint), Tool(Raise{brush, 0.01}), Tool(Smooth{brush, 0.5}), Tool(Rake{0.2, 5, 0.02, 0.25, {}}),
              Tool(Pour{brush, 1e-4}), Tool(Breakline{0.03, {}})}) {
            Tin a = ground(3000), b = a;
            const auto sparse = draw(a, {tool, path, {}});
            const auto often = draw(b, {tool, dense, {}});
            QVERIFY(sparse && often);
            QCOMPARE(sparse->report.stamps, often->report.stamps);
            QVERIFY2(a.fingerprint() == b.fingerprint(), nameOf(tool));
        }
    }
    void symmetricStrokesMoveAsMuchOnEachSide()
    {
        Tin tin({{0, 0}, {1, 1}});
        Imprint tool = discTool();
        tool.outline = Outline::wedge();
        tool.radius = 0.06;
        const auto one = draw(tin, pressAt({0.25, 0.75}, tool));
        Tin four({{0, 0}, {1, 1}});
        Stroke stroke = pressAt({0.25, 0.75}, tool);
        stroke.symmetry = {Symmetry::Kind::MirrorBoth, {0.5, 0.5}, 2};
        const auto report = drawAndCheck(four, stroke);
        QCOMPARE(report.stamps, 4u);
        QVERIFY(std::abs(report.moved - 4 * one->report.moved) < 1e-12);
        for (const Point2 p : {Point2{0.26, 0.755}, Point2{0.25, 0.74}, Point2{0.23, 0.75}})
            QVERIFY(std::abs(four.heightAt(p) - four.heightAt({1 - p.x, 1 - p.y})) < 1e-9);
    }
    void masksLeaveStampsOut()
    {
        Tin tin = ground(2000);
        Imprint tool = discTool();
        tool.mask.lowestHeight = 5;
        const std::uint64_t before = tin.fingerprint();
        const auto done = draw(tin, pressAt({0.5, 0.5}, tool));
        QVERIFY(done && done->edit.isEmpty());
        QCOMPARE(done->report.stamps, 0u);
        QCOMPARE(tin.fingerprint(), before);
    }
    void whatWasTouchedIsReported()
    {
        Tin tin = ground(5000);
        const Tin before = tin;
        const auto done = draw(tin, pressAt({0.5, 0.5}, discTool()));
        const Touched touched = touchedBy(tin, done->edit);
        const std::set<TriangleId> triangles(touched.triangles.begin(), touched.triangles.end());
        for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t) {
            if (!tin.arrays().isTriangle(t))
                continue;
            bool isSame = t < before.arrays().triangleSlots() && before.arrays().isTriangle(t);
            for (std::uint32_t i = 0; isSame && i < 3; ++i) {
                const VertexId v = tin.arrays().vertex(cornerOf(t, i));
                isSame = v == before.arrays().vertex(cornerOf(t, i)) &&
                         tin.arrays().heights[v] == before.arrays().heights[v];
            }
            QVERIFY(isSame || triangles.count(t));
        }
        QVERIFY(touched.triangles.size() < 2000);
    }
};

SANDREEL_TEST(TestImprint)
#include "tst_imprint.moc"
