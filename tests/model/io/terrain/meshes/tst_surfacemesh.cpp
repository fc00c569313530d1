// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/meshes/surfacemesh.h"
#include "model/terrain/simplify/simplifytin.h"
#include "model/terrain/tin/tinedit.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/io/terrain/terrains.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <random>

using namespace model;
using namespace model::io;
using namespace model::terrain;

namespace {

using Points = std::vector<Point3>;
using Faces = std::vector<Triangle>;

/// A grid whose squares are cut along either diagonal: not the Delaunay triangulation.
void ridges(Points &points, Faces &faces)
{
    constexpr std::uint32_t Side = 12;
    std::mt19937 random(8);
    for (std::uint32_t j = 0; j < Side; ++j)
        for (std::uint32_t i = 0; i < Side; ++i)
            points.push_back({double(i) + 0.1 * double(random() % 5), double(j) + 0.1 * double(random() % 5),
                              double(random() % 100) * 0.05});
    for (std::uint32_t j = 0; j + 1 < Side; ++j)
        for (std::uint32_t i = 0; i + 1 < Side; ++i) {
            const std::uint32_t a = j * Side + i, b = a + 1, c = a + Side, d = c + 1;
            if (i == 4 && j == 5)
                continue; // a hole
            if (random() % 2) {
                faces.push_back({a, b, d});
                faces.push_back({a, d, c});
            } else {
                faces.push_back({a, b, c});
                faces.push_back({b, d, c});
            }
        }
}

double heightOfMesh(const Points &points, const Triangle &t, Point2 p)
{
    const Point3 a = points[t[0]], b = points[t[1]], c = points[t[2]];
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const double wb = ((p.x - a.x) * (c.y - a.y) - (p.y - a.y) * (c.x - a.x)) / area;
    const double wc = ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / area;
    return a.z + wb * (b.z - a.z) + wc * (c.z - a.z);
}

} // namespace

class TestSurfaceMesh final : public QObject
{
    Q_OBJECT

private slots:
    void isTheMeshItself_data()
    {
        QTest::addColumn<double>("maxError");
        QTest::newRow("exact") << 0.0;
        QTest::newRow("nearly") << 1e-9;
        QTest::newRow("to 0.3") << 0.3;
        QTest::newRow("to 2") << 2.0;
    }
    void isTheMeshItself()
    {
        QFETCH(double, maxError);
        Points points;
        Faces faces;
        ridges(points, faces);
        Result<Tin> tin = tinOfSurface(points, faces);
        QVERIFY(tin.has_value());
        if (maxError > 0)
            tin = simplifyTin(*tin, maxError, SurfaceOwner);
        QVERIFY(tin.has_value());
        QVERIFY(findDefects(*tin).empty());
        // Places all over every face, found by nobody's triangulation.
        std::mt19937 random(2);
        double covered = 0, worst = 0;
        for (const Triangle &t : faces) {
            const Point3 a = points[t[0]], b = points[t[1]], c = points[t[2]];
            covered += 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
            for (int sample = 0; sample < 200; ++sample) {
                double u = (random() % 1000 + 0.5) / 1000.7, v = (random() % 1000 + 0.5) / 1000.7;
                if (u + v > 1) {
                    u = 1 - u;
                    v = 1 - v;
                }
                const Point2 p{a.x + u * (b.x - a.x) + v * (c.x - a.x), a.y + u * (b.y - a.y) + v * (c.y - a.y)};
                QVERIFY(!tin->arrays().isVoid(tin->triangleAt(p)));
                worst = std::max(worst, std::abs(tin->heightAt(p) - heightOfMesh(points, t, p)));
            }
        }
        QVERIFY2(worst <= maxError + 1e-9, QByteArray::number(worst).constData());
        double area = 0;
        for (TriangleId t = 0; t < tin->arrays().triangleSlots(); ++t)
            if (tin->arrays().isTriangle(t) && !tin->arrays().isVoid(t))
                area += areaOf(tin->arrays(), t);
        QVERIFY(std::abs(area - covered) < 1e-9);
        if (maxError == 2.0)
            QVERIFY(tin->vertexCount() < points.size());
    }

