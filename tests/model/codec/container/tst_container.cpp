// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/animationcodec.h"
#include "model/codec/container/container.h"
#include "model/codec/container/crc32.h"
#include "tests/model/codec/filesurgery.h"
#include "tests/support/testmain.h"

#include <zlib.h>

#include <algorithm>

using namespace model;
using namespace model::codec;

namespace {

ErrorCode codeOf(const Bytes &file)
{
    const auto decoded = decodeAnimation(file);
    return decoded ? ErrorCode(0xffff) : decoded.error().code;
}
const ErrorCode NoError = ErrorCode(0xffff);

/// HEAD of tests::smallFile(): version, features, codec, V, T, F take one byte each.
enum HeaderByte { Major, Minor, Features, Codec, Vertices, Triangles, Frames, Rate };

} // namespace

class TestContainer final : public QObject
{
    Q_OBJECT

private slots:
    void checksumIsZlibs()
    {
        Bytes data;
        for (unsigned i = 0; i < 1000; ++i) {
            QCOMPARE(model::codec::crc32(data), std::uint32_t(::crc32(0, data.data(), uInt(data.size()))));
            data.push_back(std::uint8_t(i * i + 17));
        }
        const std::uint32_t half = model::codec::crc32(std::span(data).first(333));
        QCOMPARE(model::codec::crc32(std::span(data).subspan(333), half), model::codec::crc32(data));
    }

    void surgeryKeepsTheFile()
    {
        const Bytes file = tests::smallFile();
        QVERIFY(tests::putTogether(tests::takeApart(file)) == file);
        QCOMPARE(codeOf(file), NoError);
    }

    void everyPrefixIsRejected()
    {
        const Bytes file = tests::smallFile();
        for (std::size_t length = 0; length < file.size(); ++length) {
            const Bytes prefix(file.begin(), file.begin() + std::ptrdiff_t(length));
            const ErrorCode code = codeOf(prefix);
            QVERIFY2(code == (length == 0 ? ErrorCode::BadMagic : ErrorCode::Truncated),
                     qPrintable(QString::number(length)));
        }
    }

    void prefixesComeApart()
    {
        const Bytes file = tests::smallFile();
        const auto whole = readContainer(file);
        ContainerReader reader;
        QVERIFY(reader.append({}).has_value() && !reader.header() && !reader.cut());
        for (std::size_t length = 1; length <= file.size(); ++length) {
            QVERIFY(reader.append(std::span(file).subspan(length - 1, 1)).has_value());
            // Whole chunks, as readContainer() finds them in the whole file.
            std::size_t count = 0;
            while (count < whole->chunks.size() &&
                   whole->chunks[count].offset + whole->chunks[count].payload.size() + CrcLength <= length)
                ++count;
            QCOMPARE(reader.chunkCount(), count);
            QCOMPARE(reader.header() != nullptr, count > 0);
            for (std::size_t i = 0; i < count; ++i) {
                QCOMPARE(reader.chunk(i).tag, whole->chunks[i].tag);
                QCOMPARE(reader.chunk(i).offset, whole->chunks[i].offset);
                QCOMPARE(reader.chunk(i).crc, whole->chunks[i].crc);
                QCOMPARE(reader.chunk(i).size, whole->chunks[i].size);
                QVERIFY(std::ranges::equal(reader.chunk(i).payload, whole->chunks[i].payload));
            }
            QCOMPARE(reader.isComplete(), length == file.size());
            QVERIFY(reader.leastBytes() <= file.size());
            QVERIFY(reader.leastBytes() > length || reader.isComplete());
            const auto cut = reader.cut();
            const bool hasStart = count < whole->chunks.size() && length >= whole->chunks[count].offset;
            QCOMPARE(cut.has_value(), hasStart);
            if (hasStart) {
                const Chunk &chunk = whole->chunks[count];
                QCOMPARE(cut->tag, chunk.tag);
                QCOMPARE(cut->length, std::uint64_t(chunk.payload.size()));
                QCOMPARE(cut->offset, chunk.offset);
                const std::size_t there = std::min<std::size_t>(length - chunk.offset, chunk.payload.size());
                QVERIFY(std::ranges::equal(cut->payload, chunk.payload.first(there)));
            }
        }
        QCOMPARE(reader.leastBytes(), std::uint64_t(file.size()));
        QCOMPARE(reader.header()->name, whole->header.name);
        QVERIFY(reader.file() == file);
        const Bytes one{0};
        QCOMPARE(int(reader.append(one).error().code), int(ErrorCode::TrailingBytes));
    }

