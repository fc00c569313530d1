// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/terrain/tools/strokes.h"
#include "tests/support/testmain.h"

using namespace model;
using namespace model::terrain;
using namespace tests;

class TestLines final : public QObject
{
    Q_OBJECT

private slots:
    void rakeLeavesGroovesAndRidges()
    {
        Tin tin = ground(3000, 0);
        const double volume = tin.volume();
        const Stroke stroke{Rake{0.2, 4, 0.02, 0.25, {}}, line({0.2, 0.5}, {0.8, 0.5}), {}};
        const auto report = drawAndCheck(tin, stroke);
        QVERIFY(report.moved > 0);
        QVERIFY(std::abs(tin.volume() - volume) < 1e-13);
        double grooves = 0, ridges = 0;
        for (double x = 0.3; x < 0.7; x += 0.01) {
            for (const double y : {0.425, 0.475, 0.525, 0.575})
                grooves += tin.heightAt({x, y}) - 1;
            for (const double y : {0.45, 0.5, 0.55})
                ridges += tin.heightAt({x, y}) - 1;
        }
        QVERIFY2(grooves / 160 < -0.008, qPrintable(QString::number(grooves / 160)));
        QVERIFY2(ridges / 120 > 0.005, qPrintable(QString::number(ridges / 120)));
        // Once more through the same grooves moves little.
        QVERIFY(drawAndCheck(tin, stroke).moved < 0.5 * report.moved);
    }
    void aRakeThatStandsStillLeavesNothing()
    {
        Tin tin = ground(300, 0);
        const auto done = draw(tin, {Rake{}, {{{0.5, 0.5}, 1, 0}}, {}});
        QVERIFY(done && done->edit.isEmpty());
    }
    /// Closed form: on the ramp's middle the height is linear between its ends.
    void rampIsEvenBetweenItsEnds()
    {
        Tin tin = ground(4000);
        const double from = tin.heightAt({0.2, 0.2}), to = tin.heightAt({0.8, 0.6});
        Ramp ramp;
        ramp.brush.radius = 0.1;
        ramp.brush.falloff = Falloff::Constant;
        drawAndCheck(tin, {ramp, line({0.2, 0.2}, {0.8, 0.6}), {}});
        for (double t = 0.05; t < 1; t += 0.05)
            QVERIFY(std::abs(tin.heightAt({0.2 + 0.6 * t, 0.2 + 0.4 * t}) - (from + t * (to - from))) < 1e-9);
        ramp.from = 5;
        ramp.to = 6;
        drawAndCheck(tin, {ramp, {{{0.2, 0.8}, 1, 0}, {{0.9, 0.1}, 1, 0}, {{0.4, 0.8}, 1, 0}}, {}});
        QVERIFY(std::abs(tin.heightAt({0.3, 0.8}) - 5.5) < 1e-9); // first to last, not through the middle
    }
    void breaklinesAreEdgesOnTheGround()
    {
        Tin tin = ground(2000);
        const Tin before = tin;
        const std::vector<PathPoint> path{{{0.2, 0.2}, 1, 0}, {{0.5, 0.4}, 1, 0}, {{0.8, 0.2}, 1, 0}};
        drawAndCheck(tin, {Breakline{0.02, {}}, path, {}}, 9);
        // Every piece of it is a constrained edge of that owner.
        const TinArrays &arrays = tin.arrays();
        double length = 0;
        for (std::size_t r = 0; r < arrays.records.size(); ++r)
            if (arrays.records[r].a != None) {
                QCOMPARE(arrays.records[r].owner, 9u);
                const Point2 a = arrays.points[arrays.records[r].a], b = arrays.points[arrays.records[r].b];
                length += std::hypot(b.x - a.x, b.y - a.y);
            }
        QVERIFY(std::abs(length - 2 * std::hypot(0.3, 0.2)) < 1e-12);
        QVERIFY(std::abs(tin.heightAt({0.5, 0.4}) - before.heightAt({0.5, 0.4})) < 0.01);
    }
    void breaklinesCrossAndAreClipped()
    {
        Tin tin = ground(500);
        drawAndCheck(tin, {Breakline{0.1, 2}, line({-0.5, 0.5}, {1.5, 0.5}), {}}, 1);
        drawAndCheck(tin, {Breakline{0.1, 3}, line({0.5, -7}, {0.5, 0.9}), {}}, 2);
        QVERIFY(std::abs(tin.heightAt({0.77, 0.5}) - 2) < 1e-12);
        QVERIFY(std::abs(tin.heightAt({0.5, 0.33}) - 3) < 1e-12);
        const auto far = draw(tin, {Breakline{}, line({2, 2}, {3, 3}), {}});
        QVERIFY(far && far->edit.isEmpty());
        Breakline careful;
        careful.crossing = Crossing::Refuse;
        const std::uint64_t before = tin.fingerprint();
        QCOMPARE(draw(tin, {careful, line({0.34, 0.1}, {0.34, 0.9}), {}}).error().code, ErrorCode::CrossingConstraints);
        QCOMPARE(tin.fingerprint(), before);
    }
    void cornersAreWhereThePathBends()
    {
        std::vector<PathPoint> path;
        for (int i = 0; i <= 10; ++i)
            path.push_back({{0.1 * i, 0.03 * i}, 1, 0});
        path.push_back({{1, 1}, 1, 0});
        QVERIFY((cornersOf(path) == std::vector<Point2>{{0, 0}, {1, 0.3}, {1, 1}}));
    }
};

SANDREEL_TEST(TestLines)
#include "tst_lines.moc"
