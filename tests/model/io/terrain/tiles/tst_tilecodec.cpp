// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/io/terrain/tiles/packing.h"
#include "model/io/terrain/tiles/tilecodec.h"
#include "tests/model/io/terrain/terrains.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <limits>
#include <random>

using namespace model;
using namespace model::io;
using namespace model::terrain;

namespace {

Result<Terrain> thereAndBack(const Terrain &terrain, Point2 step = {}, Bytes *bytes = nullptr)
{
    std::vector<VertexId> ids;
    const auto encoded = encodeSurface(terrain.tin.arrays(), terrain.tin.domain(), step, &ids);
    if (bytes)
        *bytes = *encoded;
    auto decoded = decodeSurface(*encoded, ~std::uint64_t(0));
    if (!decoded)
        return fail(decoded.error());
    std::vector<ConstrainedEdge> edges = constrainedEdges(terrain.tin.arrays());
    for (ConstrainedEdge &edge : edges)
        edge = {ids[edge.a], ids[edge.b], edge.owner};
    decoded->arrays.totals.ledger = terrain.tin.ledger();
    for (std::uint32_t l = 0; l < MaxLayers; ++l)
        decoded->arrays.totals.compacted[l] = terrain.tin.arrays().totals.compacted[l];
    auto tin = restoreTin(std::move(decoded->arrays), decoded->domain, edges, LedgerStart::Kept);
    if (!tin)
        return fail(tin.error());
    Terrain result(std::move(*tin));
    result.materials = terrain.materials;
    result.geoReference = terrain.geoReference;
    return result;
}

} // namespace

class TestTileCodec final : public QObject
{
    Q_OBJECT

private slots:
    void losesNothing_data()
    {
        QTest::addColumn<int>("ground");
        for (const tests::Ground ground : tests::EveryGround)
            QTest::newRow(tests::nameOf(ground)) << int(ground);
    }
    void losesNothing()
    {
        QFETCH(int, ground);
        for (unsigned seed = 1; seed < 6; ++seed)
            for (const int points : {0, 1, 20, 400}) {
                const Terrain terrain = tests::specimenTerrain(tests::Ground(ground), seed, points);
                const auto back = thereAndBack(terrain);
                QVERIFY2(back.has_value(), back ? "" : back.error().args[0].c_str());
                QCOMPARE(tests::describe(*back), tests::describe(terrain));
            }
    }

    void twoTriangles()
    {
        const Terrain terrain = tests::plainTerrain();
        const auto back = thereAndBack(terrain);
        QVERIFY(back.has_value());
        QCOMPARE(tests::describe(*back), tests::describe(terrain));
    }

    /// More than one tile; as many bytes as promised; the same with any number of threads.
    void manyTiles()
    {
        constexpr int Side = 300;
        std::mt19937 random(4);
        std::vector<Point3> points;
        for (int i = 0; i < Side * Side; ++i) {
            const double x = double(random() % (Side * 1024)) / 1024, y = double(random() % (Side * 1024)) / 1024;
            points.push_back({x, y, std::nearbyint(1024 * (20 * std::sin(x * 0.02) * std::cos(y * 0.03))) / 1024});
        }
        const Terrain terrain(buildTin(points, {{0, 0}, {Side, Side}})->tin);
        Bytes bytes, again;
        const auto back = thereAndBack(terrain, {}, &bytes);
        QVERIFY(back.has_value());
        QCOMPARE(tests::describe(*back), tests::describe(terrain));
        QVERIFY2(double(bytes.size()) < 5.5 * terrain.tin.vertexCount(), QByteArray::number(bytes.size()).constData());
        setThreadCount(1);
        QVERIFY(thereAndBack(terrain, {}, &again).has_value());
        setThreadCount(0);
        QVERIFY(bytes == again);
    }