    void everyFlippedBitIsNoticed()
    {
        const Bytes file = tests::smallFile();
        for (std::size_t i = 0; i < file.size(); ++i)
            for (unsigned bit = 0; bit < 8; ++bit) {
                Bytes damaged = file;
                damaged[i] ^= std::uint8_t(1u << bit);
                const auto decoded = decodeAnimation(damaged);
                QVERIFY2(!decoded, qPrintable(QString::number(i)));
                QVERIFY(decoded.error().code != ErrorCode::LimitExceeded);
            }
    }

    void oneMoreByteIsRefused()
    {
        Bytes file = tests::smallFile();
        file.push_back(0);
        QCOMPARE(codeOf(file), ErrorCode::TrailingBytes);
        QCOMPARE(codeOf(tests::withPayload(tests::smallFile(), "TAIL", [](Bytes &p) { p.push_back(0); })),
                 ErrorCode::TrailingBytes);
    }

    void textModeDamageIsSeen()
    {
        Bytes file = tests::smallFile();
        file.erase(file.begin() + 4); // CR LF became LF
        QCOMPARE(codeOf(file), ErrorCode::BadMagic);
    }

    void corruptedHeaderFieldsHaveTheirErrors_data()
    {
        QTest::addColumn<int>("at");
        QTest::addColumn<int>("value");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("field");
        const auto bad = [](int at, int value, ErrorCode code, const char *field) {
            QTest::addRow("%d = %d", at, value) << at << value << int(code) << field;
        };
        bad(Major, 2, ErrorCode::UnsupportedVersion, "2.0");
        bad(Major, 0, ErrorCode::BadValue, "format version");
        bad(Features, 1, ErrorCode::UnsupportedFeature, "feature bits 1");
        bad(Codec, 0, ErrorCode::UnknownCodec, "0");
        bad(Codec, 77, ErrorCode::UnknownCodec, "77");
        bad(Vertices, 0, ErrorCode::BadValue, "vertex count");
        bad(Frames, 0, ErrorCode::BadValue, "frame count");
        bad(Rate + 7, 0xff, ErrorCode::BadValue, "frame rate"); // negative
        bad(Rate + 7, 0x7f, ErrorCode::BadValue, "frame rate"); // huge
        bad(Rate + 8, 0x7f, ErrorCode::Truncated, "127");       // length of the creator
    }
    void corruptedHeaderFieldsHaveTheirErrors()
    {
        QFETCH(int, at);
        QFETCH(int, value);
        QFETCH(int, code);
        QFETCH(QString, field);
        const Bytes file =
            tests::withPayload(tests::smallFile(), "HEAD", [&](Bytes &p) { p[std::size_t(at)] = std::uint8_t(value); });
        const auto decoded = decodeAnimation(file);
        QVERIFY(!decoded);
        QCOMPARE(int(decoded.error().code), code);
        QCOMPARE(QString::fromStdString(decoded.error().args.at(0)), field);
        if (ErrorCode(code) != ErrorCode::UnknownCodec)
            QVERIFY(decoded.error().offset != Error::None);
    }

