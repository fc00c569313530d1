// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/normals.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <cmath>

using namespace model;

namespace {

struct Reference
{
    double x = 0, y = 0, z = 0;
    double certainty = 0; ///< length of the sum by the sum of lengths: 0 where the triangles cancel out
};

/// Vertex by vertex over all triangles, in double: slow and plain.
std::vector<Reference> slowNormals(const std::vector<Vec3f> &positions, const std::vector<Triangle> &triangles)
{
    std::vector<Reference> result(positions.size());
    for (std::uint32_t vertex = 0; vertex < positions.size(); ++vertex) {
        long double x = 0, y = 0, z = 0, all = 0;
        for (const Triangle &t : triangles)
            for (const std::uint32_t corner : t) {
                if (corner != vertex)
                    continue;
                const Vec3f p = positions[t[0]], q = positions[t[1]], r = positions[t[2]];
                const long double ux = (long double)q.x - p.x, uy = (long double)q.y - p.y, uz = (long double)q.z - p.z;
                const long double vx = (long double)r.x - p.x, vy = (long double)r.y - p.y, vz = (long double)r.z - p.z;
                const long double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
                x += nx;
                y += ny;
                z += nz;
                all += std::sqrt(nx * nx + ny * ny + nz * nz);
            }
        const long double size = std::sqrt(x * x + y * y + z * z);
        if (size > 0)
            result[vertex] = {double(x / size), double(y / size), double(z / size), double(size / all)};
    }
    return result;
}

void compare(const std::vector<Vec3f> &positions, const std::vector<Triangle> &triangles)
{
    std::vector<Vec3f> normals(positions.size(), Vec3f{7, 7, 7});
    computeVertexNormals(positions, triangles, normals);
    const std::vector<Reference> expected = slowNormals(positions, triangles);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        QVERIFY2(std::abs(length(normals[i]) - 1) < 1e-5f, qPrintable(QString::number(i)));
        if (expected[i].certainty == 0)
            QVERIFY(normals[i] == (Vec3f{0, 0, 1}));
        else if (expected[i].certainty > 1e-3) {
            const double x = normals[i].x - expected[i].x, y = normals[i].y - expected[i].y,
                         z = normals[i].z - expected[i].z;
            QVERIFY2(std::sqrt(x * x + y * y + z * z) < 1e-4, qPrintable(QString::number(i)));
        }
    }
}

} // namespace

class TestNormals final : public QObject
{
    Q_OBJECT

private slots:
    void equalTheSlowOnes_data()
    {
        QTest::addColumn<int>("mesh");
        for (std::size_t i = 0; i < tests::namedMeshes().size(); ++i)
            QTest::newRow(tests::namedMeshes()[i].name.c_str()) << int(i);
    }
    void equalTheSlowOnes()
    {
        QFETCH(int, mesh);
        const TriangleMesh &under = tests::namedMeshes()[std::size_t(mesh)].mesh;
        compare(under.positions, under.connectivity.triangles);
    }

    void sizeDoesNotMatter_data()
    {
        QTest::addColumn<float>("scale");
        for (const float scale : {1e-30f, 1e-18f, 1e-12f, 1e-6f, 1e6f, 1e12f, 1e18f, 1e37f})
            QTest::addRow("%g", double(scale)) << scale;
    }
    void sizeDoesNotMatter()
    {
        QFETCH(float, scale);
        TriangleMesh mesh = tests::torus();
        for (Vec3f &p : mesh.positions)
            p = p * scale;
        compare(mesh.positions, mesh.connectivity.triangles);
    }

    void largeTrianglesCountMore()
    {
        // At vertex 0 a triangle of area 2 that looks along z and one of area 1/2 that looks along x.
        const std::vector<Vec3f> positions{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 1, 0}, {0, 0, 1}};
        const std::vector<Triangle> triangles{{0, 1, 2}, {0, 3, 4}};
        std::vector<Vec3f> normals(5);
        computeVertexNormals(positions, triangles, normals);
        const float size = std::sqrt(4.0f * 4.0f + 1.0f);
        QVERIFY(length(normals[0] - Vec3f{1 / size, 0, 4 / size}) < 1e-6f);
    }

    void cubeCornersPointAway()
    {
        const TriangleMesh mesh = tests::cube();
        std::vector<Vec3f> normals(mesh.positions.size());
        computeVertexNormals(mesh.positions, mesh.connectivity.triangles, normals);
        for (std::size_t i = 0; i < normals.size(); ++i)
            QVERIFY(dot(normals[i], mesh.positions[i]) > 1); // outwards, not inwards
    }
};

SANDREEL_TEST(TestNormals)
#include "tst_normals.moc"
