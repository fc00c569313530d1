// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/predicates.h"
#include "tests/support/testmain.h"

#include <array>
#include <cmath>
#include <random>

using namespace model::terrain;

namespace {

__extension__ typedef __int128 Wide;

/// Signs by integers that cannot overflow: coordinates up to 2^20.
Wide determinant(const std::array<std::array<Wide, 3>, 3> &m)
{
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}
int signOf(Wide value)
{
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}
int integerOrientation(Point2 a, Point2 b, Point2 c)
{
    return signOf((Wide(b.x) - Wide(a.x)) * (Wide(c.y) - Wide(a.y)) -
                  (Wide(b.y) - Wide(a.y)) * (Wide(c.x) - Wide(a.x)));
}
int integerInCircle(Point2 a, Point2 b, Point2 c, Point2 d)
{
    const auto row = [&](Point2 p) -> std::array<Wide, 3> {
        const Wide x = Wide(p.x) - Wide(d.x), y = Wide(p.y) - Wide(d.y);
        return {x, y, x * x + y * y};
    };
    return signOf(determinant({row(a), row(b), row(c)}));
}

} // namespace

class TestPredicates final : public QObject
{
    Q_OBJECT

private slots:
    void signsAreThoseOfIntegers_data()
    {
        QTest::addColumn<int>("range");
        QTest::newRow("many ties") << 6;
        QTest::newRow("some ties") << 100;
        QTest::newRow("few ties") << (1 << 20);
    }
    void signsAreThoseOfIntegers()
    {
        QFETCH(int, range);
        std::mt19937 random(1);
        const auto point = [&] { return Point2{double(int(random() % range)), double(int(random() % range))}; };
        for (int i = 0; i < 20000; ++i) {
            const Point2 a = point(), b = point(), c = point(), d = point();
            QCOMPARE(orientation(a, b, c), integerOrientation(a, b, c));
            QCOMPARE(inCircle(a, b, c, d), integerInCircle(a, b, c, d));
        }
    }

    /// Points nearly on a line or circle, moved by single last bits: the filters cannot tell, and must say so.
    void lastBitsCount()
    {
        const Point2 a{0.1, 0.1}, b{0.9, 0.9};
        for (int i = 1; i < 1000; ++i) {
            const double x = i / 1000.0, up = std::nextafter(x, 2), down = std::nextafter(x, -2);
            QCOMPARE(orientation(a, b, {x, x}), 0);
            QCOMPARE(orientation(a, b, {x, up}), 1);
            QCOMPARE(orientation(a, b, {x, down}), -1);
        }
        const Point2 south{0, -5}, east{5, 0}, north{0, 5};
        QCOMPARE(inCircle(south, east, north, {-5, 0}), 0);
        QCOMPARE(inCircle(south, east, north, {std::nextafter(-5, 0), 0}), 1);
        QCOMPARE(inCircle(south, east, north, {std::nextafter(-5, -6), 0}), -1);
        QCOMPARE(inCircle(south, east, north, {-3, 4}), 0);
        QCOMPARE(inCircle(south, east, north, {-3, std::nextafter(4, 0)}), 1);
    }

    void tinyAndHugeNumbersHaveSigns()
    {
        const double small = 1e-200;
        QCOMPARE(orientation({0, 0}, {small, 0}, {small, small}), 1);
        QCOMPARE(orientation({0, 0}, {small, small}, {2 * small, 2 * small}), 0);
        QCOMPARE(inCircle({0, 0}, {small, 0}, {0, small}, {small, small}), 0);
        QCOMPARE(inCircle({0, 0}, {small, 0}, {0, small}, {small * 0.5, small * 0.5}), 1);
        const double big = LargestCoordinate;
        QCOMPARE(orientation({-big, -big}, {big, big}, {std::nextafter(big, 0), big}), 1);
    }

    /// The tie rule is a perturbation: it names one of the two diagonals of four points on a circle, whichever triangle
    /// asks.
    void everyTieHasOneAnswer()
    {
        const Point2 circle[] = {{0, 25}, {-7, 24}, {-24, -7}, {15, -20}, {20, -15}, {25, 0}, {24, 7}, {7, 24}};
        for (int i = 0; i < 8; ++i)
            for (int j = i + 1; j < 8; ++j)
                for (int k = j + 1; k < 8; ++k)
                    for (int l = k + 1; l < 8; ++l) {
                        const Point2 a = circle[i], b = circle[j], c = circle[k], d = circle[l];
                        const bool diagonalAc = !isInsideCircle(a, b, c, d);
                        QCOMPARE(!isInsideCircle(b, c, a, d), diagonalAc);
                        QCOMPARE(!isInsideCircle(c, d, a, b), diagonalAc);
                        QCOMPARE(isInsideCircle(a, b, d, c), diagonalAc);
                        QCOMPARE(isInsideCircle(b, c, d, a), diagonalAc);
                    }
    }
};

SANDREEL_TEST(TestPredicates)
#include "tst_predicates.moc"
