// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/mesh/softwareraster.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

using model::OrbitCamera;
using model::Picture;
using model::RasterStyle;
using model::Triangle;
using model::TriangleMesh;
using model::Vec3f;

class TestSoftwareRaster : public QObject
{
    Q_OBJECT
private slots:
    void coverageIsThatOfRays_data();
    void coverageIsThatOfRays();
    void nearestSurfaceIsSeen();
    void emptyMeshIsBackground();
    void shadingOfASphereIsThatOfItsLights();
    void shadingTurnsWithTheCamera();
    void bothSidesAreLit();
    void notFinitePositionsAreHarmless_data();
    void notFinitePositionsAreHarmless();
    void extremeScalesAreDrawn_data();
    void extremeScalesAreDrawn();
    void wireframeDrawsEdges();
    void sameBytesWithAnyNumberOfThreads();
    void endsOfThePaletteAreSurfaces();
    void placesAreBlendedInSpace();
    void nothingIsDrawnOnceCancelled();
};

namespace {

using Pixel = std::array<int, 3>;

Pixel pixelOf(const Picture &picture, int x, int y)
{
    const std::uint8_t *const p = picture.rgba.data() + 4 * (std::size_t(y) * std::size_t(picture.width) + x);
    return {p[0], p[1], p[2]};
}

/// A red surface before a blue background: what is covered is told from what is not.
RasterStyle redOnBlue()
{
    RasterStyle style;
    style.surface = {255, 0, 0};
    style.backgroundTop = style.backgroundBottom = {0, 0, 255};
    return style;
}
constexpr Pixel Blue{0, 0, 255};

OrbitCamera cameraFor(const TriangleMesh &mesh, float aspect)
{
    model::Box3f box;
    for (const Vec3f &p : mesh.positions)
        box.add(p);
    OrbitCamera camera;
    camera.fit(box, aspect);
    return camera;
}

Picture drawn(const TriangleMesh &mesh, const OrbitCamera &camera, int width, int height, const RasterStyle &style)
{
    return model::drawMesh(mesh.positions, mesh.connectivity.triangles, camera, width, height, style);
}

struct Point
{
    double x, y, z;
};
Point operator-(Point a, Point b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Point cross(Point a, Point b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(Point a, Point b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Point pointOf(Vec3f v)
{
    return {v.x, v.y, v.z};
}

/// What a ray through the picture meets, without matrices and without projecting anything.
class RayCaster
{
public:
    RayCaster(const TriangleMesh &mesh, const OrbitCamera &camera, int width, int height)
        : mMesh(mesh)
        , mEye(pointOf(camera.position()))
        , mRight(pointOf(camera.right()))
        , mUp(pointOf(camera.up()))
        , mBack(pointOf(camera.position() - camera.target))
        , mSlope(std::tan(double(camera.fieldOfView) / 2))
        , mWidth(width)
        , mHeight(height)
    {
        const double length = std::sqrt(dot(mBack, mBack));
        mBack = {mBack.x / length, mBack.y / length, mBack.z / length};
    }

    /// The nearest triangle at a place in the picture, in pixels.
    std::optional<std::size_t> hit(double px, double py) const
    {
        const double u = (2 * px - mWidth) / mHeight * mSlope, v = (1 - 2 * py / mHeight) * mSlope;
        const Point ray{mRight.x * u + mUp.x * v - mBack.x, mRight.y * u + mUp.y * v - mBack.y,
                        mRight.z * u + mUp.z * v - mBack.z};
        std::optional<std::size_t> nearest;
        double least = std::numeric_limits<double>::max();
        const auto &triangles = mMesh.connectivity.triangles;
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const Point a = pointOf(mMesh.positions[triangles[i][0]]);
            const Point e = pointOf(mMesh.positions[triangles[i][1]]) - a;
            const Point f = pointOf(mMesh.positions[triangles[i][2]]) - a;
            const Point h = cross(ray, f);
            const double determinant = dot(e, h);
            if (determinant == 0)
                continue;
            const Point s = mEye - a;
            const Point q = cross(s, e);
            const double b = dot(s, h) / determinant, c = dot(ray, q) / determinant, t = dot(f, q) / determinant;
            if (b >= -1e-12 && c >= -1e-12 && b + c <= 1 + 1e-12 && t > 0 && t < least) {
                least = t;
                nearest = i;
            }
        }
        return nearest;
    }

    /// The answer of all samples of a pixel, each shifted a little every way: nothing if they do not agree.
    template <class Answer>
    auto surely(int x, int y, const Answer &answer) const -> std::optional<decltype(answer(hit(0, 0)))>
    {
        constexpr double Shift = 0.02; // pixels; vertices snap to less than that
        const auto first = answer(hit(x + 0.25, y + 0.25));
        for (const double sy : {0.25, 0.75})
            for (const double sx : {0.25, 0.75})
                for (const auto &[dx, dy] : {std::pair(0.0, 0.0), std::pair(Shift, Shift), std::pair(-Shift, Shift),
                                             std::pair(Shift, -Shift), std::pair(-Shift, -Shift)})
                    if (answer(hit(x + sx + dx, y + sy + dy)) != first)
                        return {};
        return first;
    }

private:
    const TriangleMesh &mMesh;
    Point mEye, mRight, mUp, mBack;
    double mSlope;
    int mWidth, mHeight;
};

/// Rings of vertices around the y axis; the pattern comes onto itself with every step around.
TriangleMesh sphere(int rings = 40, int segments = 80)
{
    TriangleMesh mesh;
    for (int ring = 0; ring <= rings; ++ring)
        for (int segment = 0; segment < segments; ++segment) {
            const double across = std::numbers::pi * ring / rings, around = 2 * std::numbers::pi * segment / segments;
            mesh.positions.push_back({float(std::sin(across) * std::sin(around)), float(std::cos(across)),
                                      float(std::sin(across) * std::cos(around))});
        }
    for (int ring = 0; ring < rings; ++ring)
        for (int segment = 0; segment < segments; ++segment) {
            const int next = (segment + 1) % segments;
            const auto at = [&](int r, int s) { return std::uint32_t(r * segments + s); };
            mesh.connectivity.triangles.push_back({at(ring, segment), at(ring + 1, segment), at(ring + 1, next)});
            mesh.connectivity.triangles.push_back({at(ring, segment), at(ring + 1, next), at(ring, next)});
        }
    mesh.connectivity.vertexCount = std::uint32_t(mesh.positions.size());
    return mesh;
}

OrbitCamera frontal(float yaw = 0)
{
    OrbitCamera camera;
    camera.yaw = yaw;
    camera.pitch = 0;
    camera.fit({{-1, -1, -1}, {1, 1, 1}}, 1);
    return camera;
}

} // namespace

void TestSoftwareRaster::coverageIsThatOfRays_data()
{
    QTest::addColumn<TriangleMesh>("mesh");
    QTest::addColumn<OrbitCamera>("camera");
    constexpr float Aspect = 61.0f / 47.0f;
    for (const tests::NamedMesh &entry : tests::namedMeshes())
        QTest::newRow(entry.name.c_str()) << entry.mesh << cameraFor(entry.mesh, Aspect);
    // Much of it behind the camera: cut at the near plane.
    TriangleMesh floor = tests::grid(3, 3);
    for (Vec3f &p : floor.positions)
        p = {40 * p.x - 20, 0, 40 * p.y - 20};
    OrbitCamera above;
    above.target = {0, 0.5f, 0};
    above.pitch = 0.05f;
    above.distance = 3;
    QTest::newRow("floor around the camera") << floor << above;
    OrbitCamera inside;
    inside.distance = 0.4f;
    QTest::newRow("inside a cube") << tests::cube() << inside;
    OrbitCamera behind;
    behind.target = {0, 0, 20};
    behind.yaw = 0;
    behind.pitch = 0;
    QTest::newRow("cube in front") << tests::cube() << behind;
    behind.target = {0, 0, -20};
    QTest::newRow("cube behind the camera") << tests::cube() << behind;
    OrbitCamera aside = cameraFor(tests::torus(), Aspect);
    aside.pan(0.6f, 0.45f);
    QTest::newRow("half outside") << tests::torus() << aside;
    aside.zoom(0.1f);
    QTest::newRow("far larger than the picture") << tests::torus() << aside;
}

void TestSoftwareRaster::coverageIsThatOfRays()
{
    QFETCH(const TriangleMesh, mesh);
    QFETCH(const OrbitCamera, camera);
    constexpr int Width = 61, Height = 47; // neither a multiple of anything
    const Picture picture = drawn(mesh, camera, Width, Height, redOnBlue());
    QCOMPARE(picture.width, Width);
    QCOMPARE(picture.height, Height);
    QCOMPARE(picture.rgba.size(), std::size_t(Width * Height * 4));
    const RayCaster rays(mesh, camera, Width, Height);
    int sure = 0;
    for (int y = 0; y < Height; ++y)
        for (int x = 0; x < Width; ++x) {
            const auto covered = rays.surely(x, y, [](const auto &triangle) { return triangle.has_value(); });
            if (!covered)
                continue;
            ++sure;
            const Pixel pixel = pixelOf(picture, x, y);
            QVERIFY2(*covered ? pixel[2] < 128 : pixel == Blue,
                     qPrintable(QStringLiteral("%1, %2 is %3 covered").arg(x).arg(y).arg(*covered ? "" : "not")));
        }
    QVERIFY(sure > Width * Height * 3 / 4); // else this says nothing
}

void TestSoftwareRaster::nearestSurfaceIsSeen()
{
    // Three sheets that pass through each other, tilted so that each has a shade of its own.
    TriangleMesh all;
    std::vector<TriangleMesh> sheets;
    const Vec3f corners[3][3] = {{{-1, -1, -0.6f}, {1, -0.9f, 0.7f}, {0, 1, 0}},
                                 {{-0.9f, -0.7f, 0.8f}, {1, -1, -0.9f}, {-0.2f, 0.9f, 0.3f}},
                                 {{-1, 0.3f, -0.2f}, {1, 0.5f, 0.1f}, {0.1f, -0.8f, 0.2f}}};
    for (const auto &sheet : corners) {
        const auto first = std::uint32_t(all.positions.size());
        all.positions.insert(all.positions.end(), std::begin(sheet), std::end(sheet));
        all.connectivity.triangles.push_back({first, first + 1, first + 2});
        TriangleMesh alone;
        alone.positions.assign(std::begin(sheet), std::end(sheet));
        alone.connectivity = {3, {{0, 1, 2}}};
        sheets.push_back(std::move(alone));
    }
    all.connectivity.vertexCount = 9;
    constexpr int Side = 80;
    const OrbitCamera camera = frontal(0.3f);
    const Picture together = drawn(all, camera, Side, Side, redOnBlue());
    std::vector<Picture> alone;
    for (const TriangleMesh &sheet : sheets)
        alone.push_back(drawn(sheet, camera, Side, Side, redOnBlue()));
    const RayCaster rays(all, camera, Side, Side);
    int seen[3] = {};
    for (int y = 0; y < Side; ++y)
        for (int x = 0; x < Side; ++x)
            if (const auto nearest = rays.surely(x, y, [](const auto &triangle) { return triangle; });
                nearest && *nearest) {
                ++seen[**nearest];
                QCOMPARE(pixelOf(together, x, y), pixelOf(alone[**nearest], x, y));
            }
    for (const int count : seen)
        QVERIFY(count > 100);
}

void TestSoftwareRaster::emptyMeshIsBackground()
{
    const RasterStyle style;
    const auto isBackground = [&](const Picture &picture) {
        const auto near = [](const Pixel &pixel, const std::array<std::uint8_t, 3> &colour) {
            return std::abs(pixel[0] - colour[0]) <= 1 && std::abs(pixel[1] - colour[1]) <= 1 &&
                   std::abs(pixel[2] - colour[2]) <= 1;
        };
        bool good = near(pixelOf(picture, 0, 0), style.backgroundTop) &&
                    near(pixelOf(picture, 0, picture.height - 1), style.backgroundBottom);
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                good = good && pixelOf(picture, x, y) == pixelOf(picture, 0, y) &&
                       picture.rgba[4 * std::size_t(y * picture.width + x) + 3] == 255;
                good = good && (y == 0 || pixelOf(picture, x, y)[0] <= pixelOf(picture, x, y - 1)[0]);
            }
        return good;
    };
    QVERIFY(isBackground(drawn(tests::none(), OrbitCamera(), 33, 37, style)));
    QVERIFY(isBackground(drawn(tests::noTriangles(), OrbitCamera(), 33, 37, style)));
    OrbitCamera away = frontal();
    away.target = {0, 0, 50}; // looks along +z from z = 46: the sphere is behind it
    away.yaw = std::numbers::pi_v<float>;
    QVERIFY(isBackground(drawn(sphere(), away, 33, 37, style)));
    QCOMPARE(drawn(sphere(), frontal(), 1, 1, style).rgba.size(), std::size_t(4));
}

void TestSoftwareRaster::shadingOfASphereIsThatOfItsLights()
{
    constexpr int Side = 101;
    RasterStyle style;
    style.surface = {255, 255, 255};
    const Picture picture = drawn(sphere(), frontal(), Side, Side, style);
    const auto light = [&](double u, double v) { // -1..1 over the sphere, v upwards
        const Pixel p = pixelOf(picture, int(Side / 2.0 + u * Side * 0.4), int(Side / 2.0 - v * Side * 0.4));
        return p[0] + p[1] + p[2];
    };
    // The key light comes from the upper left, so it is brightest there, darkest opposite, and never black.
    QVERIFY(light(-0.4, 0.5) > light(0, 0));
    QVERIFY(light(0, 0) > light(0.5, -0.6));
    QVERIFY(light(-0.4, 0.5) > light(0.4, -0.5) + 100);
    QVERIFY(light(0.5, -0.6) > 60);
    // It falls off without a jump from the brightest spot to the far rim.
    for (double t = 0; t < 0.85; t += 0.03) {
        const double a = t, b = t + 0.03;
        QVERIFY(light(-0.3 + a, 0.4 - a) + 6 >= light(-0.3 + b, 0.4 - b));
        QVERIFY(light(-0.3 + a, 0.4 - a) - light(-0.3 + b, 0.4 - b) < 60);
    }
}

void TestSoftwareRaster::shadingTurnsWithTheCamera()
{
    constexpr int Side = 90;
    const Picture front = drawn(sphere(), frontal(), Side, Side, {});
    for (const float turn : {0.5f, 1.0f, 1.5f}) {
        const Picture turned = drawn(sphere(), frontal(turn * std::numbers::pi_v<float>), Side, Side, {});
        int different = 0;
        for (std::size_t i = 0; i < front.rgba.size(); ++i)
            different += std::abs(front.rgba[i] - turned.rgba[i]) > 3;
        QVERIFY2(different < Side, qPrintable(QString::number(different)));
    }
}

void TestSoftwareRaster::bothSidesAreLit()
{
    constexpr int Side = 64;
    TriangleMesh inverted = sphere();
    for (Triangle &t : inverted.connectivity.triangles)
        std::swap(t[0], t[1]);
    const Picture outside = drawn(sphere(), frontal(), Side, Side, {});
    const Picture inside = drawn(inverted, frontal(), Side, Side, {});
    // At the rim a normal may turn away from the viewer just before its triangle does.
    int different = 0;
    for (std::size_t i = 0; i < outside.rgba.size(); ++i)
        different += std::abs(outside.rgba[i] - inside.rgba[i]) > 1;
    QVERIFY2(different == 0, qPrintable(QString::number(different)));
}

void TestSoftwareRaster::notFinitePositionsAreHarmless_data()
{
    QTest::addColumn<float>("value");
    QTest::newRow("NaN") << std::numeric_limits<float>::quiet_NaN();
    QTest::newRow("infinity") << std::numeric_limits<float>::infinity();
    QTest::newRow("-infinity") << -std::numeric_limits<float>::infinity();
}

void TestSoftwareRaster::notFinitePositionsAreHarmless()
{
    QFETCH(const float, value);
    const TriangleMesh good = sphere(10, 12);
    TriangleMesh bad = good;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3f p{0.1f, 0.2f, 0.3f};
        (axis == 0 ? p.x : axis == 1 ? p.y : p.z) = value;
        bad.positions.push_back(p);
        bad.connectivity.triangles.push_back(
            {std::uint32_t(axis), std::uint32_t(40 + axis), bad.connectivity.vertexCount++});
    }
    for (const bool wireframe : {false, true}) {
        RasterStyle style;
        style.wireframe = wireframe;
        QVERIFY(drawn(bad, frontal(), 50, 40, style).rgba == drawn(good, frontal(), 50, 40, style).rgba);
    }
    // A camera that is spoilt shows nothing, and does no harm.
    OrbitCamera spoilt = frontal();
    spoilt.yaw = value;
    QVERIFY(drawn(good, spoilt, 50, 40, {}).rgba == drawn(tests::none(), frontal(), 50, 40, {}).rgba);
}

