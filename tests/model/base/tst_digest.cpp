// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/digest.h"
#include "tests/support/testmain.h"

#include <set>

using namespace model;

class TestDigest final : public QObject
{
    Q_OBJECT

    static std::vector<std::byte> pattern(std::size_t count)
    {
        std::vector<std::byte> bytes;
        for (std::size_t i = 0; i < count; ++i)
            bytes.push_back(std::byte(i * 7 + 3));
        return bytes;
    }

private slots:
    // Expected: what the xxHash library 0.8.1 computes for the same bytes.
    void isXxh64_data()
    {
        QTest::addColumn<int>("length");
        QTest::addColumn<quint64>("unseeded");
        QTest::addColumn<quint64>("seeded");
        QTest::newRow("0") << 0 << quint64(0xef46db3751d8e999) << quint64(0x51e24c0e9077a48c);
        QTest::newRow("1") << 1 << quint64(0x1f25c8d0bc1f4bb6) << quint64(0x20f9f4e3fba1be06);
        QTest::newRow("3") << 3 << quint64(0x31d2363f52e564c9) << quint64(0x076b77199119d7dd);
        QTest::newRow("4") << 4 << quint64(0x9bb64b7d66ee9fda) << quint64(0x27a7e5587a8a5c2e);
        QTest::newRow("7") << 7 << quint64(0x9a7b149959ce60d8) << quint64(0xcff13e1a810bec27);
        QTest::newRow("8") << 8 << quint64(0xdab99d95c6f90092) << quint64(0x841e06da64a07ce8);
        QTest::newRow("31") << 31 << quint64(0xa2aa5f33cc4a6119) << quint64(0x6ba872e910fbce5c);
        QTest::newRow("32") << 32 << quint64(0x23c3c17ef790fd97) << quint64(0x25cc07da699894a9);
        QTest::newRow("33") << 33 << quint64(0x50a7cfc7ba588784) << quint64(0xbf84912d4dea9670);
        QTest::newRow("63") << 63 << quint64(0x5e3e54b431c7493c) << quint64(0x737629700e723da5);
        QTest::newRow("64") << 64 << quint64(0x0eb64b3ef6eeb01f) << quint64(0xfded24eb11992703);
        QTest::newRow("100") << 100 << quint64(0xa61f8d4c170fe531) << quint64(0xfe1fce732c97c212);
    }
    void isXxh64()
    {
        QFETCH(int, length);
        QFETCH(quint64, unseeded);
        QFETCH(quint64, seeded);
        QCOMPARE(digestOf(pattern(std::size_t(length))), unseeded);
        QCOMPARE(digestOf(pattern(std::size_t(length)), 0x0123456789abcdef), seeded);
    }

    void everyBitMatters()
    {
        std::vector<std::byte> bytes = pattern(71);
        std::set<std::uint64_t> digests{digestOf(bytes)};
        for (std::byte &byte : bytes)
            for (int bit = 0; bit < 8; ++bit) {
                byte ^= std::byte(1 << bit);
                digests.insert(digestOf(bytes));
                byte ^= std::byte(1 << bit);
            }
        QCOMPARE(digests.size(), std::size_t(1 + 71 * 8));
    }

    void chainedArraysDoNotRunIntoEachOther()
    {
        const auto chained = [](std::vector<int> first, std::vector<int> second) {
            return digestOfArray(std::span<const int>(second), digestOfArray(std::span<const int>(first)));
        };
        const std::set<std::uint64_t> digests{chained({}, {1, 2}), chained({1}, {2}), chained({1, 2}, {}),
                                              chained({2}, {1})};
        QCOMPARE(digests.size(), std::size_t(4));
    }
};

SANDREEL_TEST(TestDigest)
#include "tst_digest.moc"
