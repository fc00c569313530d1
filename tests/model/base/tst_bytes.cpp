// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/bytes.h"
#include "tests/support/testmain.h"

#include <limits>

using namespace model;

class TestBytes final : public QObject
{
    Q_OBJECT

private slots:
    void numbersAreLittleEndian()
    {
        ByteWriter writer;
        writer.u8(0x01);
        writer.u16(0x0302);
        writer.u32(0x07060504);
        writer.u64(0x0f0e0d0c0b0a0908);
        Bytes expected;
        for (std::uint8_t i = 1; i <= 15; ++i)
            expected.push_back(i);
        QVERIFY(writer.data() == expected);

        ByteReader reader(writer.data());
        QCOMPARE(reader.u8(), 0x01);
        QCOMPARE(reader.u16(), 0x0302);
        QCOMPARE(reader.u32(), 0x07060504u);
        QCOMPARE(reader.u64(), quint64(0x0f0e0d0c0b0a0908));
        QVERIFY(reader.requireEnd());
    }

    void varintsAreLeb128_data()
    {
        QTest::addColumn<quint64>("value");
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("0") << quint64(0) << QByteArray::fromHex("00");
        QTest::newRow("127") << quint64(127) << QByteArray::fromHex("7f");
        QTest::newRow("128") << quint64(128) << QByteArray::fromHex("8001");
        QTest::newRow("300") << quint64(300) << QByteArray::fromHex("ac02");
        QTest::newRow("max") << std::numeric_limits<quint64>::max() << QByteArray::fromHex("ffffffffffffffffff01");
    }
    void varintsAreLeb128()
    {
        QFETCH(quint64, value);
        QFETCH(QByteArray, bytes);
        ByteWriter writer;
        writer.varUint(value);
        QCOMPARE(QByteArray(reinterpret_cast<const char *>(writer.data().data()), qsizetype(writer.data().size())),
                 bytes);
        ByteReader reader(writer.data());
        QCOMPARE(reader.varUint(), value);
        QVERIFY(reader.requireEnd());
    }

    void varintBeyond64BitsIsRefused()
    {
        const Bytes bytes{0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x02};
        ByteReader reader(bytes);
        QCOMPARE(reader.varUint(), quint64(0));
        QCOMPARE(int(reader.error().code), int(ErrorCode::BadValue));
    }

    void everyPrefixIsRejected()
    {
        ByteWriter writer;
        writer.f64(2.5);
        writer.text("mesh");
        for (std::size_t length = 0; length < writer.data().size(); ++length) {
            const Bytes prefix(writer.data().begin(), writer.data().begin() + std::ptrdiff_t(length));
            ByteReader reader(prefix, 100);
            reader.f64();
            reader.text(10);
            QVERIFY(!reader.ok());
            QCOMPARE(int(reader.error().code), int(ErrorCode::Truncated));
            QVERIFY(reader.error().offset >= 100 && reader.error().offset <= 100 + length);
        }
    }

    void firstErrorStays()
    {
        const Bytes bytes{5};
        ByteReader reader(bytes);
        QVERIFY(!reader.require(reader.u8() == 4, "count", 5, "4"));
        reader.u64();
        QCOMPARE(int(reader.error().code), int(ErrorCode::BadValue));
        QCOMPARE(reader.error().offset, std::uint64_t(1));
        QCOMPARE(reader.left(), std::size_t(0));
    }

    void textLongerThanAllowedIsRefused()
    {
        ByteWriter writer;
        writer.text("mesh");
        ByteReader reader(writer.data());
        QVERIFY(reader.text(3).empty());
        QCOMPARE(int(reader.error().code), int(ErrorCode::BadValue));
    }

    void bytesLeftOverAreRefused()
    {
        const Bytes bytes{1, 2};
        ByteReader reader(bytes);
        reader.u8();
        QVERIFY(!reader.requireEnd());
        QCOMPARE(int(reader.error().code), int(ErrorCode::TrailingBytes));
    }
};

SANDREEL_TEST(TestBytes)
#include "tst_bytes.moc"
