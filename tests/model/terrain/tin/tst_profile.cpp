// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/predicates.h"
#include "model/terrain/tin/query/profile.h"
#include "tests/model/terrain/tin/randomedits.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <cmath>

using namespace model::terrain;

namespace {

struct Met
{
    double distance, height;
    double tolerance; ///< of the distance: where a line meets an edge that it almost follows depends on the last digit
};

/// Where the line meets edges, by looking at all of them; of those that lie along it, their ends.
std::vector<Met> bruteForce(const Tin &surface, Point2 a, Point2 b)
{
    const TinArrays &tin = surface.arrays();
    const long double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    const auto side = [&](Point2 p) {
        return orientation(a, b, p) == 0 ? 0 : (dx * (p.y - a.y) - dy * (p.x - a.x)) / length;
    };
    const auto along = [&](Point2 p) { return (dx * (p.x - a.x) + dy * (p.y - a.y)) / length; };
    const Rectangle domain = surface.domain();
    // Coordinates far from the origin have few digits left for what is small.
    const long double grain = 1e-14L * (length + std::abs(domain.high.x) + std::abs(domain.high.y));
    std::vector<Met> found;
    const auto add = [&](long double distance, long double height, long double tolerance) {
        if (distance > 0 && distance < length)
            found.push_back({double(distance), double(height), double(tolerance)});
    };
    for (TriangleId t = 0; t < tin.triangleSlots(); ++t) {
        if (!tin.isTriangle(t))
            continue;
        for (std::uint32_t i = 0; i < 3; ++i) {
            const VertexId u = tin.vertex(next(cornerOf(t, i))), v = tin.vertex(previous(cornerOf(t, i)));
            const Point2 p = tin.points[u], q = tin.points[v];
            const long double su = side(p), sv = side(q);
            if (su == 0)
                add(along(p), tin.heights[u], grain);
            if (sv == 0)
                add(along(q), tin.heights[v], grain);
            if (su == 0 || sv == 0 || (su > 0) == (sv > 0))
                continue;
            const long double share = su / (su - sv);
            add(along(p) + share * (along(q) - along(p)), tin.heights[u] + share * (tin.heights[v] - tin.heights[u]),
                grain + grain * std::abs((along(q) - along(p)) / (su - sv)));
        }
    }
    return found;
}

} // namespace

