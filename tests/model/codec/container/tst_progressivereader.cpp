// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/codec/basis/productanimation.h"
#include "model/codec/container/progressivereader.h"
#include "tests/model/codec/animations.h"
#include "tests/model/codec/filesurgery.h"
#include "tests/support/testmain.h"

#include <QFile>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

using namespace model;
using namespace model::codec;

namespace {

using AnimationPtr = std::shared_ptr<const DecodedAnimation>;

Bytes golden(const char *name)
{
    QFile file(QStringLiteral(SANDREEL_SOURCE "/tests/data/anim/") + QString::fromLatin1(name));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray raw = file.readAll();
    return Bytes(raw.begin(), raw.end());
}

Bytes encoded(const FrameSource &source, const CodecSettings &method, bool keepOrder = false)
{
    CompressionSettings settings{method};
    settings.keepOrder = keepOrder;
    return encodeAnimation(source, settings)->bytes;
}

/// The file with the chunk moved to before `before`.
Bytes withChunkMoved(const Bytes &file, const std::string &tag, const std::string &before)
{
    tests::RawChunks chunks = tests::takeApart(file);
    const auto isTag = [](const std::string &name) {
        return [name](const auto &chunk) { return chunk.first == name; };
    };
    const auto moved = *std::find_if(chunks.begin(), chunks.end(), isTag(tag));
    std::erase_if(chunks, isTag(tag));
    chunks.insert(std::find_if(chunks.begin(), chunks.end(), isTag(before)), moved);
    return tests::putTogether(chunks);
}

Bytes withChunkAdded(const Bytes &file, const std::string &tag, std::size_t at)
{
    tests::RawChunks chunks = tests::takeApart(file);
    chunks.insert(chunks.begin() + std::ptrdiff_t(at), {tag, Bytes(10, 1)});
    return tests::putTogether(chunks);
}

struct NamedFile
{
    const char *name;
    Bytes bytes;
};

/// `reel` files of every layout.
const std::vector<NamedFile> &reelFiles()
{
    static const std::vector<NamedFile> files = [] {
        const auto waves = tests::waves(24, 90, 9);
        const Bytes ordered = encoded(waves, ReelSettings{0.003, 0}, true);
        const tests::PlainAnimation gliding(6, 20, tests::strip(20), [](std::uint32_t f, std::uint32_t v) {
            return Vec3f{float(v % 9) + 3 * float(f), float(v), float(f * f)};
        });
        const tests::PlainAnimation point(9, 1, {}, [](std::uint32_t f, std::uint32_t) {
            return Vec3f{float(f), 1, 2};
        });
        return std::vector<NamedFile>{
            {"golden", golden("reel-1.0.anim")},
            {"golden, nine trajectories", golden("reel-learned-1.0.anim")},
            {"order kept", ordered},
            {"order after the bands", withChunkMoved(ordered, "ORDR", "TAIL")},
            {"shape after the bands", withChunkMoved(ordered, "SHAP", "TAIL")},
            {"parameters last", withChunkMoved(ordered, "REEL", "TAIL")},
            {"unknown chunks", withChunkAdded(withChunkAdded(ordered, "NOTE", 6), "ABCD", 2)},
            {"no trajectories", encoded(gliding, ReelSettings{0.01, 0})},
            {"one vertex", encoded(point, ReelSettings{0.01, 0})},
            {"coarse", encoded(tests::waves(40, 300, 12), ReelSettings{0.05, 0})},
            {"golden, clusters", golden("reel-parts-1.0.anim")},
        };
    }();
    return files;
}

const ProductAnimation &productOf(const AnimationPtr &animation)
{
    return dynamic_cast<const ProductAnimation &>(*animation);
}

bool sameFrames(const FrameSource &a, const FrameSource &b)
{
    bool same = a.frameCount() == b.frameCount() && a.vertexCount() == b.vertexCount() &&
                a.connectivity().triangles == b.connectivity().triangles;
    for (std::uint32_t f = 0; same && f < a.frameCount(); ++f) {
        const std::vector<Vec3f> left = a.frame(f), right = b.frame(f);
        same = std::memcmp(left.data(), right.data(), left.size() * sizeof(Vec3f)) == 0;
    }
    return same;
}

/// How far the animation is from the mean, the rest shape and the first trajectories of another one, added up plainly;
/// relative to the sum of all magnitudes.
double distanceFromFirstTrajectories(const DecodedAnimation &animation, const ProductAnimation &whole,
                                     std::uint32_t rank)
{
    double largest = 0;
    for (std::uint32_t f = 0; f < animation.frameCount(); ++f) {
        const std::vector<Vec3f> positions = animation.frame(f);
        for (std::size_t v = 0; v < positions.size(); ++v)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::size_t row = 3 * std::size_t(f) + axis;
                double sum = whole.mean(row), magnitudes = std::fabs(sum);
                for (std::uint32_t k = 0; k < rank; ++k) {
                    const double term = double(whole.basis(k, row)) * double(whole.coefficient(k, v));
                    sum += term;
                    magnitudes += std::fabs(term);
                }
                const double shown = double((&positions[v].x)[axis]);
                largest = std::max(largest, std::fabs(shown - sum) / std::max(magnitudes, 1e-30));
            }
    }
    return largest;
}

