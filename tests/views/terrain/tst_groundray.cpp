// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"
#include "tests/views/terrain/groundshapes.h"
#include "views/terrain/groundray.h"

using namespace model::terrain;
using namespace views;

namespace {

/// The first hit from above, by asking every triangle. Source: T. Moeller, B. Trumbore, Fast, Minimum Storage
/// Ray/Triangle Intersection, 1997.
std::optional<double> firstHit(const TinArrays &tin, const GroundRay &ray)
{
    std::optional<double> first;
    const Point3 o = ray.origin, d = ray.direction;
    for (TriangleId t = 0; t < tin.triangleSlots(); ++t) {
        if (!tin.isTriangle(t) || tin.isVoid(t))
            continue;
        Point3 p[3];
        for (std::uint32_t i = 0; i < 3; ++i) {
            const VertexId v = tin.vertex(cornerOf(t, i));
            p[i] = {tin.points[v].x, tin.points[v].y, tin.heights[v]};
        }
        const auto minus = [](Point3 a, Point3 b) { return Point3{a.x - b.x, a.y - b.y, a.z - b.z}; };
        const auto cross = [](Point3 a, Point3 b) {
            return Point3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
        };
        const auto dot = [](Point3 a, Point3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
        const Point3 e1 = minus(p[1], p[0]), e2 = minus(p[2], p[0]), h = cross(d, e2);
        const double determinant = dot(e1, h);
        if (determinant <= 0) // seen from below, or along it
            continue;
        const Point3 s = minus(o, p[0]), q = cross(s, e1);
        const double u = dot(s, h) / determinant, v = dot(d, q) / determinant, along = dot(e2, q) / determinant;
        if (u >= 0 && v >= 0 && u + v <= 1 && along >= 0 && (!first || along < *first))
            first = along;
    }
    return first;
}

} // namespace

class TestGroundRay final : public QObject
{
    Q_OBJECT

private slots:
    void walkFindsWhatAskingEveryTriangleFinds()
    {
        const auto document = tests::groundDocument(tests::UnitSquare, 24, tests::dunes);
        const Tin &tin = document->tin();
        std::mt19937 random(3);
        std::uniform_real_distribution<double> place(-0.6, 1.6), target(-0.1, 1.1), up(0.12, 0.7);
        int hits = 0, misses = 0;
        for (int i = 0; i < 3000; ++i) {
            GroundRay ray{{place(random), place(random), up(random)}, {}};
            ray.direction = {target(random) - ray.origin.x, target(random) - ray.origin.y, -ray.origin.z};
            const std::optional<double> expected = firstHit(tin.arrays(), ray);
            const std::optional<Point3> found = hitOf(tin, ray);
            QCOMPARE(found.has_value(), expected.has_value());
            if (!expected) {
                ++misses;
                continue;
            }
            ++hits;
            QVERIFY(std::abs(found->x - (ray.origin.x + *expected * ray.direction.x)) < 1e-9);
            QVERIFY(std::abs(found->y - (ray.origin.y + *expected * ray.direction.y)) < 1e-9);
            QVERIFY(std::abs(found->z - (ray.origin.z + *expected * ray.direction.z)) < 1e-9);
        }
        QVERIFY(hits > 500 && misses > 300);
    }

    void raysAlongEdgesAndThroughVerticesEnd()
    {
        // A grid that is not shaken: the rays run along its lines.
        std::vector<Point3> points;
        for (int j = 0; j <= 8; ++j)
            for (int i = 0; i <= 8; ++i)
                points.push_back({i / 8.0, j / 8.0, 0.1});
        const Tin tin = buildTin(points, tests::UnitSquare).value().tin;
        for (int i = 0; i <= 8; ++i) {
            const auto hit = hitOf(tin, {{-1, i / 8.0, 1.1}, {1.5, 0, -1}});
            QVERIFY(hit && std::abs(hit->x - 0.5) < 1e-12);
            const auto diagonal = hitOf(tin, {{-1, -1, 1.1}, {1.25, 1.25, -1}});
            QVERIFY(diagonal && std::abs(diagonal->x - 0.25) < 1e-12 && std::abs(diagonal->y - 0.25) < 1e-12);
        }
        const auto down = hitOf(tin, {{0.5, 0.5, 3}, {0, 0, -1}});
        QVERIFY(down && std::abs(down->z - 0.1) < 1e-12);
        QVERIFY(!hitOf(tin, {{0.5, 0.5, 3}, {0, 0, 1}}));
        QVERIFY(!hitOf(tin, {{2, 0.5, 3}, {0, 0, -1}}));
        QVERIFY2(!hitOf(tin, {{0.5, 0.5, -1}, {0.01, 0, 1}}), "the ground has no underside");
    }

    void voidsAreHoles()
    {
        const auto document = tests::groundDocument(tests::UnitSquare, 12, [](double, double) { return 0.0; });
        const GroundRay ray{{0.5, 0.5, 1}, {0.001, 0, -1}};
        QVERIFY(hitOf(document->tin(), ray));
        document->edit([](TinEdit &edit) {
            const TriangleId t = edit.tin().triangleAt({0.501, 0.5});
            edit.setVoid({&t, 1}, true);
        });
        QVERIFY(!hitOf(document->tin(), ray));
    }

    void groundGoesOnBeyondTheBorder()
    {
        const auto document =
            tests::groundDocument(tests::UnitSquare, 12, [](double x, double) { return 0.1 + 0.2 * x; });
        // East of the square the border is at 0.3, south of x = 0.25 at 0.15.
        const auto east = hitBeyond(document->tin(), {{1.5, 0.5, 1.3}, {0.25, 0, -1}});
        QVERIFY(east && std::abs(east->x - 1.75) < 1e-9 && std::abs(east->z - 0.3) < 1e-9);
        const auto south = hitBeyond(document->tin(), {{0.25, -1, 1.15}, {0, 0.5, -1}});
        QVERIFY(south && std::abs(south->y + 0.5) < 1e-9 && std::abs(south->z - 0.15) < 1e-9);
        QVERIFY(!hitBeyond(document->tin(), {{1.5, 0.5, 1}, {1, 0, 0}}));
        QVERIFY(!hitBeyond(document->tin(), {{1.5, 0.5, 1}, {1, 0, 1}}));
    }
};

SANDREEL_TEST(TestGroundRay)
#include "tst_groundray.moc"
