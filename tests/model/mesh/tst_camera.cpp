// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/camera.h"
#include "tests/support/testmain.h"

#include <array>
#include <numbers>
#include <random>

using namespace model;

namespace {

struct Projected
{
    double x, y, z, w;
};

/// By the definition of the two matrices, in double.
Projected project(const OrbitCamera &camera, float aspect, const Box3f &scene, Vec3f p)
{
    const auto times = [](const Matrix4 &m, std::array<double, 4> v) {
        std::array<double, 4> result{};
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                result[row] += double(m[column * 4 + row]) * v[column];
        return result;
    };
    const auto v = times(camera.projectionMatrix(aspect, scene), times(camera.viewMatrix(), {p.x, p.y, p.z, 1}));
    return {v[0] / v[3], v[1] / v[3], v[2] / v[3], v[3]};
}

std::array<Vec3f, 8> cornersOf(const Box3f &box)
{
    std::array<Vec3f, 8> corners;
    for (std::size_t i = 0; i < 8; ++i)
        corners[i] = {i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z};
    return corners;
}

/// Random directions, boxes and aspects, always the same ones.
struct Case
{
    OrbitCamera camera;
    Box3f box;
    float aspect = 1;
};
std::vector<Case> randomCases(int count)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<Case> cases;
    for (int i = 0; i < count; ++i) {
        Case c;
        c.camera.yaw = (unit(random) - 0.5f) * 6.2f;
        c.camera.pitch = (unit(random) - 0.5f) * std::numbers::pi_v<float>;
        c.camera.fieldOfView = 0.3f + unit(random);
        const float size = std::pow(10.0f, unit(random) * 8 - 4);
        const Vec3f corner{(unit(random) - 0.5f) * 5 * size, (unit(random) - 0.5f) * 5 * size,
                           (unit(random) - 0.5f) * 5 * size};
        c.box.add(corner);
        c.box.add(corner + Vec3f{unit(random), unit(random), i % 3 ? unit(random) : 0.0f} * size);
        c.aspect = 0.3f + 3 * unit(random);
        cases.push_back(c);
    }
    return cases;
}

} // namespace

class TestCamera final : public QObject
{
    Q_OBJECT

private slots:
    void standsWhereTheHeaderSays()
    {
        OrbitCamera camera;
        camera.target = {1, 2, 3};
        camera.distance = 5;
        camera.yaw = 0;
        camera.pitch = 0;
        QVERIFY(length(camera.position() - Vec3f{1, 2, 8}) < 1e-5f); // yaw 0 looks along -z
        QVERIFY(length(camera.right() - Vec3f{1, 0, 0}) < 1e-6f);
        QVERIFY(length(camera.up() - Vec3f{0, 1, 0}) < 1e-6f);
        camera.pitch = 0.5f; // looks down: stands higher
        QVERIFY(camera.position().y > 2);
    }

    void axesAreOrthonormal()
    {
        for (const Case &c : randomCases(100)) {
            const Vec3f x = c.camera.right(), y = c.camera.up();
            const Vec3f forward = (c.camera.target - c.camera.position()) * (1 / c.camera.distance);
            QVERIFY(std::abs(length(x) - 1) < 1e-5f && std::abs(length(y) - 1) < 1e-5f);
            QVERIFY(std::abs(dot(x, y)) < 1e-5f && std::abs(dot(x, forward)) < 1e-4f);
            QVERIFY(length(cross(x, y) + forward) < 1e-3f);
        }
    }

    void fitShowsEveryCornerAndNoMoreThanNeeded()
    {
        for (Case c : randomCases(300)) {
            c.camera.fit(c.box, c.aspect);
            double farthest = 0;
            for (const Vec3f corner : cornersOf(c.box)) {
                const Projected p = project(c.camera, c.aspect, c.box, corner);
                QVERIFY(p.w > 0);
                QVERIFY(std::abs(p.z) <= 1.001); // between the near and the far plane
                farthest = std::max({farthest, std::abs(p.x), std::abs(p.y)});
            }
            QVERIFY2(farthest <= 0.9405 && farthest > 0.93, qPrintable(QString::number(farthest)));
        }
    }

    void fitOfNothingChangesNothing()
    {
        OrbitCamera camera;
        camera.target = {1, 2, 3};
        camera.fit(Box3f(), 1);
        QVERIFY(camera.target == (Vec3f{1, 2, 3}));
        QCOMPARE(camera.distance, 4.0f);
    }

