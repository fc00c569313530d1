// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/predicates.h"
#include "model/terrain/tin/tinedit.h"
#include "tests/model/terrain/tin/randomedits.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <cmath>

using namespace model::terrain;

namespace {

/// By looking at every triangle.
Location bruteForce(const TinArrays &tin, Point2 p)
{
    for (VertexId v = 0; v < tin.vertexSlots(); ++v)
        if (tin.isVertex(v) && tin.points[v] == p)
            return {Location::Kind::Vertex, tin.corners[v]};
    for (TriangleId t = 0; t < tin.triangleSlots(); ++t) {
        if (!tin.isTriangle(t))
            continue;
        int sides[3];
        for (std::uint32_t i = 0; i < 3; ++i)
            sides[i] = orientation(tin.pointAt(next(cornerOf(t, i))), tin.pointAt(previous(cornerOf(t, i))), p);
        if (sides[0] < 0 || sides[1] < 0 || sides[2] < 0)
            continue;
        for (std::uint32_t i = 0; i < 3; ++i)
            if (sides[i] == 0)
                return {Location::Kind::Edge, cornerOf(t, i)};
        return {Location::Kind::Triangle, cornerOf(t, 0)};
    }
    return {};
}

} // namespace

class TestLocate final : public QObject
{
    Q_OBJECT

private slots:
    void everyPointIsFoundFromEverywhere_data()
    {
        QTest::addColumn<int>("ground");
        for (const tests::Ground ground : tests::EveryGround)
            QTest::newRow(tests::nameOf(ground)) << int(ground);
    }
    void everyPointIsFoundFromEverywhere()
    {
        QFETCH(int, ground);
        tests::PointSource source(tests::Ground(ground), 31);
        auto built = buildTin(source.points(80), source.domain());
        QVERIFY(built);
        {
            TinEdit edit(built->tin);
            for (int i = 0; i < 60; ++i)
                tests::randomStep(edit, source);
            edit.commit();
        }
        const TinArrays &tin = built->tin.arrays();
        const Rectangle domain = source.domain();
        for (int i = 0; i < 150; ++i) {
            Point2 p = source.point();
            if (i % 4 == 0) // the domain's own border
                p.x = i % 8 ? domain.low.x : domain.high.x;
            const Location expected = bruteForce(tin, p);
            QCOMPARE(built->tin.locate(p), expected);
            for (VertexId v = 0; v < tin.vertexSlots(); ++v)
                if (tin.isVertex(v))
                    QCOMPARE(built->tin.locate(p, v), expected);
        }
    }

    void thinDomainsAreSearchedToo()
    {
        const Rectangle strip{{0, 0}, {10000, 0.001}};
        std::vector<Point3> points;
        for (int i = 0; i < 2000; ++i)
            points.push_back({i * 5.0 + 1, (i % 7) * 0.0001, double(i)});
        const auto built = buildTin(points, strip);
        QVERIFY(built);
        for (std::size_t i = 0; i < points.size(); ++i)
            QCOMPARE(built->tin.heightAt({points[i].x, points[i].y}), double(i));
        QVERIFY(built->tin.byteSize() < 2000 * 200);
    }

    void heightAndSlopeAreThoseOfAPlane()
    {
        tests::PointSource source(tests::Ground::Random, 5);
        std::vector<Point3> points = source.points(300);
        for (const Point2 corner : {Point2{0, 0}, Point2{1, 0}, Point2{1, 1}, Point2{0, 1}})
            points.push_back({corner.x, corner.y, 0});
        for (Point3 &p : points)
            p.z = 3 + 0.5 * p.x - 0.25 * p.y;
        const auto built = buildTin(points, {{0, 0}, {1, 1}});
        QVERIFY(built);
        for (int i = 0; i < 1000; ++i) {
            const Point2 p = source.point();
            QVERIFY(std::abs(built->tin.heightAt(p) - (3 + 0.5 * p.x - 0.25 * p.y)) < 1e-14 * 10);
            const Gradient gradient = built->tin.gradientAt(p);
            QVERIFY(std::abs(gradient.x - 0.5) < 1e-9 && std::abs(gradient.y + 0.25) < 1e-9);
            QVERIFY(std::abs(slopeOf(built->tin.arrays(), built->tin.triangleAt(p)) - std::atan(std::sqrt(0.3125))) <
                    1e-9);
        }
    }

    /// A pyramid: height is the distance to the nearest side of the square.
    void heightAndSlopeAreThoseOfAPyramid()
    {
        const std::vector<Point3> points{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 1}};
        const auto built = buildTin(points, {{0, 0}, {2, 2}});
        QVERIFY(built);
        tests::PointSource source(tests::Ground::Random, 6);
        for (int i = 0; i < 1000; ++i) {
            const Point2 p{source.uniform(0, 2), source.uniform(0, 2)};
            const double expected = std::min(std::min(p.x, 2 - p.x), std::min(p.y, 2 - p.y));
            QVERIFY(std::abs(built->tin.heightAt(p) - expected) < 1e-15);
            QVERIFY(std::abs(slopeOf(built->tin.arrays(), built->tin.triangleAt(p)) - M_PI / 4) < 1e-15);
        }
        QCOMPARE(built->tin.heightAt({1, 1}), 1.0);
        QVERIFY(std::abs(built->tin.volume() - 4.0 / 3) < 1e-15);
    }

    /// In a needle, too, no height is above or below those of its vertices.
    void heightsStayBetweenTheVertices()
    {
        const std::vector<Point3> points{{0.2, 0.5, 1}, {0.8, std::nextafter(0.5, 1), 2}, {0.5, 0.5, 1.5}};
        const auto built = buildTin(points, {{0, 0}, {1, 1}});
        QVERIFY(built);
        for (int i = 0; i <= 1000; ++i)
            for (const double y : {0.5, std::nextafter(0.5, 0), std::nextafter(0.5, 1)}) {
                const double height = built->tin.heightAt({0.2 + 0.6 * i / 1000, y});
                QVERIFY(height >= 1 && height <= 2);
            }
    }
};

SANDREEL_TEST(TestLocate)
#include "tst_locate.moc"
