// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/geometry/vec3d.h"
#include "model/mesh/analysis/selfintersections.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <random>

using namespace model;
using namespace tests;

namespace {

std::vector<ProblemIds> crossings(const TriangleMesh &mesh)
{
    auto pairs = findSelfIntersections(Faces(mesh.connectivity), mesh.positions);
    return pairs ? std::move(*pairs) : std::vector<ProblemIds>{{99, 99}};
}

/// Whether some edge of one triangle goes through the inside of the other, in small integers: exact, and all there is
/// for triangles in general position that share no corner.
bool anEdgePierces(const std::array<Vec3f, 3> &a, const std::array<Vec3f, 3> &b)
{
    const auto volume = [](Vec3f p, Vec3f q, Vec3f r, Vec3f s) {
        return dot(cross(Vec3d(q) - Vec3d(p), Vec3d(r) - Vec3d(p)), Vec3d(s) - Vec3d(p));
    };
    for (unsigned i = 0; i < 3; ++i) {
        const Vec3f from = a[i], to = a[(i + 1) % 3];
        if (volume(b[0], b[1], b[2], from) * volume(b[0], b[1], b[2], to) >= 0)
            continue;
        const double u = volume(from, to, b[0], b[1]), v = volume(from, to, b[1], b[2]),
                     w = volume(from, to, b[2], b[0]);
        if ((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0))
            return true;
    }
    return false;
}

} // namespace

class TestSelfIntersections final : public QObject
{
    Q_OBJECT

private slots:
    void soundMeshesHaveNone()
    {
        for (const TriangleMesh &mesh : {cube(), tetrahedron(), torus(), twoParts(), grid(), bowTie()})
            QVERIFY(crossings(mesh).empty());
    }

    void randomTrianglesAgreeWithTheirEdges()
    {
        std::mt19937 random(4);
        const auto coordinate = [&] { return float(int(random() % 2001) - 1000); };
        for (int round = 0; round < 10; ++round) {
            TriangleMesh mesh;
            for (std::uint32_t t = 0; t < 60; ++t) {
                for (int i = 0; i < 3; ++i)
                    mesh.positions.push_back({coordinate(), coordinate(), coordinate()});
                mesh.connectivity.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
            }
            mesh.connectivity.vertexCount = 180;
            std::vector<ProblemIds> expected;
            for (std::uint32_t a = 0; a < 60; ++a)
                for (std::uint32_t b = a + 1; b < 60; ++b) {
                    const auto corners = [&](std::uint32_t t) {
                        return std::array{mesh.positions[3 * t], mesh.positions[3 * t + 1], mesh.positions[3 * t + 2]};
                    };
                    if (anEdgePierces(corners(a), corners(b)) || anEdgePierces(corners(b), corners(a)))
                        expected.push_back({a, b});
                }
            QVERIFY(!expected.empty());
            QVERIFY(crossings(mesh) == expected);
        }
    }

    void neighboursMayOnlyShareTheirCorners()
    {
        // An edge shared: flat and apart, flat and folded over, bent.
        const auto hinge = [](Vec3f tip) {
            return crossings({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, tip}, {4, {{0, 1, 2}, {1, 0, 3}}}});
        };
        QVERIFY(hinge({0, -1, 0}).empty());
        QVERIFY(hinge({0.25f, 0.5f, 0.5f}).empty());
        QVERIFY(hinge({0.25f, 0.5f, 0}) == (std::vector<ProblemIds>{{0, 1}}));
        // A corner shared: beside it, and with an edge through the other.
        const auto fan = [](Vec3f a, Vec3f b) {
            return crossings({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, a, b}, {5, {{0, 1, 2}, {0, 3, 4}}}});
        };
        QVERIFY(fan({-1, 0, 1}, {0, -1, 1}).empty());
        QVERIFY(fan({0.5f, 0.5f, 1}, {0.5f, 0.5f, -1}) == (std::vector<ProblemIds>{{0, 1}}));
    }

    void seamsOfUnweldedVerticesAreNone()
    {
        // The cube as a soup: corners at the same place are shared.
        TriangleMesh soup;
        for (const Triangle &t : cube().connectivity.triangles) {
            const auto first = std::uint32_t(soup.positions.size());
            for (const std::uint32_t v : t)
                soup.positions.push_back(cube().positions[v]);
            soup.connectivity.triangles.push_back({first, first + 1, first + 2});
        }
        soup.connectivity.vertexCount = std::uint32_t(soup.positions.size());
        QVERIFY(crossings(soup).empty());
    }

    void degenerateAndDuplicateFacesArePassedBy()
    {
        QVERIFY(
            crossings({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {4, {{0, 1, 2}, {2, 0, 1}, {0, 1, 3}, {0, 0, 1}}}})
                .empty());
    }

    void polygonsAreOneFaceEach()
    {
        Faces faces(7);
        faces.add(std::array{0u, 1u, 2u, 3u});
        faces.add(std::array{4u, 5u, 6u});
        const std::vector<Vec3f> positions{{0, 0, 0},  {4, 0, 0},  {4, 4, 0}, {0, 4, 0},
                                           {1, 1, -1}, {3, 3, -1}, {2, 2, 2}};
        const auto pairs = findSelfIntersections(faces, positions); // through both triangles of the square
        QVERIFY(pairs && *pairs == (std::vector<ProblemIds>{{0, 1}}));
    }

    void aCancelIsAnError()
    {
        const Progress progress;
        progress.cancel();
        const auto pairs = findSelfIntersections(Faces(cube().connectivity), cube().positions, progress);
        QVERIFY(!pairs && pairs.error().code == ErrorCode::Cancelled);
    }
};

SANDREEL_TEST(TestSelfIntersections)
#include "tst_selfintersections.moc"
