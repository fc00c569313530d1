// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/svgpath.h"
#include "tests/support/testmain.h"

#include <QTest>

#include <cmath>

using namespace model;
using namespace model::terrain;

class TestOutline final : public QObject
{
    Q_OBJECT

private slots:
    void presetsAreSimpleAndCounterClockwise()
    {
        for (const Outline &outline : {Outline::disc(), Outline::disc(3), Outline::square(), Outline::wedge()}) {
            QVERIFY(isSimple(outline.points()));
            QVERIFY(doubleAreaOf(outline.points()) > 0);
            QVERIFY(std::abs(outline.reach() - 1) < 1e-12);
        }
        // A regular 12-gon in the unit circle has area 3.
        QVERIFY(std::abs(doubleAreaOf(Outline::disc(12).points()) / 2 - 3) < 1e-14);
    }
    void clockwisePolygonsAreTurned()
    {
        const auto outline = Outline::polygon({{0, 0}, {0, 1}, {1, 1}, {1, 0}, {0, 0}});
        QVERIFY(outline);
        QCOMPARE(outline->points().size(), std::size_t(4));
        QCOMPARE(doubleAreaOf(outline->points()), 2.0);
    }
    void badPolygonsAreRefused()
    {
        const std::vector<std::vector<Point2>> bad{
            {},
            {{0, 0}, {1, 0}},
            {{0, 0}, {1, 1}, {1, 0}, {0, 1}},                         // crosses itself
            {{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}},                 // a corner on another edge
            {{0, 0}, {1, 0}, {2, 0}},                                 // no area
            {{0, 0}, {1, 0}, {1, 1}, {1, 0}, {0, 1}},                 // a spike
            {{0, 0}, {1, 0}, {std::nan(""), 1}},                      //
            {{0, 0}, {1e300, 0}, {0, 1}},                             //
            std::vector<Point2>(LargestOutline + 2, Point2{0.5, 0.5}) // one point
        };
        for (const auto &points : bad) {
            const auto outline = Outline::polygon(points);
            QVERIFY(!outline);
            QCOMPARE(outline.error().code, ErrorCode::BadSetting);
        }
        std::vector<Point2> many;
        for (std::size_t i = 0; i <= LargestOutline; ++i)
            many.push_back({std::cos(double(i) / 100), std::sin(double(i) / 100)});
        QCOMPARE(Outline::polygon(many).error().code, ErrorCode::BadSetting);
    }
    void insetMovesEveryEdgeInwards()
    {
        const auto inset = insetOf(Outline::square().points(), 0.1);
        const double side = M_SQRT2 - 0.2;
        QVERIFY(std::abs(doubleAreaOf(inset) / 2 - side * side) < 1e-12);
        // An L keeps its shape: from 3 squares, arms of width 1, to arms of width 0.8.
        const std::vector<Point2> ell{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
        QVERIFY(std::abs(doubleAreaOf(insetOf(ell, 0.1)) / 2 - (1.8 * 0.8 + 1.0 * 0.8)) < 1e-12);
    }
    void insideAndNearest()
    {
        const std::vector<Point2> ell{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
        QVERIFY(isInside(ell, {0.5, 1.5}));
        QVERIFY(!isInside(ell, {1.5, 1.5}));
        QVERIFY((nearestOnBorder(ell, {1.25, 1.75}) == Point2{1, 1.75}));
        QVERIFY((nearestOnBorder(ell, {3, -1}) == Point2{2, 0}));
    }
    void clippingKeepsTheAreaInside()
    {
        const std::vector<Point2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        QCOMPARE(doubleAreaOf(clippedTo({{0, 0}, {5, 5}}, square)), 2.0);
        QCOMPARE(doubleAreaOf(clippedTo({{-5, -5}, {5, 5}}, square)), 8.0);
        QCOMPARE(doubleAreaOf(clippedTo({{-0.5, -0.5}, {0.5, 0.5}}, square)), 2.0);
        QVERIFY(clippedTo({{2, 2}, {5, 5}}, square).size() < 3);
    }
    void svgLinesAreTheOutline()
    {
        // The same square three ways; y points down in SVG.
        for (const char *data :
             {"M0 0 L10 0 L10,10 L0 10 Z", "m 0,0 10,0 0,10 -10,0 z", "M 0 0 H 10 V 10 h -1e1 V 0 Z"}) {
            const auto outline = outlineFromSvgPath(data);
            QVERIFY(outline);
            QCOMPARE(outline->points().size(), std::size_t(4));
            QVERIFY(std::abs(doubleAreaOf(outline->points()) / 2 - 2) < 1e-12); // half a diagonal is 1
        }
        // An arrow head to the right and down: north is up.
        const auto head = outlineFromSvgPath("M 0 0 L 4 0 L 0 2 Z");
        QVERIFY(head);
        const double reach = std::hypot(2, 1);
        bool isThere = false;
        for (const Point2 p : head->points())
            isThere = isThere || std::hypot(p.x + 2 / reach, p.y + 1 / reach) < 1e-12;
        QVERIFY(isThere);
    }
    void svgCurvesStayWithinTheirTolerance()
    {
        // Four cubics that make a circle to 2.7e-4.
        const auto circle = outlineFromSvgPath("M 1 0 C 1 0.5523 0.5523 1 0 1 C -0.5523 1 -1 0.5523 -1 0"
                                               "C -1 -0.5523 -0.5523 -1 0 -1 C 0.5523 -1 1 -0.5523 1 0 Z",
                                               0.002);
        QVERIFY(circle);
        for (std::size_t i = 0; i < circle->points().size(); ++i) {
            const Point2 a = circle->points()[i], b = circle->points()[(i + 1) % circle->points().size()];
            QVERIFY(std::hypot((a.x + b.x) / 2, (a.y + b.y) / 2) > 1 - 0.005);
            QVERIFY(std::hypot(a.x, a.y) > 1 - 0.001);
        }
        // A parabola under its control point: area 2/3 of the triangle's.
        const auto arch = outlineFromSvgPath("M -1 0 Q 0 -2 1 0 Z", 0.0005);
        QVERIFY(arch);
        const double scale = std::hypot(1, 0.5);
        QVERIFY(std::abs(doubleAreaOf(arch->points()) / 2 * scale * scale - 4.0 / 3) < 2e-3);
    }
    void badSvgPathsAreNamed()
    {
        for (const char *data : {"", "L 0 0", "M 0", "M 0 0 A 1 1 0 0 0 2 2", "M 0 0 L 1 x", "M 0 0 L 1 0 1 1 Z 5",
                                 "M 0 0 L 1 0 L 1 1 Z M 3 3 L 4 4 L 3 4 Z", "M 0 0 L 1e999 0 1 1"})
            QCOMPARE(outlineFromSvgPath(data).error().code, ErrorCode::SyntaxError);
        QCOMPARE(outlineFromSvgPath("M 0 0 L 1 1 L 1 0 L 0 1 Z").error().code, ErrorCode::BadSetting);
    }
};

SANDREEL_TEST(TestOutline)
#include "tst_outline.moc"
