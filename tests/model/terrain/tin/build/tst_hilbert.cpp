// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/build/hilbert.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <random>

using namespace model::terrain;

class TestHilbert final : public QObject
{
    Q_OBJECT

private slots:
    /// The cells of the coarsest 64 x 64 grid, each once, and each beside the one before: only a Hilbert curve does
    /// that and keeps quadrants together.
    void neighboursOnTheCurveAreNeighbours()
    {
        std::vector<std::pair<std::uint64_t, std::pair<int, int>>> cells;
        for (int x = 0; x < 64; ++x)
            for (int y = 0; y < 64; ++y)
                cells.push_back({hilbertIndex(std::uint32_t(x) << 26, std::uint32_t(y) << 26) >> 52, {x, y}});
        std::sort(cells.begin(), cells.end());
        for (std::size_t i = 0; i < cells.size(); ++i) {
            QCOMPARE(cells[i].first, std::uint64_t(i));
            if (i == 0)
                continue;
            const auto [x, y] = cells[i].second;
            const auto [px, py] = cells[i - 1].second;
            QCOMPARE(std::abs(x - px) + std::abs(y - py), 1);
            if (i % 16 != 0)
                QVERIFY(x / 4 == px / 4 && y / 4 == py / 4);
        }
    }

    void orderIsAStableSort()
    {
        std::mt19937 random(3);
        const Rectangle domain{{-5, 10}, {3, 11}};
        std::vector<Point3> points;
        for (int i = 0; i < 3000; ++i)
            points.push_back({-5 + 8 * double(random() % 50) / 49, 10 + double(random() % 50) / 49, 0});
        for (int i = 0; i < 1000; ++i) // within the last 20 bits of a key, which are sorted apart
            points.push_back({double(random() % 1000) * 1e-8, 10.5 + double(random() % 1000) * 1e-8, 0});
        const std::vector<std::uint32_t> order = hilbertOrder(points, domain);
        const double scale = 4294967295.0 / 8;
        const auto key = [&](std::uint32_t i) {
            return hilbertIndex(std::uint32_t((points[i].x + 5) * scale), std::uint32_t((points[i].y - 10) * scale));
        };
        std::vector<std::uint32_t> expected(points.size());
        for (std::uint32_t i = 0; i < expected.size(); ++i)
            expected[i] = i;
        std::stable_sort(expected.begin(), expected.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
        QCOMPARE(order, expected);
    }
};

SANDREEL_TEST(TestHilbert)
#include "tst_hilbert.moc"