int codeOf(const Result<void> &result)
{
    return result ? -1 : int(result.error().code);
}

/// What comes of a file that is fed in pieces of so many bytes.
int outcomeInPieces(const Bytes &file, std::size_t piece)
{
    ProgressiveReader reader;
    for (std::size_t at = 0; at < file.size(); at += piece) {
        const auto read = reader.append(std::span(file).subspan(at, std::min(piece, file.size() - at)));
        if (!read)
            return int(read.error().code);
        if (const AnimationPtr shown = reader.animation())
            for (const Vec3f p : shown->frame(shown->frameCount() - 1))
                if (!isFinite(p))
                    return 1000;
    }
    return reader.isComplete() ? -1 : int(ErrorCode::Truncated);
}

int outcomeAtOnce(const Bytes &file)
{
    const auto decoded = decodeAnimation(file);
    return decoded ? -1 : int(decoded.error().code);
}

} // namespace

class TestProgressiveReader final : public QObject
{
    Q_OBJECT

private slots:
    void everyPrefixShowsWhatItHolds_data()
    {
        QTest::addColumn<int>("file");
        for (std::size_t i = 0; i < reelFiles().size(); ++i)
            QTest::newRow(reelFiles()[i].name) << int(i);
    }
    void everyPrefixShowsWhatItHolds()
    {
        QFETCH(int, file);
        const Bytes &bytes = reelFiles()[std::size_t(file)].bytes;
        const auto decoded = decodeAnimation(bytes);
        QVERIFY(decoded.has_value());
        const ProductAnimation &whole = productOf(*decoded);
        const auto ends = whole.prefixBytes();
        QCOMPARE(ends.size(), std::size_t(whole.basisSize() + 1));
        QVERIFY(std::is_sorted(ends.begin(), ends.end()));
        QVERIFY(ends.back() <= bytes.size());

        ProgressiveReader reader;
        QVERIFY(!reader.isPlayable() && !reader.animation() && !reader.header());
        int shown = -1; // trajectories of the latest animation
        for (std::size_t length = 1; length <= bytes.size(); ++length) {
            QCOMPARE(codeOf(reader.append(std::span(bytes).subspan(length - 1, 1))), -1);
            QCOMPARE(reader.bytesRead(), std::uint64_t(length));
            QVERIFY(reader.leastBytes() <= bytes.size());
            QCOMPARE(reader.isComplete(), length == bytes.size());
            // As many as the whole file says that these bytes hold.
            const int held = int(std::upper_bound(ends.begin(), ends.end(), length) - ends.begin()) - 1;
            QCOMPARE(reader.isPlayable(), held >= 0);
            QVERIFY(held < 0 ? reader.playableFrom() > length : reader.playableFrom() == ends[0]);
            QVERIFY(reader.playableFrom() <= ends[0]);
            QCOMPARE(int(reader.bandCount()), std::max(held, 0));
            if (held == shown)
                continue;
            shown = held;
            QCOMPARE(reader.bandsInFile(), whole.basisSize());
            const AnimationPtr animation = reader.animation();
            QVERIFY(animation == reader.animation());
            QCOMPARE(animation->basisSize(), std::uint32_t(held));
            if (animation->settings().keepOrder != whole.settings().keepOrder)
                continue; // its vertices have places of their own until the order comes
            const ProductAnimation &part = productOf(animation);
            QVERIFY(part.connectivity().triangles == whole.connectivity().triangles);
            // Each number of it is the whole file's.
            for (std::size_t row = 0; row < 3 * std::size_t(whole.frameCount()); ++row) {
                QVERIFY(part.mean(row) == whole.mean(row));
                for (std::uint32_t k = 0; k < part.rank(); ++k)
                    QVERIFY(part.basis(k, row) == whole.basis(k, row));
            }
            for (std::size_t v = 0; v < whole.vertexCount(); ++v)
                for (std::uint32_t k = 0; k < part.rank(); ++k)
                    QVERIFY(part.coefficient(k, v) == whole.coefficient(k, v));
            QVERIFY(distanceFromFirstTrajectories(part, whole, part.rank()) < 1e-6);
            // And it has a file of its own.
            const auto again = decodeAnimation(animation->encoded());
            QVERIFY(again.has_value());
            QVERIFY(sameFrames(**again, *animation));
            QCOMPARE((*again)->basisSize(), std::uint32_t(held));
            QCOMPARE((*again)->digest(), animation->digest());
            QVERIFY(std::ranges::equal((*again)->prefixBytes(), animation->prefixBytes()));
            QVERIFY(animation->encodedBytes() <= bytes.size());
        }
        QCOMPARE(shown, int(whole.basisSize()));
        QCOMPARE(reader.leastBytes(), std::uint64_t(bytes.size()));
        const AnimationPtr animation = reader.animation();
        QVERIFY(animation->encoded() == bytes);
        QVERIFY(animation->settings() == whole.settings());
        QCOMPARE(animation->digest(), whole.digest());
        QCOMPARE(animation->name(), whole.name());
        QVERIFY(sameFrames(*animation, whole));
        QVERIFY(std::ranges::equal(animation->prefixBytes(), ends));
    }

