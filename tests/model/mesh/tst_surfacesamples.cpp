// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/surfacesamples.h"
#include "tests/support/testmain.h"

#include <cmath>

using namespace model;

class TestSurfaceSamples final : public QObject
{
    Q_OBJECT

private slots:
    /// Areas 1, 4 and 0 of two triangles and a half of one: 10 samples for each of the three, shared 1 : 4 : 0.
    void inProportionToTheArea()
    {
        const std::vector<Vec3f> positions{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {10, 0, 0}, {14, 0, 0}, {10, 2, 0}};
        const std::vector<Triangle> triangles{{0, 1, 2}, {3, 4, 5}, {0, 1, 1}};
        const std::vector<Edge> edges{{0, 1}, {0, 2}, {3, 4}};
        const SampleCounts counts = countSamples(positions, triangles, edges, 10);
        QVERIFY(counts.onTriangle == std::vector<std::uint32_t>({6, 24, 0}));
        // 6 samples per area are sqrt(6) = 2.449 per length: 4.9 on 2, 2.45 + 0.9 on 1, 9.8 + 0.35 on 4.
        QVERIFY(counts.onEdge == std::vector<std::uint32_t>({4, 3, 10}));
    }

    void smallTrianglesGetTheirShareTogether()
    {
        const std::vector<Vec3f> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        const std::vector<Triangle> triangles(1000, Triangle{0, 1, 2});
        const SampleCounts counts = countSamples(positions, triangles, {}, 0.1);
        std::uint32_t sum = 0;
        for (const std::uint32_t count : counts.onTriangle) {
            QVERIFY(count <= 1);
            sum += count;
        }
        QVERIFY(sum == 99 || sum == 100);
    }

    void noAreaNoSamples()
    {
        const std::vector<Vec3f> positions(3, Vec3f{1, 1, 1});
        const SampleCounts counts =
            countSamples(positions, std::vector<Triangle>{{0, 1, 2}}, std::vector<Edge>{{0, 1}, {1, 2}}, 50);
        QVERIFY(counts.onTriangle == std::vector<std::uint32_t>{0});
        QVERIFY(counts.onEdge == std::vector<std::uint32_t>({0, 0}));
    }

    /// Of any number of samples, every quarter of the triangle gets its share, give or take a few.
    void spreadEvenly()
    {
        for (const int count : {16, 64, 1000}) {
            int quarters[4] = {};
            for (int i = 0; i < count; ++i) {
                const auto [u, v, w] = triangleSample(std::uint32_t(i));
                QVERIFY(u >= 0 && v >= 0 && w >= 0 && std::abs(u + v + w - 1) < 1e-12);
                ++quarters[u > 0.5 ? 0 : v > 0.5 ? 1 : w > 0.5 ? 2 : 3];
            }
            for (const int inQuarter : quarters)
                QVERIFY2(std::abs(inQuarter - count / 4) <= 4, qPrintable(QString::number(inQuarter)));
        }
    }
};

SANDREEL_TEST(TestSurfaceSamples)
#include "tst_surfacesamples.moc"