    void countsBeyondTheLimitsAreRefused()
    {
        // 2^30 + 1 vertices, 2^30 + 1 triangles, 2^26 + 1 frames, as varints in place of one byte.
        for (const auto &[at, field] : {std::pair{Vertices, "vertex count"}, {Triangles, "triangle count"}}) {
            const Bytes file = tests::withPayload(tests::smallFile(), "HEAD", [&, where = at](Bytes &p) {
                p.erase(p.begin() + where);
                const Bytes huge{0x81, 0x80, 0x80, 0x80, 0x04};
                p.insert(p.begin() + where, huge.begin(), huge.end());
            });
            const auto decoded = decodeAnimation(file);
            QVERIFY(!decoded);
            QCOMPARE(int(decoded.error().code), int(ErrorCode::BadValue));
            QCOMPARE(decoded.error().args.at(0), std::string(field));
        }
        const Bytes wide = tests::withPayload(tests::smallFile(), "HEAD", [](Bytes &p) {
            p.erase(p.begin() + Vertices);
            const Bytes huge{0x8c, 0x80, 0x80, 0x80, 0x10}; // 2^32 + 12: must not be taken for 12
            p.insert(p.begin() + Vertices, huge.begin(), huge.end());
        });
        QCOMPARE(codeOf(wide), ErrorCode::BadValue);
    }

    void hostileCountsDoNotAllocate()
    {
        // Within the format's limits, but far beyond what a file of this size may need.
        for (const HeaderByte at : {Vertices, Triangles, Frames}) {
            const Bytes file = tests::withPayload(tests::smallFile(), "HEAD", [&](Bytes &p) {
                p.erase(p.begin() + at);
                const Bytes huge{0x80, 0x80, 0x80, 0x10}; // 2^25
                p.insert(p.begin() + at, huge.begin(), huge.end());
            });
            QCOMPARE(codeOf(file), ErrorCode::LimitExceeded);
            DecodeLimits more;
            more.memoryBytes = std::uint64_t(1) << 40;
            // The caller allowed it: the stream counts do not fit the bytes, or the streams end.
            if (at == Triangles) {
                const auto decoded = decodeAnimation(file, Progress(), more);
                QVERIFY(!decoded);
                QCOMPARE(int(decoded.error().code), int(ErrorCode::BadValue));
            }
        }
    }

    void missingAndDuplicateChunksAreNamed()
    {
        const auto chunks = tests::takeApart(tests::smallFile());
        for (std::size_t i = 0; i < chunks.size(); ++i) {
            auto without = chunks;
            without.erase(without.begin() + std::ptrdiff_t(i));
            auto twice = chunks;
            twice.insert(twice.begin() + std::ptrdiff_t(i), chunks[i]);
            const auto missing = decodeAnimation(tests::putTogether(without));
            const auto duplicate = decodeAnimation(tests::putTogether(twice));
            QVERIFY(!missing && !duplicate);
            if (chunks[i].first == "TAIL") {
                QCOMPARE(int(missing.error().code), int(ErrorCode::Truncated));
                QCOMPARE(int(duplicate.error().code), int(ErrorCode::TrailingBytes));
                continue;
            }
            QCOMPARE(int(missing.error().code), int(ErrorCode::MissingChunk));
            QCOMPARE(missing.error().args.at(0), chunks[i].first);
            QCOMPARE(int(duplicate.error().code), int(ErrorCode::DuplicateChunk));
            QCOMPARE(duplicate.error().args.at(0), chunks[i].first);
        }
    }

    void orderOfTheMiddleChunksIsFree()
    {
        auto chunks = tests::takeApart(tests::smallFile());
        std::reverse(chunks.begin() + 1, chunks.end() - 1);
        QCOMPARE(codeOf(tests::putTogether(chunks)), NoError);
        std::swap(chunks[0], chunks[1]);
        QCOMPARE(codeOf(tests::putTogether(chunks)), ErrorCode::MissingChunk);
    }

