// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/analysis/matching.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <random>

using namespace model;

class TestMatching final : public QObject
{
    Q_OBJECT

    using Graph = std::vector<std::vector<std::uint32_t>>;

    /// The most pairs, by trying all: each of the first free node's neighbours, or none.
    static int most(const Graph &graph, std::uint32_t free)
    {
        if (free == 0)
            return 0;
        const auto first = std::uint32_t(std::countr_zero(free));
        int best = most(graph, free & ~(1u << first));
        for (const std::uint32_t to : graph[first])
            if (free >> to & 1 && to != first)
                best = std::max(best, 1 + most(graph, free & ~(1u << first) & ~(1u << to)));
        return best;
    }

private slots:
    void asManyPairsAsThereCanBe()
    {
        std::mt19937 random(3);
        for (int round = 0; round < 400; ++round) {
            const std::uint32_t count = 1 + random() % 11;
            Graph graph(count);
            for (std::uint32_t a = 0; a < count; ++a)
                for (std::uint32_t b = a + 1; b < count; ++b)
                    if (random() % count < 2) {
                        graph[a].push_back(b);
                        graph[b].push_back(a);
                    }
            const auto partner = maximumMatching(graph);
            int pairs = 0;
            for (std::uint32_t v = 0; v < count; ++v) {
                if (partner[v] == NoPartner)
                    continue;
                QCOMPARE(partner[partner[v]], v);
                QVERIFY(std::find(graph[v].begin(), graph[v].end(), partner[v]) != graph[v].end());
                ++pairs;
            }
            QCOMPARE(pairs / 2, most(graph, (1u << count) - 1));
        }
    }

    void preferredNeighboursComeFirst()
    {
        QVERIFY(maximumMatching({{2, 1}, {0, 3}, {0}, {1}}) == (std::vector<std::uint32_t>{2, 3, 0, 1}));
    }
};

SANDREEL_TEST(TestMatching)
#include "tst_matching.moc"
