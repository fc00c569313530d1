// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/terrain/tools/strokes.h"
#include "tests/support/testmain.h"

using namespace model;
using namespace model::terrain;
using namespace tests;

namespace {

Brush brushOf(double radius, Falloff falloff = Falloff::Smooth)
{
    Brush brush;
    brush.radius = radius;
    brush.falloff = falloff;
    return brush;
}

Stroke at(Point2 p, const Tool &tool, double pressure = 1)
{
    return {tool, {{p, pressure, 0}}, {}};
}

/// The largest and smallest height in a disc.
std::pair<double, double> rangeIn(const Tin &tin, Point2 centre, double radius)
{
    DiscSearch search;
    search.search(tin, centre, radius);
    double low = 1e300, high = -1e300;
    for (const VertexId v : search.vertices()) {
        low = std::min(low, tin.arrays().heights[v]);
        high = std::max(high, tin.arrays().heights[v]);
    }
    return {low, high};
}

} // namespace

class TestSculpt final : public QObject
{
    Q_OBJECT

private slots:
    void falloffsGoFromOneToNothing()
    {
        for (const Falloff falloff : {Falloff::Linear, Falloff::Smooth, Falloff::Sphere, Falloff::Tip}) {
            QCOMPARE(weightOf(falloff, 0), 1.0);
            QCOMPARE(weightOf(falloff, 1), 0.0);
            QCOMPARE(weightOf(falloff, 1.1), 0.0);
            for (int i = 0; i < 10; ++i)
                QVERIFY(weightOf(falloff, i / 10.0) > weightOf(falloff, (i + 1) / 10.0));
        }
        QCOMPARE(weightOf(Falloff::Constant, 1), 1.0);
        QCOMPARE(weightOf(Falloff::Linear, 0.25), 0.75);
        QCOMPARE(weightOf(Falloff::Smooth, 0.5), 0.5);
        QCOMPARE(weightOf(Falloff::Sphere, 0.6), 0.8);
        QCOMPARE(weightOf(Falloff::Tip, 0.5), 0.25);
    }
    /// A cone over flat ground without vertices: a third of height times area.
    void raiseMakesAConeOfTheRightVolume()
    {
        Tin tin({{0, 0}, {1, 1}});
        Brush brush = brushOf(0.3, Falloff::Linear);
        brush.detail = 0.02;
        const auto report = drawAndCheck(tin, at({0.5, 0.5}, Raise{brush, 0.2}));
        const double cone = M_PI * 0.09 * 0.2 / 3;
        QVERIFY2(std::abs(report.added - cone) < 0.01 * cone, qPrintable(QString::number(report.added / cone)));
        QVERIFY(tin.heightAt({0.5, 0.5}) > 0.19);
        QVERIFY(std::abs(tin.heightAt({0.5, 0.65}) - 0.1) < 0.003);
        QCOMPARE(tin.heightAt({0.5, 0.9}), 0.0);
        // A second stroke at the same spot finds the vertices there.
        const std::uint32_t count = tin.vertexCount();
        drawAndCheck(tin, at({0.5, 0.5}, Lower{brush, 0.2}));
        QCOMPARE(tin.vertexCount(), count);
        QVERIFY(std::abs(tin.volume()) < 1e-14);
    }
    void pressureScalesStrengthAndRadius()
    {
        Tin full = ground(3000, 0), half = full, narrow = full;
        Brush brush = brushOf(0.2);
        brush.detail = 0;
        const double whole = drawAndCheck(full, at({0.5, 0.5}, Raise{brush, 0.1})).added;
        const double soft = drawAndCheck(half, at({0.5, 0.5}, Raise{brush, 0.1}, 0.5)).added;
        QVERIFY(std::abs(soft - whole / 2) < 1e-12);
        brush.doesPressureScaleStrength = false;
        brush.doesPressureScaleRadius = true;
        const double thin = drawAndCheck(narrow, at({0.5, 0.5}, Raise{brush, 0.1}, 0.5)).added;
        QVERIFY(std::abs(thin - whole / 4) < 0.1 * whole / 4);
    }
    void pourAddsExactlyItsVolume()
    {
        Tin tin = ground(3000);
        QVERIFY(std::abs(drawAndCheck(tin, at({0.5, 0.5}, Pour{brushOf(0.1), 0.0123})).added - 0.0123) < 1e-15);
        Stroke stroke{Pour{brushOf(0.1), 1e-3}, line({0.3, 0.3}, {0.6, 0.3}), {}};
        const auto report = drawAndCheck(tin, stroke);
        QCOMPARE(report.stamps, 13u); // 0.3 long, every 0.025
        QVERIFY(std::abs(report.added - 13e-3) < 1e-14);
        // At the edge of the domain too.
        QVERIFY(std::abs(drawAndCheck(tin, at({0, 0.5}, Pour{brushOf(0.1), 0.01})).added - 0.01) < 1e-15);
    }
    void scoopSaysHowMuchItTook()
    {
        Tin tin = ground(3000);
        const double volume = tin.volume();
        const auto report = drawAndCheck(tin, at({0.5, 0.5}, Scoop{brushOf(0.2), 0.1}));
        QVERIFY(report.removed > 0);
        QCOMPARE(report.added, 0.0);
        QVERIFY(std::abs(volume - tin.volume() - report.removed) < 1e-14);
    }
    void flattenReachesItsLevel()
    {
        Tin tin = ground(5000);
        const double start = tin.heightAt({0.3, 0.3});
        drawAndCheck(tin, at({0.3, 0.3}, Flatten{brushOf(0.1, Falloff::Constant), 1, {}}));
        const auto [low, high] = rangeIn(tin, {0.3, 0.3}, 0.099);
        QVERIFY(std::abs(low - start) < 1e-12 && std::abs(high - start) < 1e-12);
        drawAndCheck(tin, at({0.6, 0.6}, Flatten{brushOf(0.1, Falloff::Constant), 1, 3.5}));
        QCOMPARE(rangeIn(tin, {0.6, 0.6}, 0.099), (std::pair{3.5, 3.5}));
    }
    void smoothNarrowsTheRangeAndKeepsTheVolume()
    {
        Tin tin = ground(5000, 0);
        drawAndCheck(tin, at({0.5, 0.5}, Noise{brushOf(0.3, Falloff::Constant), 0.1, 0.02, 2, 3}));
        const double volume = tin.volume();
        const auto before = rangeIn(tin, {0.5, 0.5}, 0.25);
        Brush brush = brushOf(0.29, Falloff::Constant);
        StrokeReport report;
        for (int i = 0; i < 10; ++i)
            report = drawAndCheck(tin, at({0.5, 0.5}, Smooth{brush, 1}));
        const auto after = rangeIn(tin, {0.5, 0.5}, 0.25);
        QVERIFY(after.second - after.first < 0.6 * (before.second - before.first));
        QVERIFY(std::abs(tin.volume() - volume) < 1e-13);
        QVERIFY(report.moved > 0);
        QCOMPARE(report.added, 0.0);
    }
    void noiseIsSmoothAndBounded()
    {
        double largest = 0, smallest = 0;
        for (int i = 0; i < 20000; ++i) {
            const Point2 p{i * 0.0137 - 90, i * 0.00713 + 3};
            const double value = noiseAt(p, 4, 9);
            largest = std::max(largest, value);
            smallest = std::min(smallest, value);
            QVERIFY(std::abs(value - noiseAt({p.x + 1e-6, p.y}, 4, 9)) < 1e-4);
        }
        QVERIFY(largest <= 1 && largest > 0.3 && smallest >= -1 && smallest < -0.3);
        QVERIFY(noiseAt({0.3, 0.4}, 3, 1) != noiseAt({0.3, 0.4}, 3, 2));
        QCOMPARE(noiseAt({1e300, 0}, 3, 1), 0.0);
    }
    void masksKeepSlopesAndHeightsOut()
    {
        Tin tin = ground(5000);
        const Tin before = tin;
        Brush brush = brushOf(0.45, Falloff::Constant);
        brush.detail = 0;
        brush.mask.highestHeight = 1;
        brush.mask.highestSlope = 45;
        drawAndCheck(tin, at({0.5, 0.5}, Raise{brush, 0.1}));
        std::size_t raised = 0, kept = 0;
        for (VertexId v = 0; v < before.arrays().vertexSlots(); ++v) {
            const Point2 p = before.arrays().points[v];
            if (std::hypot(p.x - 0.5, p.y - 0.5) > 0.449)
                continue;
            const bool isIn = before.arrays().heights[v] <= 1 && slopeAt(before.arrays(), v) <= 45;
            QCOMPARE(tin.arrays().heights[v] > before.arrays().heights[v], isIn);
            ++(isIn ? raised : kept);
        }
        QVERIFY(raised > 500 && kept > 500);
        Mask blended;
        blended.lowestSlope = 30;
        blended.slopeBlend = 10;
        QCOMPARE(blended.weightOf(25, 0), 0.0);
        QCOMPARE(blended.weightOf(30, 0), 0.5);
        QCOMPARE(blended.weightOf(35, 0), 1.0);
    }
    void slopeOfAPlaneIsItsSlope()
    {
        std::vector<Point3> points;
        std::mt19937 random(1);
        for (int i = 0; i < 200; ++i) {
            const double x = random() / 4294967296.0, y = random() / 4294967296.0;
            points.push_back({x, y, x});
        }
        for (const Point2 p : {Point2{0, 0}, Point2{1, 0}, Point2{1, 1}, Point2{0, 1}})
            points.push_back({p.x, p.y, p.x});
        const Tin tin = std::move(buildTin(points, {{0, 0}, {1, 1}})->tin);
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
            QVERIFY(std::abs(slopeAt(tin.arrays(), v) - 45) < 1e-9);
    }
    /// A pit is undone by restoring the ground before it, whose vertices the pit took away.
    void restoreBringsTheGroundBack()
    {
        Tin tin = ground(3000);
        const auto before = std::make_shared<const Tin>(tin);
        Imprint pit;
        pit.radius = 0.08;
        pit.depth = 0.3;
        drawAndCheck(tin, at({0.5, 0.5}, pit));
        QVERIFY(std::abs(tin.volume() - before->volume()) < 1e-13);
        Brush brush = brushOf(0.3, Falloff::Constant);
        drawAndCheck(tin, at({0.5, 0.5}, Restore{brush, 1, {{}, before}}));
        for (int i = 0; i < 400; ++i) {
            const Point2 p{0.5 + 0.2 * std::cos(i) * (i / 400.0), 0.5 + 0.2 * std::sin(i) * (i / 400.0)};
            QVERIFY(std::abs(tin.heightAt(p) - before->heightAt(p)) < 0.01);
        }
        // A function, half of the way.
        drawAndCheck(tin,
                     at({0.2, 0.2}, Restore{brushOf(0.1, Falloff::Constant), 1, {[](Point2 p) { return p.x; }, {}}}));
        QVERIFY(std::abs(tin.heightAt({0.21, 0.19}) - 0.21) < 1e-6);
    }
    void badSettingsAreNamed()
    {
        Tin tin = ground(10);
        const std::uint64_t before = tin.fingerprint();
        const auto nan = std::nan("");
        Brush noRadius = brushOf(0), fine = brushOf(0.1);
        Brush tooFine = fine, badBlend = fine;
        tooFine.detail = 1e-9;
        badBlend.mask.slopeBlend = -1;
        for (const Tool &tool :
             std::vector<Tool>{Raise{noRadius, 1}, Raise{tooFine, 1}, Raise{badBlend, 1}, Raise{fine, nan},
                               Lower{fine, 1e300}, Flatten{fine, 2, {}}, Flatten{fine, 1, nan}, Smooth{fine, -1},
                               Noise{fine, 1, 0, 1, 1}, Noise{fine, 1, 1, 99, 1}, Restore{fine, 1, {}}, Pour{fine, -1},
                               Scoop{fine, -1}, Rake{0, 5, 1, 1, {}}, Rake{1, 0, 1, 1, {}}, Ramp{noRadius, {}, {}},
                               Ramp{fine, nan, {}}, Breakline{-1, {}}, Breakline{0, nan}}) {
            const auto done = draw(tin, at({0.5, 0.5}, tool));
            QVERIFY2(!done, nameOf(tool));
            QCOMPARE(done.error().code, ErrorCode::BadSetting);
        }
        QCOMPARE(tin.fingerprint(), before);
    }
};

SANDREEL_TEST(TestSculpt)
#include "tst_sculpt.moc"