void TestSoftwareRaster::extremeScalesAreDrawn_data()
{
    QTest::addColumn<float>("scale");
    for (const float scale : {1e-9f, 1e-4f, 1e4f, 1e9f})
        QTest::newRow(qPrintable(QString::number(double(scale)))) << scale;
}

/// The picture does not depend on the unit of length.
void TestSoftwareRaster::extremeScalesAreDrawn()
{
    QFETCH(const float, scale);
    constexpr int Side = 60;
    TriangleMesh mesh = tests::cube();
    const Picture expected = drawn(mesh, cameraFor(mesh, 1), Side, Side, {});
    for (Vec3f &p : mesh.positions)
        p = p * scale;
    const Picture picture = drawn(mesh, cameraFor(mesh, 1), Side, Side, {});
    int different = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        different += std::abs(picture.rgba[i] - expected.rgba[i]) > 8;
    QVERIFY2(different < Side, qPrintable(QString::number(different)));
}

void TestSoftwareRaster::wireframeDrawsEdges()
{
    constexpr int Side = 100;
    RasterStyle plain = redOnBlue();
    RasterStyle wire = plain;
    wire.wireframe = true;
    // A square of two triangles: its diagonal is an edge too.
    const TriangleMesh square = tests::grid(1, 1);
    OrbitCamera camera;
    camera.yaw = camera.pitch = 0;
    camera.target = {0.5f, 0.5f, 0};
    camera.distance = 2;
    const Picture without = drawn(square, camera, Side, Side, plain);
    const Picture with = drawn(square, camera, Side, Side, wire);
    const double half = 0.5 / (2 * std::tan(double(camera.fieldOfView) / 2)) * Side / 2; // of the square, pixels
    const auto at = [&](const Picture &picture, double u, double v) {
        return pixelOf(picture, int(Side / 2.0 + u * half), int(Side / 2.0 - v * half));
    };
    // On the diagonal the line's blue shows, on both sides of it nothing changes.
    for (const double t : {-0.7, -0.2, 0.0, 0.3, 0.8})
        QVERIFY(at(with, t, t)[2] > at(without, t, t)[2] + 80);
    for (const auto &[u, v] : {std::pair(-0.5, 0.5), std::pair(0.5, -0.5), std::pair(0.2, 0.6)})
        QCOMPARE(at(with, u, v), at(without, u, v));
    // And at the rim, where half of the line lies on the square.
    int lined = 0;
    for (int y = 0; y < Side; ++y)
        for (int x = 0; x < Side; ++x) {
            QVERIFY(pixelOf(without, x, y) != Blue || pixelOf(with, x, y) == Blue); // nothing outside
            lined += pixelOf(with, x, y) != pixelOf(without, x, y);
        }
    QVERIFY2(lined > 8 * half && lined < 8 * half * 3, qPrintable(QString::number(lined)));
}

