// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/tiles/packing.h"
#include "tests/support/testmain.h"

#include <QTest>

#include <cmath>
#include <limits>

#include <zlib.h>

using namespace model;
using namespace model::io;

namespace {

Bytes packedOf(const Bytes &raw)
{
    ByteWriter out;
    writePacked(out, raw);
    return out.take();
}

/// A packed stream that says it is `packed` long.
Bytes streamOf(const Bytes &packed)
{
    ByteWriter out;
    out.varUint(packed.size());
    out.bytes(packed);
    return out.take();
}

Bytes deflated(const Bytes &raw)
{
    Bytes packed(compressBound(uLong(raw.size())));
    uLongf size = uLongf(packed.size());
    compress2(packed.data(), &size, raw.data(), uLong(raw.size()), 9);
    packed.resize(size);
    return packed;
}

} // namespace

class TestPacking final : public QObject
{
    Q_OBJECT

private slots:
    void bytesComeBack()
    {
        for (const Bytes &raw : {Bytes(), Bytes{1, 2, 3}, Bytes(10000, 5)}) {
            const Bytes packed = packedOf(raw);
            ByteReader in(packed);
            Bytes again;
            QVERIFY(readPacked(in, raw.size(), again));
            QCOMPARE(again, raw);
            QVERIFY(in.requireEnd());
        }
        QVERIFY(packedOf(Bytes(10000, 5)).size() < 100);
    }
    void streamsOfAnotherLengthAreRefused_data()
    {
        QTest::addColumn<Bytes>("stream");
        QTest::addColumn<int>("size");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("field");
        const Bytes thousand = deflated(Bytes(1000, 5));
        const auto bad = int(ErrorCode::BadValue), corrupt = int(ErrorCode::CorruptStream);
        QTest::newRow("longer than unpacked") << streamOf(Bytes(11)) << 10 << bad << "packed size";
        QTest::newRow("too small to be true") << streamOf(Bytes(9)) << 9 * 1032 + 1 << bad << "unpacked size";
        QTest::newRow("unpacks to more") << streamOf(thousand) << 999 << corrupt << "deflate";
        QTest::newRow("unpacks to less") << streamOf(thousand) << 1001 << corrupt << "deflate";
        Bytes longer = thousand;
        longer.push_back(0);
        QTest::newRow("bytes after its end") << streamOf(longer) << 1000 << corrupt << "deflate";
        QTest::newRow("no deflate") << streamOf(Bytes(20, 0xff)) << 1000 << corrupt << "deflate";
    }
    void streamsOfAnotherLengthAreRefused()
    {
        QFETCH(Bytes, stream);
        QFETCH(int, size);
        QFETCH(int, code);
        QFETCH(QString, field);
        ByteReader in(stream);
        Bytes raw;
        QVERIFY(!readPacked(in, std::size_t(size), raw));
        QCOMPARE(int(in.error().code), code);
        QCOMPARE(QString::fromStdString(in.error().args[0]), field);
    }
    void numbersKeepAllTheirBits()
    {
        const std::vector<double> numbers{0.25, -3, 1e300, -0.0, M_PI, 5e-324, 7, std::numeric_limits<double>::max()};
        const FixedPoint fixed = toFixedPoint(numbers, 0.25);
        ByteWriter out;
        writeFixedPoint(out, fixed);
        FixedPoint again;
        ByteReader in(out.data());
        QVERIFY(readFixedPoint(in, numbers.size(), again) && in.requireEnd());
        again.multiples = fixed.multiples;
        std::size_t next = 0;
        for (std::size_t i = 0; i < numbers.size(); ++i)
            QCOMPARE(std::bit_cast<std::uint64_t>(numberAt(again, i, next)), std::bit_cast<std::uint64_t>(numbers[i]));
    }
    /// The count and the bits that say which have to agree: memory is taken by the one, and filled by the other.
    void exceptionsAreCounted()
    {
        const auto stream = [](double unit, std::uint64_t count, std::uint8_t bits) {
            ByteWriter out;
            out.f64(unit);
            out.varUint(count);
            writePacked(out, Bytes{bits});
            for (int plane = 0; plane < 8; ++plane)
                writePacked(out, Bytes(count, 1));
            return out.take();
        };
        const auto read = [&](double unit, std::uint64_t count, std::uint8_t bits) {
            const Bytes bytes = stream(unit, count, bits);
            ByteReader in(bytes);
            FixedPoint numbers;
            return readFixedPoint(in, 8, numbers) ? std::string() : in.error().args[0];
        };
        QCOMPARE(read(1, 2, 0b101), std::string());
        QCOMPARE(read(1, 2, 0b111), std::string("exception count"));
        QCOMPARE(read(1, 2, 0b100), std::string("exception count"));
        QCOMPARE(read(1, 9, 0xff), std::string("exception count"));
        QCOMPARE(read(0, 2, 0b101), std::string("unit"));
        QCOMPARE(read(std::nan(""), 2, 0b101), std::string("unit"));
    }
};

SANDREEL_TEST(TestPacking)
#include "tst_packing.moc"