    /// Any finite doubles, those that are multiples of nothing and of everything.
    void fixedPointIsLossless()
    {
        const double large = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
        std::mt19937_64 random(3);
        std::vector<double> wild;
        while (wild.size() < 500) {
            const double value = std::bit_cast<double>(random());
            if (std::isfinite(value))
                wild.push_back(value);
        }
        std::vector<double> steps;
        for (int i = 0; i < 100; ++i)
            steps.push_back(i % 7 == 6 ? 0.1 + i : i * 0.3);
        for (const std::vector<double> &numbers : {std::vector<double>{},
                                                   {0.0},
                                                   {-0.0},
                                                   {1, -1, 0.5},
                                                   {large, -large, tiny, -tiny, 0},
                                                   {1e300, 1e-300},
                                                   {5'500'000.25, 5'500'000.5},
                                                   wild,
                                                   steps})
            for (const double base : {1.0, 0.3, 1e-5}) {
                const FixedPoint fixed = toFixedPoint(numbers, base);
                ByteWriter out;
                writeFixedPoint(out, fixed);
                ByteReader in(out.data());
                FixedPoint read;
                QVERIFY(readFixedPoint(in, numbers.size(), read));
                QVERIFY(in.requireEnd());
                read.multiples = fixed.multiples;
                std::size_t next = 0;
                for (std::size_t i = 0; i < numbers.size(); ++i)
                    QCOMPARE(std::bit_cast<std::uint64_t>(numberAt(read, i, next)),
                             std::bit_cast<std::uint64_t>(numbers[i]));
            }
        // What lies on a raster costs nothing extra.
        steps.clear();
        for (int i = 0; i < 100; ++i)
            steps.push_back(double(i) * 0.3);
        QVERIFY(toFixedPoint(steps, 0.3).exceptions.empty());
    }

    void everyPrefixIsRejected()
    {
        const Terrain terrain = tests::specimenTerrain(tests::Ground::Random, 2, 60);
        const Bytes bytes = *encodeSurface(terrain.tin.arrays(), terrain.tin.domain(), {});
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            const std::vector<std::uint8_t> prefix(bytes.begin(), bytes.begin() + std::ptrdiff_t(size));
            QVERIFY(!decodeSurface(prefix, 1 << 26).has_value());
        }
        Bytes longer = bytes;
        longer.push_back(0);
        SANDREEL_COMPARE_ERROR(decodeSurface(longer, 1 << 26), ErrorCode::BadValue);
    }

    /// Every bit turned over is an error, or another terrain that is sound.
    void noFlippedBitBreaksAnything()
    {
        const Terrain terrain = tests::specimenTerrain(tests::Ground::Random, 3, 40);
        std::vector<VertexId> fileIds;
        const Bytes bytes = *encodeSurface(terrain.tin.arrays(), terrain.tin.domain(), {}, &fileIds);
        std::vector<ConstrainedEdge> edges = constrainedEdges(terrain.tin.arrays());
        for (ConstrainedEdge &edge : edges)
            edge = {fileIds[edge.a], fileIds[edge.b], edge.owner};
        int accepted = 0, tried = 0;
        for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += 3, ++tried) {
            Bytes broken = bytes;
            broken[bit / 8] = std::uint8_t(broken[bit / 8] ^ 1 << bit % 8);
            auto decoded = decodeSurface(broken, 1 << 24);
            if (decoded)
                accepted += restoreTin(std::move(decoded->arrays), decoded->domain, edges).has_value();
        }
        // A bit of a height or a layer makes another terrain; most of a place or a triangle make none.
        QVERIFY2(accepted > tried / 10 && accepted < tried - tried / 10,
                 qPrintable(QStringLiteral("%1 of %2").arg(accepted).arg(tried)));
    }

    void countsAreCheckedBeforeMemoryIsTaken()
    {
        const Terrain terrain = tests::specimenTerrain(tests::Ground::Random, 2, 60);
        const Bytes bytes = *encodeSurface(terrain.tin.arrays(), terrain.tin.domain(), {});
        SANDREEL_COMPARE_ERROR(decodeSurface(bytes, 1000), ErrorCode::LimitExceeded);
        QCOMPARE(decodeSurface(bytes, 1000).error().args[0], std::string("memory"));
        const Progress progress;
        progress.cancel();
        SANDREEL_COMPARE_ERROR(decodeSurface(bytes, 1 << 26, progress), ErrorCode::Cancelled);
        SANDREEL_COMPARE_ERROR(encodeSurface(terrain.tin.arrays(), terrain.tin.domain(), {}, nullptr, progress),
                               ErrorCode::Cancelled);
    }
};

SANDREEL_TEST(TestTileCodec)
#include "tst_tilecodec.moc"