    void unknownChunksAreSkippedAndKept()
    {
        auto chunks = tests::takeApart(tests::smallFile());
        chunks.insert(chunks.begin() + 2, {"note", {1, 2, 3}});
        chunks.insert(chunks.end() - 1, {"note", {}});
        const Bytes file = tests::putTogether(chunks);
        QCOMPARE(codeOf(file), NoError);
        const auto renamed = withNameAndRate(file, "another name", 60);
        QVERIFY(renamed.has_value());
        const auto after = tests::takeApart(*renamed);
        QVERIFY(std::equal(chunks.begin() + 1, chunks.end(), after.begin() + 1, after.end()));
        const auto decoded = decodeAnimation(*renamed);
        QCOMPARE((*decoded)->name(), std::string("another name"));
        QCOMPARE((*decoded)->frameRate(), 60.0);
        // And back: the very same bytes.
        QVERIFY(*withNameAndRate(*renamed, "plain", 24) == file);
    }

    void unknownChunkWithABadChecksumIsRefused()
    {
        auto chunks = tests::takeApart(tests::smallFile());
        chunks.insert(chunks.begin() + 1, {"note", {1, 2, 3}});
        Bytes file = tests::putTogether(chunks);
        const Bytes tag{'n', 'o', 't', 'e'};
        const auto at = std::search(file.begin(), file.end(), tag.begin(), tag.end());
        *(at + 5) ^= 1;
        const auto decoded = decodeAnimation(file);
        QCOMPARE(int(decoded.error().code), int(ErrorCode::ChecksumMismatch));
        QCOMPARE(decoded.error().args.at(0), std::string("note"));
        QCOMPARE(decoded.error().offset, std::uint64_t(at - file.begin()));
    }

    void newerMinorVersionIsReadAndKept()
    {
        const Bytes extra{9, 8, 7};
        const auto add = [&](Bytes &p) { p.insert(p.end(), extra.begin(), extra.end()); };
        QCOMPARE(codeOf(tests::withPayload(tests::smallFile(), "HEAD", add)), ErrorCode::TrailingBytes);
        const Bytes newer = tests::withPayload(tests::smallFile(), "HEAD", [&](Bytes &p) {
            p[Minor] = 1;
            add(p);
        });
        QCOMPARE(codeOf(newer), NoError);
        const auto renamed = withNameAndRate(newer, "x", 30);
        const Bytes header = tests::takeApart(*renamed).front().second;
        QCOMPARE(int(header[Minor]), 1);
        QVERIFY(std::equal(extra.begin(), extra.end(), header.end() - 3));
        QVERIFY(*withNameAndRate(*renamed, "plain", 24) == newer);
    }

    void badNamesAndRatesAreRefused()
    {
        const Bytes file = tests::smallFile();
        for (const double rate : {0.0, -1.0, 1e7, std::numeric_limits<double>::quiet_NaN()}) {
            const auto result = withNameAndRate(file, "x", rate);
            QVERIFY(!result);
            QCOMPARE(int(result.error().code), int(ErrorCode::BadSetting));
            QCOMPARE(result.error().args.at(0), std::string("frame rate"));
        }
        QCOMPARE(int(withNameAndRate(file, std::string(65536, 'x'), 25).error().code), int(ErrorCode::BadSetting));
        QVERIFY(withNameAndRate(file, std::string(65535, 'x'), 25).has_value());
    }

    void chunksAddUpToTheFile()
    {
        const Bytes file = tests::smallFile();
        const auto chunks = listChunks(file);
        std::uint64_t sum = 8;
        for (const ChunkInfo &chunk : *chunks)
            sum += chunk.bytes;
        QCOMPARE(sum, std::uint64_t(file.size()));
        QCOMPARE(chunks->front().tag, std::string("HEAD"));
        QCOMPARE(chunks->back().tag, std::string("TAIL"));
        QCOMPARE(int(listChunks(Bytes{1, 2, 3}).error().code), int(ErrorCode::BadMagic));
    }
};

SANDREEL_TEST(TestContainer)
#include "tst_container.moc"
