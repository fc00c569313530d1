// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/surfacedistance.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace model;

namespace {

using Corners = std::array<Vec3d, 3>;

/// The nearest of a fine grid of points on the triangle.
double nearestOfGrid(Vec3d p, const Corners &t)
{
    constexpr int Steps = 200;
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= Steps; ++i)
        for (int j = 0; j <= Steps - i; ++j) {
            const double u = double(i) / Steps, v = double(j) / Steps;
            best = std::min(best, squaredDistance(p, t[0] * (1 - u - v) + t[1] * u + t[2] * v));
        }
    return std::sqrt(best);
}

double distanceTo(Vec3d p, const Corners &t)
{
    return std::sqrt(squaredDistanceToTriangle(p, t));
}

} // namespace

class TestSurfaceDistance final : public QObject
{
    Q_OBJECT

    std::mt19937 mRandom{5};
    double number() { return double(mRandom() % 2001) / 1000 - 1; }
    Vec3d point() { return {number(), number(), number()}; }

private slots:
    /// Each region around a triangle of legs 4 and 3: face, edges, corners; from both sides.
    void byHand()
    {
        const Corners t{Vec3d(0, 0, 0), Vec3d(4, 0, 0), Vec3d(0, 3, 0)};
        for (const double z : {-12.0, 0.0, 12.0}) {
            QCOMPARE(distanceTo({1, 1, z}, t), std::abs(z));
            QCOMPARE(distanceTo({2, -5, z}, t), std::hypot(5, z));
            QCOMPARE(distanceTo({-5, 2, z}, t), std::hypot(5, z));
            // On the normal of the long edge, (3, 4) / 5, 5 away from its middle.
            QCOMPARE(distanceTo({2 + 3, 1.5 + 4, z}, t), std::hypot(5, z));
            QCOMPARE(distanceTo({-3, -4, z}, t), std::hypot(5, z));
            QCOMPARE(distanceTo({9, 0, z}, t), std::hypot(5, z));
            QCOMPARE(distanceTo({0, 8, z}, t), std::hypot(5, z));
        }
    }

    void nearTheNearestOfAGrid()
    {
        for (int i = 0; i < 60; ++i) {
            Corners t{point(), point(), point()};
            if (i % 4 == 1)
                t[2] = t[0] * 0.3 + t[1] * 0.7; // no area
            if (i % 4 == 2)
                t[2] = t[0] * 0.3 + t[1] * 0.7 + point() * 1e-7; // hardly any
            if (i % 4 == 3)
                t[1] = t[0];
            const Vec3d p = point();
            const double exact = distanceTo(p, t), grid = nearestOfGrid(p, t);
            QVERIFY2(exact <= grid + 1e-9 && exact >= grid - 0.02, qPrintable(QString::number(exact - grid)));
        }
        const Vec3d a(1, 2, 3);
        QCOMPARE(distanceTo({1, 2, 5}, {a, a, a}), 2.0);
    }

    void asAllTrianglesSay_data()
    {
        QTest::addColumn<int>("mesh");
        for (std::size_t i = 0; i < tests::namedMeshes().size(); ++i)
            QTest::newRow(tests::namedMeshes()[i].name.c_str()) << int(i);
    }
    /// The tree is made for one frame and asked in another. Lone vertices are a part of the surface.
    void asAllTrianglesSay()
    {
        QFETCH(int, mesh);
        const TriangleMesh &named = tests::namedMeshes()[std::size_t(mesh)].mesh;
        const SurfaceTree tree(named.connectivity, named.positions);
        std::vector<Vec3f> moved = named.positions;
        for (Vec3f &p : moved)
            p = Vec3f{p.y, -p.x, p.z} * 0.7f + Vec3f{0.2f, 0.1f * p.x, 0};
        const SurfaceDistance surface(tree, moved);
        std::uint32_t hint = SurfaceDistance::NoTriangle;
        for (int i = 0; i < 100; ++i) {
            const Vec3d p = point() * 2;
            double expected = std::numeric_limits<double>::infinity();
            for (const Triangle &t : named.connectivity.triangles)
                expected = std::min(expected, squaredDistanceToTriangle(p, {moved[t[0]], moved[t[1]], moved[t[2]]}));
            for (const Vec3f &v : moved) // those of triangles are no nearer than these
                expected = std::min(expected, squaredDistance(p, v));
            std::uint32_t nearest = SurfaceDistance::NoTriangle;
            const double alone = surface.squared(p, nearest);
            const double hinted = surface.squared(p, hint);
            if (moved.empty()) {
                QVERIFY(std::isinf(alone) && nearest == SurfaceDistance::NoTriangle);
                continue;
            }
            QVERIFY(std::abs(alone - expected) <= 1e-12 * expected);
            QVERIFY(std::abs(hinted - expected) <= 1e-12 * expected);
            const auto &[a, b, c] = tree.triangles()[nearest];
            QCOMPARE(squaredDistanceToTriangle(p, {moved[a], moved[b], moved[c]}), alone);

            std::uint32_t start = std::uint32_t(i) % std::uint32_t(tree.triangles().size());
            const double enough = expected * (i % 2 ? 0.5 : 2);
            const double any = surface.squared(p, start, enough);
            QVERIFY(any >= expected * (1 - 1e-12));
            QVERIFY(any <= std::max(enough, expected * (1 + 1e-12)));
        }
    }
};

SANDREEL_TEST(TestSurfaceDistance)
#include "tst_surfacedistance.moc"