    void piecesOfAnySizeShowTheSame_data() { everyPrefixShowsWhatItHolds_data(); }
    void piecesOfAnySizeShowTheSame()
    {
        QFETCH(int, file);
        const Bytes &bytes = reelFiles()[std::size_t(file)].bytes;
        // What each prefix shows, byte by byte.
        std::vector<AnimationPtr> expected{nullptr};
        ProgressiveReader slow;
        for (const std::uint8_t byte : bytes) {
            QCOMPARE(codeOf(slow.append({&byte, 1})), -1);
            expected.push_back(slow.animation());
        }
        std::mt19937 random(7);
        for (int round = 0; round < 20; ++round) {
            const std::size_t most = round == 0 ? bytes.size() : 1 + random() % (bytes.size() / 2);
            ProgressiveReader reader;
            for (std::size_t at = 0; at < bytes.size();) {
                const std::size_t count =
                    round == 0 ? most : std::min<std::size_t>(random() % (most + 1), bytes.size() - at);
                QCOMPARE(codeOf(reader.append(std::span(bytes).subspan(at, count))), -1);
                at += count;
                QCOMPARE(reader.isPlayable(), expected[at] != nullptr);
                // Not asked each time: what it has handed out before must not matter.
                if (reader.isPlayable() && random() % 3 > 0) {
                    QVERIFY(reader.animation()->encoded() == expected[at]->encoded());
                    QVERIFY(sameFrames(*reader.animation(), *expected[at]));
                }
            }
            QVERIFY(reader.isComplete());
            QVERIFY(reader.animation()->encoded() == bytes);
        }
    }

    void theErrorFallsAsThePrefixGrows()
    {
        const auto source = tests::waves(50, 900, 12);
        CompressionSettings settings{ReelSettings{0.003, 0}};
        const auto file = encodeAnimation(source, settings);
        QVERIFY(file.has_value());
        const auto expected = tests::reordered(source, file->permutation);
        ProgressiveReader reader;
        double before = INFINITY, first = 0;
        for (const std::uint8_t byte : file->bytes) {
            const std::uint32_t bands = reader.bandCount();
            const bool wasPlayable = reader.isPlayable();
            QVERIFY(reader.append({&byte, 1}).has_value());
            if (reader.isPlayable() && (!wasPlayable || reader.bandCount() > bands)) {
                const double error = tests::kgErrorPercent(expected, *reader.animation());
                QVERIFY2(error < before, qPrintable(QString("%1 after %2").arg(error).arg(before)));
                before = error;
                if (!wasPlayable)
                    first = error;
            }
        }
        QVERIFY(reader.bandCount() > 6);
        QVERIFY2(before < first / 50, qPrintable(QString("%1 %2").arg(first).arg(before)));
    }

