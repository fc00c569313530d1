// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/connectivity/vertexorder.h"
#include "tests/support/rows.h"
#include "tests/support/surfaces.h"
#include "tests/support/testmain.h"

#include <numeric>
#include <random>

using namespace model;
using namespace model::codec;
using namespace tests;

namespace {

Result<std::vector<std::uint32_t>> decoded(const Bytes &bytes, std::span<const VertexNeighbours> neighbours)
{
    return decodeVertexOrder({"ORDR", bytes, 500, bytes.size(), 0}, neighbours);
}

std::vector<std::uint32_t> randomOrder(std::size_t count)
{
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::mt19937 random(5);
    for (std::size_t i = count; i > 1; --i)
        std::swap(order[i - 1], order[random() % i]);
    return order;
}

double bitsPerVertex(std::span<const std::uint32_t> order, std::span<const VertexNeighbours> neighbours)
{
    return 8.0 * double(encodeVertexOrder(order, neighbours).size()) / double(order.size());
}

} // namespace

class TestVertexOrder final : public QObject
{
    Q_OBJECT

private slots:
    void everySurface_data() { tests::addRows(namedSurfaces()); }
    void everySurface()
    {
        QFETCH(int, row);
        const auto encoded = encodeConnectivity(namedSurfaces()[std::size_t(row)].mesh, Progress());
        const auto &neighbours = encoded->coded.neighbours;
        std::vector<std::uint32_t> backwards(neighbours.size());
        std::iota(backwards.rbegin(), backwards.rend(), 0u);
        for (const auto &order : {encoded->permutation, backwards, randomOrder(neighbours.size())}) {
            const auto result = decoded(encodeVertexOrder(order, neighbours), neighbours);
            QVERIFY(result.has_value());
            QVERIFY(*result == order);
        }
    }

    void anOrderAlongRowsCostsLittle()
    {
        const auto encoded = encodeConnectivity(sheet(60, 60), Progress());
        QVERIFY(bitsPerVertex(encoded->permutation, encoded->coded.neighbours) < 1);
    }

    /// A random order has log2(V!) bits, 1.44 a vertex less than log2(V).
    void aRandomOrderCostsLittleMoreThanItMust()
    {
        const auto encoded = encodeConnectivity(sheet(99, 99), Progress());
        const std::vector<std::uint32_t> order = randomOrder(10000);
        const double least = std::log2(10000.0) - std::log2(std::exp(1.0));
        QVERIFY(bitsPerVertex(order, encoded->coded.neighbours) < least + 1);
    }

    void damagedOrdersAreRejectedOrWhole()
    {
        const auto encoded = encodeConnectivity(withRandomHoles(sheet(12, 12), 7), Progress());
        const auto &neighbours = encoded->coded.neighbours;
        const Bytes bytes = encodeVertexOrder(encoded->permutation, neighbours);
        std::size_t rejected = 0;
        const auto check = [&](const Bytes &damaged) {
            auto result = decoded(damaged, neighbours);
            if (!result) {
                ++rejected;
                QCOMPARE(result.error().code, ErrorCode::CorruptStream);
                QCOMPARE(result.error().args, std::vector<std::string>{"vertex order"});
                QCOMPARE(result.error().offset, std::uint64_t(500));
                return;
            }
            std::sort(result->begin(), result->end());
            for (std::uint32_t i = 0; i < result->size(); ++i)
                QCOMPARE((*result)[i], i);
        };
        for (std::size_t length = 0; length < bytes.size(); ++length)
            check(Bytes(bytes.begin(), bytes.begin() + std::ptrdiff_t(length)));
        QVERIFY(rejected + 1 >= bytes.size());
        for (std::size_t at = 0; at < bytes.size(); ++at)
            for (const std::uint8_t mask : {0x01, 0x80, 0xff}) {
                Bytes damaged = bytes;
                damaged[at] ^= mask;
                check(damaged);
            }
        Bytes longer = bytes;
        longer.push_back(1);
        check(longer);
    }
};

SANDREEL_TEST(TestVertexOrder)
#include "tst_vertexorder.moc"
