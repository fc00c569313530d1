// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/animationcodec.h"
#include "model/codec/reel/clusters.h"
#include "model/codec/trialencoder.h"
#include "tests/model/codec/animations.h"
#include "tests/model/codec/filesurgery.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <random>

using namespace model;
using namespace model::codec;

namespace {

CoarseToFine nodesOfFlock(std::uint32_t bodies, std::uint32_t vertices)
{
    return *coarseToFine(tests::flock(1, bodies, vertices).connectivity(), Progress());
}

/// Coefficients of components of 50 vertices each, on 8 trajectories; component c moves along those of `bases[c]`.
Eigen::MatrixXd moving(const std::vector<std::vector<int>> &bases, double size)
{
    std::mt19937 random(5);
    Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(8, Eigen::Index(50 * bases.size()));
    for (std::size_t c = 0; c < bases.size(); ++c)
        for (int v = 0; v < 50; ++v)
            for (const int k : bases[c])
                coefficients(k, Eigen::Index(50 * c) + v) = size * (double(random() % 2001) / 1000 - 1);
    return coefficients;
}

std::vector<std::uint32_t> componentsOfFifty(std::size_t count)
{
    std::vector<std::uint32_t> components;
    for (std::size_t v = 0; v < 50 * count; ++v)
        components.push_back(std::uint32_t(v / 50));
    return components;
}

bool hasParts(const Bytes &file)
{
    return std::ranges::any_of(tests::takeApart(file), [](const auto &chunk) { return chunk.first == "PART"; });
}

} // namespace

class TestClusters final : public QObject
{
    Q_OBJECT

private slots:
    void componentsAreThoseOfTheMesh()
    {
        const CoarseToFine nodes = nodesOfFlock(5, 13);
        const std::vector<std::uint32_t> components = componentsOf(nodes);
        QCOMPARE(components.size(), std::size_t(65));
        std::vector<std::uint32_t> numberOfBody(5, ~0u);
        std::uint32_t seen = 0;
        for (std::size_t node = 0; node < components.size(); ++node) {
            std::uint32_t &number = numberOfBody[nodes.vertices[node] / 13];
            if (number == ~0u)
                number = seen++;
            QCOMPARE(components[node], number);
        }
        QCOMPARE(seen, 5u);
    }

    void restrictedOrdersHaveTheirOwnNodesOnly()
    {
        const CoarseToFine nodes = nodesOfFlock(4, 40);
        std::vector<std::uint32_t> members; // bodies 1 and 3
        for (std::uint32_t node = 0; node < nodes.size(); ++node)
            if (nodes.vertices[node] / 40 % 2 == 1)
                members.push_back(node);
        const CoarseToFine own = restrictedTo(nodes, members);
        QCOMPARE(own.size(), std::size_t(80));
        QCOMPARE(own.finest, nodes.finest);
        const auto expect = [&](const NodeLists &ownLists, const NodeLists &lists, std::uint32_t i) {
            std::vector<std::uint32_t> expected;
            for (const std::uint32_t other : lists[members[i]])
                if (const auto at = std::ranges::find(members, other); at != members.end())
                    expected.push_back(std::uint32_t(at - members.begin()));
            return std::ranges::equal(ownLists[i], expected);
        };
        for (std::uint32_t i = 0; i < members.size(); ++i) {
            QCOMPARE(own.vertices[i], nodes.vertices[members[i]]);
            QCOMPARE(own.levels[i], nodes.levels[members[i]]);
            QVERIFY(expect(own.known, nodes.known, i) && expect(own.ring, nodes.ring, i) &&
                    expect(own.adjacent, nodes.adjacent, i));
            QCOMPARE(own.lengths[i].size(), own.known[i].size());
            QCOMPARE(own.ringLengths[i].size(), own.ring[i].size());
            // Nothing but nodes of other parts is gone.
            if (i > 0 && nodes.ring[members[i]].size() > 0)
                QVERIFY(own.known[i].size() == nodes.known[members[i]].size());
        }
    }

    void whatMovesAlikeIsTogether()
    {
        // 0 and 2 move along the same trajectories, 1 along others.
        const Eigen::MatrixXd apart = moving({{0, 1, 2}, {5, 6, 7}, {0, 1, 2}}, 10);
        QVERIFY(*clustersOf(apart, componentsOfFifty(3), 30, 0.1, Progress()) == (Clusters{2, {0, 1, 0}}));
        // Too little to be worth trajectories of its own.
        QVERIFY(*clustersOf(apart, componentsOfFifty(3), 30, 1000, Progress()) == (Clusters{1, {0, 0, 0}}));
        const Eigen::MatrixXd alike = moving({{0, 1, 2}, {0, 1, 2}, {0, 1, 2}}, 10);
        QVERIFY(*clustersOf(alike, componentsOfFifty(3), 30, 0.1, Progress()) == (Clusters{1, {0, 0, 0}}));
    }

    void familiesThatOverlapStayApart()
    {
        // They share one trajectory, and a family joins its own members first: what it then costs to take in the other
        // family depends on how many vertices it has by now.
        for (const auto &[own, others, size] : {std::tuple{2, 3, 1.0}, std::tuple{4, 3, 1.0}, std::tuple{1, 3, 1.5}}) {
            std::vector<std::vector<int>> bases(std::size_t(own), {0, 1, 2});
            bases.insert(bases.end(), std::size_t(others), {2, 3});
            std::vector<std::uint32_t> expected(std::size_t(own), 0);
            expected.insert(expected.end(), std::size_t(others), 1);
            QVERIFY(*clustersOf(moving(bases, size), componentsOfFifty(bases.size()), 80, 0.1, Progress()) ==
                    (Clusters{2, expected}));
        }
    }