    void otherCodecsShowWhenTheyAreWhole_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"wave-1.0.anim", "direct-1.0.anim", "direct-deflate-1.0.anim", "wave-coddyac-1.0.anim",
                                 "wave-coddyac-ordered-1.0.anim"})
            QTest::newRow(name) << name;
    }
    void otherCodecsShowWhenTheyAreWhole()
    {
        QFETCH(QString, name);
        const Bytes bytes = golden(name.toLatin1().constData());
        ProgressiveReader reader;
        for (std::size_t at = 0; at < bytes.size(); ++at) {
            QVERIFY(!reader.isPlayable() && !reader.animation() && !reader.isComplete());
            QVERIFY(reader.append(std::span(bytes).subspan(at, 1)).has_value());
            QCOMPARE(reader.bandsInFile(), 0u);
        }
        QVERIFY(reader.isComplete());
        QVERIFY(sameFrames(*reader.animation(), **decodeAnimation(bytes)));
        QVERIFY((*decodeAnimation(bytes))->prefixBytes().empty());
    }

    void errorsComeAsSoonAsTheyCanBeKnown()
    {
        const Bytes good = reelFiles()[2].bytes;
        const auto ends = [](const Bytes &file, const std::string &tag) {
            std::size_t at = 8;
            for (const auto &[name, payload] : tests::takeApart(file)) {
                at += 4 + (payload.size() < 128 ? 1 : payload.size() < 16384 ? 2 : 3) + payload.size() + 4;
                if (name == tag)
                    break;
            }
            return at;
        };
        // The error, and the byte with which it comes.
        const auto expect = [](const Bytes &file, ErrorCode code, std::size_t at) {
            ProgressiveReader reader;
            for (std::size_t i = 0; i < file.size(); ++i) {
                const auto read = reader.append(std::span(file).subspan(i, 1));
                if (!read) {
                    QCOMPARE(int(read.error().code), int(code));
                    QCOMPARE(i + 1, at);
                    // For good.
                    QVERIFY(!reader.isPlayable() && !reader.animation() && !reader.isComplete());
                    QCOMPARE(codeOf(reader.append({})), int(code));
                    return;
                }
            }
            QFAIL("no error");
        };
        Bytes file = good;
        file[3] ^= 1;
        expect(file, ErrorCode::BadMagic, 4);
        file = tests::withPayload(good, "HEAD", [](Bytes &p) { p[0] = 9; });
        expect(file, ErrorCode::UnsupportedVersion, ends(file, "HEAD"));
        file = tests::withPayload(good, "HEAD", [](Bytes &p) { p[3] = 99; });
        expect(file, ErrorCode::UnknownCodec, ends(file, "HEAD"));
        file = tests::withPayload(good, "REEL", [](Bytes &p) { p[16] = 0x7f; });
        expect(file, ErrorCode::BadValue, ends(file, "REEL"));
        file = tests::withPayload(good, "CLRS", [](Bytes &p) { p.resize(1); });
        expect(file, ErrorCode::CorruptStream, ends(file, "CLRS"));
        file = tests::withPayload(good, "ORDR", [](Bytes &p) { p.push_back(1); });
        expect(file, ErrorCode::CorruptStream, ends(file, "ORDR"));
        file = tests::withPayload(good, "SHAP", [](Bytes &p) { p.push_back(1); });
        expect(file, ErrorCode::CorruptStream, ends(file, "SHAP"));
        file = tests::withPayload(good, "BAND", [](Bytes &p) { p.push_back(1); });
        expect(file, ErrorCode::CorruptStream, ends(file, "BAND"));
        file = tests::withPayload(good, "BAND", [](Bytes &p) { std::fill_n(p.begin(), 4, std::uint8_t(0xff)); });
        expect(file, ErrorCode::CorruptStream, ends(file, "SHAP") + 4 + 2 + 4);
        file = good;
        file[ends(good, "SHAP") - 5] ^= 1;
        expect(file, ErrorCode::ChecksumMismatch, ends(good, "SHAP"));
        file = good;
        file[ends(good, "BAND") - 4] ^= 1; // of the checksum itself: everything else decodes
        expect(file, ErrorCode::ChecksumMismatch, ends(good, "BAND"));
        file = good;
        file.push_back(0);
        expect(file, ErrorCode::TrailingBytes, file.size());
        tests::RawChunks chunks = tests::takeApart(good);
        chunks.insert(chunks.begin() + 4, chunks[1]);
        file = tests::putTogether(chunks);
        expect(file, ErrorCode::DuplicateChunk, ends(good, "ORDR") + (ends(good, "REEL") - ends(good, "HEAD")));
        chunks = tests::takeApart(good);
        chunks.insert(chunks.begin() + 1, chunks[0]);
        file = tests::putTogether(chunks);
        expect(file, ErrorCode::DuplicateChunk, 2 * ends(good, "HEAD") - 8);
        for (const std::string tag : {"REEL", "CLRS", "SHAP", "BAND"}) {
            chunks = tests::takeApart(good);
            std::erase_if(chunks, [&](const auto &chunk) { return chunk.first == tag; });
            file = tests::putTogether(chunks);
            expect(file, ErrorCode::MissingChunk, file.size());
        }
    }

    void damageShowsAsInTheWholeFile()
    {
        const Bytes good = reelFiles()[0].bytes;
        for (const auto &[tag, payload] : tests::takeApart(good))
            for (std::size_t i = 0; i < payload.size(); ++i)
                for (const std::uint8_t change : {0x01, 0x80, 0xff}) {
                    // With right checksums: what another program could write.
                    const Bytes file = tests::withPayload(good, tag, [&](Bytes &p) { p[i] ^= change; });
                    QCOMPARE(outcomeInPieces(file, 1 + i % 9), outcomeAtOnce(file));
                }
        for (std::size_t i = 0; i < good.size(); ++i) {
            Bytes file = good;
            file[i] ^= 0x10;
            const int outcome = outcomeInPieces(file, 5);
            QVERIFY2(outcome >= 0 && outcome != 1000, qPrintable(QString::number(i)));
        }
    }

    void hostileLengthsAllocateNothing()
    {
        const Bytes good = reelFiles()[0].bytes;
        for (const std::string tag : {"HEAD", "CLRS", "BAND", "ABCD"}) {
            Bytes file(good.begin(), good.begin() + 8);
            for (const auto &[name, payload] : tests::takeApart(good)) {
                if (name == tag)
                    break;
                const Bytes chunk = tests::putTogether({{name, payload}});
                file.insert(file.end(), chunk.begin() + 8, chunk.end());
            }
            if (tag == "ABCD") // after the end
                file.resize(file.size() - 9);
            file.insert(file.end(), tag.begin(), tag.end());
            file.insert(file.end(), 9, 0xff);
            file.push_back(0x01); // 2^64 - 1 bytes follow
            // What a `BAND` of that length could begin with.
            const Bytes bands = tests::takeApart(good)[4].second;
            file.insert(file.end(), bands.begin(), bands.end());
            ProgressiveReader reader;
            QCOMPARE(codeOf(reader.append(file)), -1);
            QVERIFY(reader.leastBytes() > (std::uint64_t(1) << 61));
            QVERIFY(!reader.isComplete());
            QCOMPARE(reader.isPlayable(), tag == "BAND" || tag == "ABCD");
            QCOMPARE(reader.playableFrom() < 1000, tag == "BAND" || tag == "ABCD");
            if (reader.isPlayable())
                QVERIFY(reader.bandCount() > 0 && reader.bandCount() <= reader.bandsInFile());
        }
    }

    void memoryIsBounded()
    {
        const Bytes small = reelFiles()[0].bytes;
        DecodeLimits limits;
        limits.memoryBytes = 10000;
        ProgressiveReader strict(limits);
        QCOMPARE(codeOf(strict.append(std::span(small).first(small.size() - 20))), int(ErrorCode::LimitExceeded));

        // By its header 2^26 vertices: the limit would grow with the bytes, so that only the end tells.
        const Bytes file = tests::withPayload(small, "HEAD", [](Bytes &p) {
            p.erase(p.begin() + 4);
            p.insert(p.begin() + 4, {0x80, 0x80, 0x80, 0x20});
        });
        ProgressiveReader reader;
        QCOMPARE(codeOf(reader.append(std::span(file).first(file.size() - 1))), -1);
        QVERIFY(!reader.isPlayable());
        QCOMPARE(codeOf(reader.append(std::span(file).last(1))), int(ErrorCode::LimitExceeded));
    }

    void sameWithAnyNumberOfThreads()
    {
        const Bytes file = encoded(tests::waves(30, 3000, 9), ReelSettings{0.005, 0});
        const AnimationPtr whole = *decodeAnimation(file);
        for (const unsigned threads : {1u, 5u}) {
            setThreadCount(threads);
            ProgressiveReader reader;
            for (std::size_t at = 0; at < file.size(); at += 100)
                QVERIFY(reader.append(std::span(file).subspan(at, std::min<std::size_t>(100, file.size() - at))));
            setThreadCount(0);
            QVERIFY(sameFrames(*reader.animation(), *whole));
        }
    }

    void cancelStops()
    {
        const Bytes file = encoded(tests::waves(30, 2000, 9), ReelSettings{0.01, 0});
        for (const double at : {0.0, 0.2, 0.35, 0.5}) {
            std::shared_ptr<Progress> handle;
            handle = std::make_shared<Progress>([&](double fraction) {
                if (fraction >= at)
                    handle->cancel();
            });
            ProgressiveReader reader;
            QCOMPARE(codeOf(reader.append(std::span(file).first(file.size() - 10), *handle)),
                     int(ErrorCode::Cancelled));
        }
    }
};

SANDREEL_TEST(TestProgressiveReader)
#include "tst_progressivereader.moc"
