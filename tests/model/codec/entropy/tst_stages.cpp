// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/entropy/bandstage.h"
#include "model/codec/entropy/indexstage.h"
#include "tests/model/codec/animations.h"
#include "tests/support/testmain.h"

#include <random>

using namespace model;
using namespace model::codec;

namespace {

Chunk chunkOf(std::span<const std::uint8_t> payload)
{
    return {"test", payload, 1000, payload.size(), 0};
}

Result<std::vector<std::int32_t>> decoded(const Bytes &payload, const Bands &shape)
{
    std::vector<std::int32_t> values(std::size_t(shape.rows) * shape.columns, 12345);
    const auto result = decodeBands(chunkOf(payload), shape, "rows", Progress(), [&](std::uint32_t r, auto row) {
        std::copy(row.begin(), row.end(), values.begin() + std::ptrdiff_t(std::size_t(r) * shape.columns));
    });
    if (!result)
        return fail(result.error());
    return values;
}

std::vector<std::int32_t> someValues(const Bands &shape, const std::string &kind)
{
    std::mt19937 random(11);
    std::vector<std::int32_t> values(std::size_t(shape.rows) * shape.columns);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = kind == "zero"       ? 0
                    : kind == "smooth"   ? std::int32_t(1000 * std::sin(0.01 * double(i)))
                    : kind == "noise"    ? std::int32_t(random() % 2001) - 1000
                    : (random() % 2 > 0) ? MaxBandValue
                                         : -MaxBandValue;
    return values;
}

} // namespace

class TestStages final : public QObject
{
    Q_OBJECT

private slots:
    void bands_data()
    {
        QTest::addColumn<int>("rows");
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("stride");
        QTest::addColumn<QString>("kind");
        for (const char *kind : {"zero", "smooth", "noise", "extreme"})
            for (const auto &[rows, columns, stride] :
                 {std::tuple{0, 5, 1}, {1, 1, 1}, {1, 3, 3}, {3, 300, 3}, {7, 20000, 1}, {2, 40000, 1}})
                QTest::addRow("%s %dx%d/%d", kind, rows, columns, stride) << rows << columns << stride << kind;
    }
    void bands()
    {
        QFETCH(int, rows);
        QFETCH(int, columns);
        QFETCH(int, stride);
        QFETCH(QString, kind);
        const Bands shape{std::uint32_t(rows), std::uint32_t(columns), std::uint32_t(stride)};
        const auto values = someValues(shape, kind.toStdString());
        const auto payload = encodeBands(shape, values, Progress());
        const auto result = decoded(*payload, shape);
        QVERIFY(result.has_value());
        QVERIFY(*result == values);
    }

    void damagedBandsAreRejected()
    {
        const Bands shape{3, 200, 1};
        const Bytes payload = *encodeBands(shape, someValues(shape, "noise"), Progress());
        for (std::size_t length = 0; length < payload.size(); ++length)
            QVERIFY(!decoded(Bytes(payload.begin(), payload.begin() + std::ptrdiff_t(length)), shape));
        Bytes longer = payload;
        longer.push_back(0);
        QCOMPARE(int(decoded(longer, shape).error().code), int(ErrorCode::TrailingBytes));
        Bytes noRows = payload;
        noRows[0] = 0;
        QCOMPARE(int(decoded(noRows, shape).error().code), int(ErrorCode::BadValue));
        QCOMPARE(decoded(noRows, shape).error().args.at(0), std::string("rows per stream"));
        // One row more than there is: the stream ends too early, and says which stage and where.
        const auto tooMany = decoded(payload, {4, 200, 1});
        QCOMPARE(int(tooMany.error().code), int(ErrorCode::CorruptStream));
        QCOMPARE(tooMany.error().args.at(0), std::string("rows"));
        QVERIFY(tooMany.error().offset > 1000);
        QCOMPARE(int(decoded(payload, {2, 200, 1}).error().code), int(ErrorCode::CorruptStream));
        // Far more: no bytes for the lengths, and nothing was allocated for them.
        Bytes hostile = payload;
        hostile[0] = 1;
        std::size_t calls = 0;
        const auto refused =
            decodeBands(chunkOf(hostile), {1u << 30, 1, 1}, "rows", Progress(), [&](std::uint32_t, auto) { ++calls; });
        QCOMPARE(int(refused.error().code), int(ErrorCode::BadValue));
        QCOMPARE(calls, std::size_t(0));
    }

    void valuesThatGrowWithoutBoundAreRefused()
    {
        // Two residuals of the largest size in one direction cannot come from values within the limit.
        const Bands shape{1, 2, 1};
        const Bytes payload = *encodeBands(
            shape, std::vector<std::int32_t>{MaxBandValue, std::numeric_limits<std::int32_t>::max()}, Progress());
        QCOMPARE(int(decoded(payload, shape).error().code), int(ErrorCode::CorruptStream));
    }

    void means()
    {
        std::vector<std::int64_t> values{0, -1, 5, MaxMeanValue, -MaxMeanValue, 7, -MaxMeanValue, MaxMeanValue, 8};
        const Bytes payload = encodeMeans(values);
        QVERIFY(*decodeMeans(chunkOf(payload), values.size()) == values);
        QCOMPARE(int(decodeMeans(chunkOf(payload), 6).error().code), int(ErrorCode::CorruptStream));
        QCOMPARE(int(decodeMeans(chunkOf(payload), 12).error().code), int(ErrorCode::CorruptStream));
        values.back() = MaxMeanValue + 1;
        QCOMPARE(int(decodeMeans(chunkOf(encodeMeans(values)), values.size()).error().code),
                 int(ErrorCode::CorruptStream));
    }

    void triangles_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {0, 1, 2, 1000, (1 << 14), (1 << 14) + 1, 40000})
            QTest::addRow("%d", count) << count;
    }
    void triangles()
    {
        QFETCH(int, count);
        std::mt19937 random(2);
        Connectivity connectivity{1u << 30, {}};
        for (int t = 0; t < count; ++t)
            connectivity.triangles.push_back(
                {std::uint32_t(random() % (1u << 30)), std::uint32_t(t), t % 2 ? 0u : (1u << 30) - 1});
        const Bytes payload = *encodeIndices(connectivity, Progress());
        const auto result = decodeIndices(chunkOf(payload), 1u << 30, std::uint32_t(count), Progress());
        QVERIFY(result.has_value());
        QVERIFY(*result == connectivity);
    }

    void damagedTrianglesAreRejected()
    {
        const Connectivity connectivity{40, tests::strip(40)};
        const Bytes payload = *encodeIndices(connectivity, Progress());
        for (std::size_t length = 0; length < payload.size(); ++length)
            QVERIFY(!decodeIndices(chunkOf(std::span(payload).first(length)), 40, 38, Progress()));
        // An index that no vertex has.
        const auto outside = decodeIndices(chunkOf(payload), 39, 38, Progress());
        QCOMPARE(int(outside.error().code), int(ErrorCode::CorruptStream));
        QCOMPARE(outside.error().args.at(0), std::string("connectivity"));
        Bytes small = payload;
        small[0] = 0;
        small[1] = 0;
        QCOMPARE(int(decodeIndices(chunkOf(small), 40, 38, Progress()).error().code), int(ErrorCode::BadValue));
    }
};

SANDREEL_TEST(TestStages)
#include "tst_stages.moc"