    void clustersAreNumberedAsTheyCome()
    {
        // What moves most is not the first component.
        Eigen::MatrixXd coefficients = moving({{0, 1}, {2, 3}, {4, 5}, {2, 3}}, 10);
        coefficients.rightCols(50) *= 5;
        QVERIFY(*clustersOf(coefficients, componentsOfFifty(4), 12, 0.1, Progress()) == (Clusters{3, {0, 1, 2, 1}}));
    }

    void manyComponentsJoinFewGroups()
    {
        std::vector<std::vector<int>> bases;
        for (int c = 0; c < 90; ++c)
            bases.push_back({c % 4, 4 + c % 4});
        const Clusters clusters = *clustersOf(moving(bases, 10), componentsOfFifty(90), 30, 0.1, Progress());
        QCOMPARE(clusters.count, 4u);
        for (std::size_t c = 0; c < 90; ++c)
            QCOMPARE(clusters.labels[c], std::uint32_t(c % 4));
    }

    void aFlockIsSplitAndComesBack()
    {
        const auto source = tests::flock(40, 6, 150);
        const CompressionSettings settings{ReelSettings{0.002, 0}};
        const auto encoded = encodeAnimation(source, settings);
        QVERIFY(encoded.has_value());
        QVERIFY(hasParts(encoded->bytes));
        const auto decoded = decodeAnimation(encoded->bytes);
        QVERIFY(decoded.has_value());
        // The encoder knows the error, so every coefficient is where it meant it to be.
        auto trials = prepareTrials(source, CodecId::Reel, Progress());
        const auto trial = (*trials)->attempt(settings.method, Progress());
        const double error = tests::kgErrorPercent(tests::reordered(source, encoded->permutation), **decoded);
        QVERIFY2(std::fabs(error - trial->kgErrorPercent) < 0.002 * error,
                 qPrintable(QString("%1 %2").arg(error).arg(trial->kgErrorPercent)));
        QVERIFY(error < 0.5);
        QCOMPARE(trial->bytes, std::uint64_t(encoded->bytes.size()));
    }

    void oneBodyIsNotSplit()
    {
        QVERIFY(!hasParts(encodeAnimation(tests::waves(20, 200, 6), {ReelSettings{0.002, 0}})->bytes));
        // Nor are bodies that move as one.
        const auto one = tests::waves(20, 100, 6);
        std::vector<Triangle> triangles = tests::strip(100);
        for (const Triangle &t : tests::strip(100))
            triangles.push_back({t[0] + 100, t[1] + 100, t[2] + 100});
        const tests::PlainAnimation two(20, 200, triangles, [&](std::uint32_t f, std::uint32_t v) {
            return one.frame(f)[v % 100] + Vec3f{float(v / 100), 0, 0};
        });
        QVERIFY(!hasParts(encodeAnimation(two, {ReelSettings{0.002, 0}})->bytes));
    }

    void stepsInAnyOrderGiveTheSameFile()
    {
        // Trials keep what they found for one set of clusters.
        const auto source = tests::flock(30, 5, 80);
        auto trials = prepareTrials(source, CodecId::Reel, Progress());
        const CompressionSettings fine{ReelSettings{0.001, 0}}, coarse{ReelSettings{0.05, 0}};
        const auto first = (*trials)->encode(fine, Progress());
        const auto other = (*trials)->encode(coarse, Progress());
        const auto again = (*trials)->encode(fine, Progress());
        QVERIFY(first->bytes == again->bytes);
        QVERIFY(other->bytes == encodeAnimation(source, coarse)->bytes);
    }

    void hostileClustersAreNamed()
    {
        const Bytes good = encodeAnimation(tests::flock(40, 6, 150), {ReelSettings{0.002, 0}})->bytes;
        const auto errorOf = [](const Bytes &file) {
            const auto decoded = decodeAnimation(file);
            return decoded ? std::string() : decoded.error().args.at(0);
        };
        // A label that names no cluster; a stream that goes on; one that ends early.
        RangeEncoder coder;
        coder.direct(6, 2);
        ClusterLabelCoder labels(3);
        labels.code(coder, 3);
        const Bytes stream = coder.finish();
        QCOMPARE(errorOf(tests::withPayload(good, "PART", [&](Bytes &p) { p = stream; })), std::string("clusters"));
        QCOMPARE(errorOf(tests::withPayload(good, "PART", [](Bytes &p) { p.push_back(1); })), std::string("clusters"));
        QCOMPARE(errorOf(tests::withPayload(good, "PART", [](Bytes &p) { p.clear(); })), std::string("clusters"));
        // One cluster less than the trajectories need.
        RangeEncoder fewer;
        Clusters two{2, {0, 0, 0, 0, 0, 1}};
        QVERIFY(codeClusters(fewer, two, 6));
        const Bytes twoStream = fewer.finish();
        QVERIFY(!errorOf(tests::withPayload(good, "PART", [&](Bytes &p) { p = twoStream; })).empty());
    }
};

SANDREEL_TEST(TestClusters)
#include "tst_clusters.moc"