    void fitOfAPointLooksAtIt()
    {
        OrbitCamera camera;
        Box3f box;
        box.add(Vec3f{3, 4, 5});
        camera.fit(box, 1.5f);
        QVERIFY(camera.target == (Vec3f{3, 4, 5}));
        QVERIFY(camera.distance > 0);
        const Projected p = project(camera, 1.5f, box, {3, 4, 5});
        QVERIFY(std::abs(p.x) < 1e-5 && std::abs(p.y) < 1e-5 && std::abs(p.z) < 1);
    }

    void panKeepsTheDraggedPointUnderTheCursor()
    {
        for (Case c : randomCases(50)) {
            c.camera.fit(c.box, c.aspect);
            const Vec3f grabbed = c.camera.target;
            c.camera.pan(0.2f, 0.1f); // fractions of the height: 0.4 and 0.2 of the half height
            const Projected p = project(c.camera, c.aspect, c.box, grabbed);
            QVERIFY(std::abs(p.x - 0.4 / double(c.aspect)) < 1e-3);
            QVERIFY(std::abs(p.y + 0.2) < 1e-3); // y of the picture points down, that of the projection up
        }
    }

    void zoomAtKeepsThePointUnderTheCursor()
    {
        for (Case c : randomCases(50)) {
            c.camera.fit(c.box, c.aspect);
            const float height = 2 * c.camera.distance * std::tan(c.camera.fieldOfView / 2);
            const Vec3f seen = c.camera.target + c.camera.right() * (0.3f * height) - c.camera.up() * (-0.2f * height);
            const Projected before = project(c.camera, c.aspect, c.box, seen);
            const float distance = c.camera.distance;
            c.camera.zoomAt(0.5f, 0.3f, -0.2f);
            const Projected after = project(c.camera, c.aspect, c.box, seen);
            QVERIFY(std::abs(before.x - after.x) < 1e-3 && std::abs(before.y - after.y) < 1e-3);
            QVERIFY(std::abs(c.camera.distance / distance - 0.5f) < 1e-5f);
        }
    }

    void orbitTurnsAsADragDoes()
    {
        OrbitCamera camera;
        camera.yaw = camera.pitch = 0;
        camera.target = {};
        Box3f box;
        box.add(Vec3f{-1, -1, -1});
        box.add(Vec3f{1, 1, 1});
        camera.orbit(0.1f, 0);
        QVERIFY(project(camera, 1, box, {0, 0, 1}).x > 0); // what is in front follows the drag to the right
        camera.orbit(-0.1f, 0.1f);
        QVERIFY(project(camera, 1, box, {0, 0, 1}).y < 0); // and down
        camera.orbit(0, 10);
        QCOMPARE(camera.pitch, std::numbers::pi_v<float> / 2);
        camera.orbit(0, -20);
        QCOMPARE(camera.pitch, -std::numbers::pi_v<float> / 2);
        for (int i = 0; i < 1000; ++i)
            camera.orbit(0.37f, 0);
        QVERIFY(std::abs(camera.yaw) <= 3.1416f); // does not grow and lose precision
    }

    void zoomStopsBeforeTheLimitsOfFloat()
    {
        OrbitCamera camera;
        for (int i = 0; i < 500; ++i)
            camera.zoom(0.5f);
        QVERIFY(camera.distance > 0);
        for (int i = 0; i < 500; ++i)
            camera.zoom(2);
        QVERIFY(std::isfinite(camera.distance));
    }

    void depthHoldsTheSceneFromInsideAndBehind()
    {
        Box3f box;
        box.add(Vec3f{-1, -1, -1});
        box.add(Vec3f{1, 1, 1});
        for (const float distance : {0.01f, 0.5f, 2.0f, 1000.0f}) {
            OrbitCamera camera;
            camera.distance = distance;
            const Projected p = project(camera, 1, box, camera.target);
            QVERIFY2(std::abs(p.z) <= 1, qPrintable(QString::number(distance)));
        }
        OrbitCamera away; // all of the scene is behind it
        away.target = away.position() + (away.position() - away.target) * 10;
        for (const float m : away.projectionMatrix(1, box))
            QVERIFY(std::isfinite(m));
    }

    void multiplyIsTheProductOfMatrices()
    {
        Matrix4 a{}, b{};
        for (std::size_t i = 0; i < 16; ++i) {
            a[i] = float(i + 1);
            b[i] = float(i * i % 7) - 3;
        }
        const Matrix4 product = multiply(a, b);
        // Row 1, column 2: the row of a is 2, 6, 10, 14; the column of b starts at 8.
        QCOMPARE(product[9], 2 * b[8] + 6 * b[9] + 10 * b[10] + 14 * b[11]);
        Matrix4 one{};
        one[0] = one[5] = one[10] = one[15] = 1;
        QVERIFY(multiply(a, one) == a && multiply(one, a) == a);
    }
};

SANDREEL_TEST(TestCamera)
#include "tst_camera.moc"