void TestSoftwareRaster::sameBytesWithAnyNumberOfThreads()
{
    const TriangleMesh mesh = tests::torus();
    const OrbitCamera camera = cameraFor(mesh, 2);
    RasterStyle style;
    style.wireframe = true;
    model::setThreadCount(1);
    const Picture one = drawn(mesh, camera, 200, 100, style);
    for (const unsigned threads : {2u, 5u}) {
        model::setThreadCount(threads);
        const Picture many = drawn(mesh, camera, 200, 100, style);
        QVERIFY(many.rgba == one.rgba);
    }
    model::setThreadCount(0);
}

void TestSoftwareRaster::endsOfThePaletteAreSurfaces()
{
    const TriangleMesh mesh = tests::cube();
    const OrbitCamera camera = cameraFor(mesh, 1);
    const std::array<std::array<std::uint8_t, 3>, 3> palette{{{250, 20, 10}, {30, 200, 60}, {20, 90, 240}}};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const auto &[place, colour] : {std::pair(0.0f, 0), {-3.0f, 0}, {nan, 0}, {0.5f, 1}, {1.0f, 2}, {7.0f, 2}}) {
        RasterStyle plain, coloured;
        plain.surface = palette[std::size_t(colour)];
        const std::vector<float> places(mesh.positions.size(), place);
        coloured.places = places;
        coloured.palette = palette;
        const Picture expected = drawn(mesh, camera, 90, 90, plain), found = drawn(mesh, camera, 90, 90, coloured);
        for (std::size_t i = 0; i < expected.rgba.size(); ++i)
            QVERIFY(std::abs(int(expected.rgba[i]) - int(found.rgba[i])) <= 1);
    }
}