    void whatIsNoSurface_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QString>("why");
        QTest::newRow("a wall") << 0 << "a face stands upright";
        QTest::newRow("a wall between two points and their feet") << 1 << "a face stands upright";
        QTest::newRow("a roof that overhangs") << 2 << "edges cross, seen from above";
        QTest::newRow("a table over the ground") << 3 << "faces lie above one another";
        QTest::newRow("two sheets on the same points") << 4 << "a point lies above another";
        QTest::newRow("the same face twice") << 5 << "faces lie above one another";
    }
    void whatIsNoSurface()
    {
        QFETCH(int, kind);
        QFETCH(QString, why);
        Points points{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
        Faces faces{{0, 1, 2}, {0, 2, 3}};
        switch (kind) {
        case 0:
            points.push_back({5, 0, 5});
            faces.push_back({0, 1, 4});
            break;
        case 1:
            points.push_back({10, 10, 5});
            faces.push_back({1, 2, 4});
            break;
        case 2:
            points.insert(points.end(), {{20, 2, 0}, {20, 8, 0}, {5, 5, 9}});
            faces.push_back({4, 5, 6});
            break;
        case 3:
            points.insert(points.end(), {{5, 1, 9}, {6, 1, 9}, {6, 2, 9}});
            faces.push_back({4, 5, 6});
            break;
        case 4:
            points.push_back({0, 0, 1});
            faces.push_back({4, 1, 2});
            break;
        case 5:
            faces.push_back({1, 2, 0});
            break;
        }
        const auto tin = tinOfSurface(points, faces);
        SANDREEL_COMPARE_ERROR(tin, ErrorCode::NotASurface);
        QCOMPARE(QString::fromStdString(tin.error().args[1]), why);
        QVERIFY(tin.error().args[0].starts_with("x "));
    }

    void nothing()
    {
        SANDREEL_COMPARE_ERROR(tinOfSurface(Points{}, Faces{}), ErrorCode::NoVertices);
        // Slivers without an area are nothing.
        SANDREEL_COMPARE_ERROR(tinOfSurface(Points{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}, Faces{{0, 1, 2}}),
                               ErrorCode::NoVertices);
    }

    /// Voids, constraints and layers outlive a simplification.
    void simplifyingKeepsWhatIsNotHeight()
    {
        const Terrain terrain = tests::specimenTerrain(tests::Ground::Random, 4, 600);
        const auto tin = simplifyTin(terrain.tin, 0.2);
        QVERIFY(tin.has_value());
        QVERIFY(findDefects(*tin).empty());
        QVERIFY(tin->vertexCount() < terrain.tin.vertexCount());
        QCOMPARE(tin->arrays().totals.layers, terrain.tin.arrays().totals.layers);
        for (VertexId v = 0; v < tin->arrays().vertexSlots(); ++v) {
            const Location location = terrain.tin.locate(tin->arrays().points[v]);
            QCOMPARE(int(location.kind), int(Location::Kind::Vertex));
            const VertexId old = terrain.tin.arrays().vertex(location.corner);
            QCOMPARE(tin->arrays().sample(v, 1), terrain.tin.arrays().sample(old, 1));
        }
        tests::PointSource source(tests::Ground::Random, 77);
        for (int sample = 0; sample < 3000; ++sample) {
            const Point2 p = source.point();
            const bool isVoid = terrain.tin.arrays().isVoid(terrain.tin.triangleAt(p));
            QCOMPARE(tin->arrays().isVoid(tin->triangleAt(p)), isVoid);
            if (!isVoid)
                QVERIFY(std::abs(tin->heightAt(p) - terrain.tin.heightAt(p)) <= 0.2 + 1e-9);
        }
    }
};

SANDREEL_TEST(TestSurfaceMesh)
#include "tst_surfacemesh.moc"
