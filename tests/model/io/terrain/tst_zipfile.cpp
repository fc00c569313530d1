// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/zipfile.h"
#include "tests/support/compareerror.h"
#include "tests/support/testmain.h"

#include <algorithm>

using namespace model;
using namespace model::io;

namespace {

constexpr std::uint64_t Plenty = 1 << 24;

Bytes bytesOf(std::string_view text)
{
    return {text.begin(), text.end()};
}

/// Every place where `from` stands becomes `to`: the local header and the directory alike.
Bytes replaced(Bytes zip, const Bytes &from, const Bytes &to)
{
    for (auto at = zip.begin(); (at = std::search(at, zip.end(), from.begin(), from.end())) != zip.end();)
        at = std::copy(to.begin(), to.end(), at);
    return zip;
}

Bytes littleEndian(std::uint32_t value)
{
    return {std::uint8_t(value), std::uint8_t(value >> 8), std::uint8_t(value >> 16), std::uint8_t(value >> 24)};
}

} // namespace

class TestZipFile final : public QObject
{
    Q_OBJECT

private slots:
    void entriesComeBackInTheirOrder()
    {
        const std::vector<ZipEntry> entries{
            {"b/second.bin", Bytes(5000, 7), true}, {"a.txt", bytesOf("text"), false}, {"empty", {}, false}};
        const auto zip = writeZip(entries);
        QVERIFY(zip && zip->size() < 1000);
        const auto read = readZip(*zip, Plenty);
        QVERIFY(read);
        QCOMPARE(read->size(), entries.size());
        for (std::size_t i = 0; i < entries.size(); ++i) {
            QCOMPARE((*read)[i].name, entries[i].name);
            QCOMPARE((*read)[i].bytes, entries[i].bytes);
        }
        QCOMPARE(*writeZip(entries), *zip);
    }
    void namesThatLeadAwayAreRefused_data()
    {
        QTest::addColumn<QByteArray>("name");
        for (const char *name : {"../xyz", "a/../b", "/abcde", "a\\bcde", "C:abcd", "a//bcd", "./abcd", "ab\tcde"})
            QTest::newRow(name) << QByteArray(name);
    }
    void namesThatLeadAwayAreRefused()
    {
        QFETCH(QByteArray, name);
        const Bytes good = *writeZip({{"abcdef", bytesOf("x"), false}});
        QVERIFY(readZip(good, Plenty));
        const auto read = readZip(replaced(good, bytesOf("abcdef"), bytesOf(name.toStdString())), Plenty);
        SANDREEL_COMPARE_ERROR(read, ErrorCode::BadValue);
        QCOMPARE(read.error().args[0], std::string("name of a part"));
        QCOMPARE(read.error().args[1], name.toStdString());
    }
    void twoOfOneNameAreRefused()
    {
        const Bytes two = *writeZip({{"first", bytesOf("1"), false}, {"other", bytesOf("2"), false}});
        QCOMPARE(readZip(two, Plenty)->size(), std::size_t(2));
        SANDREEL_COMPARE_ERROR(readZip(replaced(two, bytesOf("other"), bytesOf("first")), Plenty),
                               ErrorCode::CorruptStream);
    }
    /// What claims to unpack to more than deflate can make of it is refused before memory is taken.
    void sizesThatCannotBeAreRefused()
    {
        const Bytes zip = *writeZip({{"zeros", Bytes(1 << 20), true}});
        QCOMPARE(readZip(zip, Plenty)->front().bytes.size(), std::size_t(1 << 20));
        const auto read = readZip(replaced(zip, littleEndian(1 << 20), littleEndian(0x7fffff00)), ~std::uint64_t(0));
        SANDREEL_COMPARE_ERROR(read, ErrorCode::BadValue);
        QCOMPARE(read.error().args[0], std::string("unpacked size"));
        QCOMPARE(read.error().args[1], std::to_string(0x7fffff00));
    }
    void memoryOfAllEntriesTogetherIsLimited()
    {
        const Bytes zip = *writeZip({{"one", Bytes(600), false}, {"two", Bytes(600), false}});
        QVERIFY(readZip(zip, 1200));
        SANDREEL_COMPARE_ERROR(readZip(zip, 1199), ErrorCode::LimitExceeded);
    }
    void otherBytesThanWereWrittenAreNoticed()
    {
        const Bytes zip = *writeZip({{"text", bytesOf("what was written"), false}});
        const auto read = readZip(replaced(zip, bytesOf("what was"), bytesOf("that was")), Plenty);
        SANDREEL_COMPARE_ERROR(read, ErrorCode::ChecksumMismatch);
        QCOMPARE(read.error().args[0], std::string("text"));
    }
};

SANDREEL_TEST(TestZipFile)
#include "tst_zipfile.moc"