// One large triangle that leads away from the eye looks as many small ones of the same plane do.
void TestSoftwareRaster::placesAreBlendedInSpace()
{
    constexpr int Parts = 40;
    const Vec3f a{-1, 0, 3}, b{1, 0, 3}, c{0, 0, -9};
    const auto placeOf = [](Vec3f p) { return (3 - p.z) / 12; };
    TriangleMesh large{{a, b, c}, {3, {{0, 1, 2}}}};
    TriangleMesh small;
    for (int row = 0; row <= Parts; ++row)
        for (int i = 0; i <= row; ++i) {
            const float u = float(row) / Parts, v = row ? float(i) / float(row) : 0;
            small.positions.push_back(c * (1 - u) + (a * (1 - v) + b * v) * u);
        }
    for (int row = 0; row < Parts; ++row)
        for (int i = 0; i <= row; ++i) {
            const auto at = [](int r, int k) { return std::uint32_t(r * (r + 1) / 2 + k); };
            small.connectivity.triangles.push_back({at(row, i), at(row + 1, i), at(row + 1, i + 1)});
            if (i < row)
                small.connectivity.triangles.push_back({at(row, i), at(row + 1, i + 1), at(row, i + 1)});
        }
    small.connectivity.vertexCount = std::uint32_t(small.positions.size());
    OrbitCamera camera = cameraFor(large, 1);
    camera.yaw = 0;
    camera.pitch = 0.25f;
    camera.distance = 6;
    const std::array<std::array<std::uint8_t, 3>, 2> palette{{{0, 0, 0}, {255, 255, 255}}};
    const auto picture = [&](const TriangleMesh &mesh) {
        std::vector<float> places;
        for (const Vec3f p : mesh.positions)
            places.push_back(placeOf(p));
        RasterStyle style;
        style.places = places;
        style.palette = palette;
        return drawn(mesh, camera, 200, 200, style);
    };
    const Picture one = picture(large), many = picture(small);
    int covered = 0, differing = 0, darkest = 255, brightest = 0;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) {
            const Pixel p = pixelOf(one, x, y), q = pixelOf(many, x, y);
            if (p == pixelOf(one, 0, y))
                continue; // background
            ++covered;
            differing += std::abs(p[0] - q[0]) > 6;
            darkest = std::min(darkest, p[0]);
            brightest = std::max(brightest, p[0]);
        }
    QVERIFY2(covered > 1500, qPrintable(QString::number(covered)));
    QVERIFY2(brightest - darkest > 60, qPrintable(QString::number(brightest - darkest)));
    QVERIFY2(differing < covered / 20, qPrintable(QString("%1 of %2").arg(differing).arg(covered))); // at the border
}

void TestSoftwareRaster::nothingIsDrawnOnceCancelled()
{
    const TriangleMesh mesh = tests::cube();
    const model::Progress progress;
    progress.cancel();
    const Picture picture =
        model::drawMesh(mesh.positions, mesh.connectivity.triangles, cameraFor(mesh, 1), 64, 64, {}, progress);
    QCOMPARE(picture.rgba.size(), std::size_t(64 * 64 * 4));
    QVERIFY(std::all_of(picture.rgba.begin(), picture.rgba.end(), [](std::uint8_t c) { return c == 0; }));
}

SANDREEL_TEST(TestSoftwareRaster)
#include "tst_softwareraster.moc"
