// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/query/disc.h"
#include "tests/model/terrain/tin/randomedits.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <cmath>

using namespace model::terrain;

namespace {

/// Whether some point of a fine raster of the triangle lies in the disc.
bool touches(const TinArrays &tin, TriangleId t, Point2 centre, double radius)
{
    constexpr int Steps = 40;
    const Point2 a = tin.pointAt(cornerOf(t, 0)), b = tin.pointAt(cornerOf(t, 1)), c = tin.pointAt(cornerOf(t, 2));
    for (int i = 0; i <= Steps; ++i)
        for (int j = 0; i + j <= Steps; ++j) {
            const double u = double(i) / Steps, v = double(j) / Steps;
            if (std::hypot(a.x + u * (b.x - a.x) + v * (c.x - a.x) - centre.x,
                           a.y + u * (b.y - a.y) + v * (c.y - a.y) - centre.y) <= radius)
                return true;
        }
    return false;
}

} // namespace

class TestDisc final : public QObject
{
    Q_OBJECT

private slots:
    void everythingUnderTheDiscIsFound()
    {
        tests::PointSource source(tests::Ground::Random, 41);
        const auto built = buildTin(source.points(150), source.domain());
        QVERIFY(built);
        const TinArrays &tin = built->tin.arrays();
        DiscSearch disc;
        for (int i = 0; i < 15; ++i) {
            const Point2 centre{source.uniform(-0.2, 1.2), source.uniform(-0.2, 1.2)};
            const double radius = source.uniform(0, 0.4);
            disc.search(built->tin, centre, radius);
            std::vector<TriangleId> found(disc.triangles().begin(), disc.triangles().end());
            std::sort(found.begin(), found.end());
            QVERIFY(std::unique(found.begin(), found.end()) == found.end());
            for (TriangleId t = 0; t < tin.triangleSlots(); ++t) {
                const bool isFound = std::binary_search(found.begin(), found.end(), t);
                if (touches(tin, t, centre, radius))
                    QVERIFY(isFound);
                else if (!touches(tin, t, centre, radius + 0.02)) // more than the raster may miss
                    QVERIFY(!isFound);
            }
            std::vector<VertexId> vertices(disc.vertices().begin(), disc.vertices().end()), expected;
            std::sort(vertices.begin(), vertices.end());
            for (VertexId v = 0; v < tin.vertexSlots(); ++v)
                if (std::hypot(tin.points[v].x - centre.x, tin.points[v].y - centre.y) <= radius)
                    expected.push_back(v);
            QCOMPARE(vertices, expected);
        }
    }

    void aDiscBesideTheDomainFindsNothing()
    {
        const Tin tin(Rectangle{{0, 0}, {1, 1}});
        DiscSearch disc;
        disc.search(tin, {1.5, 1.5}, 0.7);
        QVERIFY(disc.triangles().empty() && disc.vertices().empty());
        disc.search(tin, {1.5, 1.5}, 0.8);
        QVERIFY(!disc.triangles().empty());
        QCOMPARE(disc.vertices().size(), std::size_t(1));
        disc.search(tin, {0.5, 0.25}, 0);
        QCOMPARE(disc.triangles().size(), std::size_t(1));
    }
};

SANDREEL_TEST(TestDisc)
#include "tst_disc.moc"