class TestProfile final : public QObject
{
    Q_OBJECT

private slots:
    void everyCrossedEdgeIsAPoint_data()
    {
        QTest::addColumn<int>("ground");
        for (const tests::Ground ground : tests::EveryGround)
            QTest::newRow(tests::nameOf(ground)) << int(ground);
    }
    void everyCrossedEdgeIsAPoint()
    {
        QFETCH(int, ground);
        tests::PointSource source(tests::Ground(ground), 17);
        auto points = source.points(150);
        for (Point3 &p : points)
            p.z = source.uniform(-1, 1);
        auto built = buildTin(points, source.domain());
        QVERIFY(built);
        const TinArrays &tin = built->tin.arrays();
        const Rectangle domain = built->tin.domain();
        const auto anyVertex = [&] { return tin.points[source.below(tin.vertexSlots())]; };
        std::size_t crossings = 0;
        for (int round = 0; round < 300; ++round) {
            // From anywhere, from vertex to vertex, and along lines that many points of grids lie on.
            Point2 a = round % 3 == 0 ? source.point() : anyVertex();
            Point2 b = round % 3 == 1 ? source.point() : anyVertex();
            if (round % 5 == 0)
                b = {b.x, a.y};
            if (round % 50 == 0)
                a = domain.low, b = {domain.high.x, domain.low.y}; // the border, with the terrain on its left
            if (round % 50 == 1)
                a = {domain.high.x, domain.low.y}, b = domain.low; // and on its right
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            const std::vector<ProfilePoint> section = profile(built->tin, a, b);
            if (a == b) {
                QVERIFY(section.empty());
                continue;
            }
            QVERIFY(section.size() >= 2);
            QCOMPARE(section.front().distance, 0.0);
            QVERIFY(std::abs(section.back().distance - length) <= 1e-12 * length);
            QCOMPARE(section.front().height, built->tin.heightAt(a));
            QCOMPARE(section.back().height, built->tin.heightAt(b));
            const std::vector<Met> expected = bruteForce(built->tin, a, b);
            crossings += expected.size();
            for (std::size_t i = 1; i < section.size(); ++i)
                QVERIFY(section[i].distance > section[i - 1].distance);
            for (std::size_t i = 1; i + 1 < section.size(); ++i) {
                const ProfilePoint &point = section[i];
                QVERIFY(std::any_of(expected.begin(), expected.end(), [&](const Met &met) {
                    return std::abs(met.distance - point.distance) <= met.tolerance &&
                           std::abs(met.height - point.height) <= 1e-9 + met.tolerance / length * 1e3;
                }));
            }
            for (const Met &met : expected)
                QVERIFY2(std::any_of(section.begin(), section.end(),
                                     [&](const ProfilePoint &point) {
                                         return std::abs(met.distance - point.distance) <= met.tolerance;
                                     }),
                         qPrintable(QString::number(met.distance)));
        }
        QVERIFY(crossings > 1000);
    }
    void betweenItsPointsItIsTheSurface()
    {
        tests::PointSource source(tests::Ground::Random, 5);
        auto points = source.points(400);
        for (Point3 &p : points)
            p.z = source.uniform(-1, 1);
        auto built = buildTin(points, source.domain());
        for (int round = 0; round < 100; ++round) {
            const Point2 a = source.point(), b = source.point();
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            const auto section = profile(built->tin, a, b);
            for (int i = 1; i < 50; ++i) {
                const double share = i / 50.0;
                const double expected = built->tin.heightAt({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
                const auto height = heightAt(section, share * length);
                QVERIFY(height);
                QVERIFY2(std::abs(*height - expected) < 1e-8, qPrintable(QString::number(*height - expected)));
            }
            QVERIFY(!heightAt(section, -1e-9));
            QVERIFY(!heightAt(section, length * 1.001));
        }
    }
    void itEndsWhereTheTerrainDoes()
    {
        Tin tin(Rectangle{{0, 0}, {4, 2}});
        {
            TinEdit edit(tin);
            edit.setHeight(1, 8); // at (4, 0)
            edit.commit();
        }
        const auto section = profile(tin, {-1, 0}, {6, 0});
        QCOMPARE(section.size(), std::size_t(2));
        QCOMPARE(section[0].distance, 1.0);
        QCOMPARE(section[0].height, 0.0);
        QCOMPARE(section[1].distance, 5.0);
        QCOMPARE(section[1].height, 8.0);
        QCOMPARE(heightAt(section, 2), std::optional(2.0));
        QVERIFY(profile(tin, {-1, -1}, {6, -1}).empty());
        QVERIFY(profile(tin, {5, 0}, {6, 1}).empty());
        QVERIFY(profile(tin, {1, 1}, {1, 1}).empty());
        QVERIFY(profile(tin, {-1, 1}, {1, -1}).empty()); // it only touches a corner
    }
    void voidsAreGaps()
    {
        std::vector<Point3> points;
        for (int x = 0; x <= 4; ++x)
            for (int y = 0; y <= 4; ++y)
                points.push_back({double(x), double(y), 1});
        auto built = buildTin(points, {{0, 0}, {4, 4}});
        std::vector<TriangleId> inside;
        for (TriangleId t = 0; t < built->tin.arrays().triangleSlots(); ++t) {
            double x = 0;
            for (std::uint32_t i = 0; i < 3; ++i)
                x += built->tin.arrays().pointAt(cornerOf(t, i)).x / 3;
            if (x > 1 && x < 3)
                inside.push_back(t);
        }
        TinEdit edit(built->tin);
        edit.setVoid(inside, true);
        edit.commit();
        const auto section = profile(built->tin, {0.5, 1.25}, {3.5, 1.75});
        const double length = std::hypot(3, 0.5);
        QVERIFY(heightAt(section, 0.1));
        QVERIFY(heightAt(section, length / 6 - 0.01) && !heightAt(section, length / 6 + 0.01));
        QVERIFY(!heightAt(section, length / 2));
        QVERIFY(!heightAt(section, 5 * length / 6 - 0.01) && heightAt(section, 5 * length / 6 + 0.01));
    }
};

SANDREEL_TEST(TestProfile)
#include "tst_profile.moc"
