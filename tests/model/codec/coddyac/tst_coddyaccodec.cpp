// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/codec/animationcodec.h"
#include "model/codec/coddyac/lanestage.h"
#include "model/codec/coddyac/parallelogramstage.h"
#include "model/codec/framestack.h"
#include "model/codec/trialencoder.h"
#include "tests/model/codec/animations.h"
#include "tests/model/codec/filesurgery.h"
#include "tests/support/surfaces.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <random>

using namespace model;
using namespace model::codec;

namespace {

CompressionSettings settingsOf(std::uint32_t basisSize, double step, double basisStep, bool keepOrder = false)
{
    return {CoddyacSettings{basisSize, step, basisStep}, keepOrder};
}

CompressionSettings fine(bool keepOrder = false)
{
    return settingsOf(60, 1e-5, 1e-5, keepOrder);
}

/// The decoded animation with the vertices of the source in their order again; all frames.
std::vector<std::vector<Vec3f>> inOrder(const FrameSource &decoded, std::span<const std::uint32_t> permutation)
{
    std::vector<std::vector<Vec3f>> result;
    for (std::uint32_t f = 0; f < decoded.frameCount(); ++f) {
        const auto frame = decoded.frame(f);
        auto &placed = result.emplace_back(frame.size());
        for (std::size_t v = 0; v < frame.size(); ++v)
            placed[permutation[v]] = frame[v];
    }
    return result;
}

struct Difference
{
    double largest = 0, squares = 0, kgPercent = 0;
};

Difference differenceOf(const FrameSource &source, const FrameSource &decoded,
                        std::span<const std::uint32_t> permutation)
{
    Difference result;
    double energy = 0;
    const auto frames = inOrder(decoded, permutation);
    for (std::uint32_t f = 0; f < source.frameCount(); ++f) {
        const auto frame = source.frame(f);
        double mean[3] = {};
        for (const Vec3f p : frame) {
            mean[0] += double(p.x) / double(frame.size());
            mean[1] += double(p.y) / double(frame.size());
            mean[2] += double(p.z) / double(frame.size());
        }
        for (std::size_t v = 0; v < frame.size(); ++v) {
            const float a[3] = {frame[v].x, frame[v].y, frame[v].z};
            const float b[3] = {frames[f][v].x, frames[f][v].y, frames[f][v].z};
            for (int axis = 0; axis < 3; ++axis) {
                const double d = double(a[axis]) - double(b[axis]);
                result.largest = std::max(result.largest, std::fabs(d));
                result.squares += d * d;
                energy += (double(a[axis]) - mean[axis]) * (double(a[axis]) - mean[axis]);
            }
        }
    }
    result.kgPercent = energy > 0 ? 100 * std::sqrt(result.squares / energy) : 0;
    return result;
}

int outcomeOf(const Bytes &file)
{
    const auto decoded = decodeAnimation(file);
    if (!decoded)
        return int(decoded.error().code);
    for (const Triangle &t : (*decoded)->connectivity().triangles)
        for (const std::uint32_t v : t)
            if (v >= (*decoded)->vertexCount())
                return 1000;
    (void)(*decoded)->frame((*decoded)->frameCount() - 1);
    return -1;
}

Bytes smallFile(bool keepOrder)
{
    return encodeAnimation(tests::waves(5, 30, 6), settingsOf(4, 0.01, 0.01, keepOrder))->bytes;
}

Chunk chunkOf(const Bytes &payload)
{
    return {"test", payload, 1000, payload.size(), 0};
}

} // namespace

class TestCoddyacCodec final : public QObject
{
    Q_OBJECT

private slots:
    void roundTrip_data()
    {
        QTest::addColumn<int>("row");
        QTest::addColumn<bool>("keepOrder");
        const auto table = tests::animationTable();
        for (std::size_t i = 0; i < table.size(); ++i)
            for (const bool keepOrder : {false, true})
                QTest::addRow("%s%s", table[i].name.c_str(), keepOrder ? ", in order" : "") << int(i) << keepOrder;
    }
    void roundTrip()
    {
        QFETCH(int, row);
        QFETCH(bool, keepOrder);
        const auto entry = tests::animationTable()[std::size_t(row)];
        const FrameSource &source = *entry.animation;
        const auto encoded = encodeAnimation(source, fine(keepOrder));
        QVERIFY2(encoded.has_value(), encoded ? "" : encoded.error().args.at(0).c_str());
        const auto decoded = decodeAnimation(encoded->bytes);
        QVERIFY(decoded.has_value());
        const DecodedAnimation &animation = **decoded;
        QCOMPARE(animation.frameCount(), source.frameCount());
        QCOMPARE(animation.vertexCount(), source.vertexCount());
        QCOMPARE(animation.frameRate(), 24.0);
        QCOMPARE(animation.name(), std::string("plain"));
        QVERIFY(animation.settings() == fine(keepOrder));
        QVERIFY(animation.encoded() == encoded->bytes);
        QVERIFY(tests::canonical(tests::renamed(animation.connectivity().triangles, encoded->permutation)) ==
                tests::canonical(source.connectivity().triangles));
        if (keepOrder)
            for (std::uint32_t v = 0; v < source.vertexCount(); ++v)
                QCOMPARE(encoded->permutation.at(v), v);
        const double bound = 2e-3 + (entry.name == "far from the origin" ? 0.25 : 0);
        const Difference difference = differenceOf(source, animation, encoded->permutation);
        QVERIFY2(difference.largest <= bound, qPrintable(QString::number(difference.largest)));
    }

    /// Every kind of mesh, moving: what the cut, the weld and the neighbours of dirty meshes come to.
    void everySurface_data()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < tests::namedSurfaces().size(); ++i)
            if (tests::namedSurfaces()[i].mesh.vertexCount > 0)
                QTest::newRow(tests::namedSurfaces()[i].name.c_str()) << int(i);
    }
    void everySurface()
    {
        QFETCH(int, index);
        const Connectivity &mesh = tests::namedSurfaces()[std::size_t(index)].mesh;
        const tests::PlainAnimation source(4, mesh.vertexCount, mesh.triangles, [](std::uint32_t f, std::uint32_t v) {
            return Vec3f{float(std::cos(0.7 * v)), float(std::sin(1.3 * v + f)), float(0.01 * f * v)};
        });
        for (const bool keepOrder : {false, true}) {
            const auto encoded = encodeAnimation(source, fine(keepOrder));
            QVERIFY(encoded.has_value());
            const auto decoded = decodeAnimation(encoded->bytes);
            QVERIFY(decoded.has_value());
            QVERIFY(tests::canonical(tests::renamed((*decoded)->connectivity().triangles, encoded->permutation)) ==
                    tests::canonical(mesh.triangles));
            QVERIFY(differenceOf(source, **decoded, encoded->permutation).largest < 2e-2);
        }
    }

    /// What the encoder says of the error is what a decoder's frames have.
    void theErrorOfATrialIsThatOfTheFile()
    {
        const auto source = tests::waves(30, 400, 12);
        const auto encoder = prepareTrials(source, CodecId::Coddyac, Progress());
        QVERIFY(encoder.has_value());
        for (const auto &[size, step] : {std::pair{3u, 0.02}, {8u, 0.003}, {15u, 0.0005}}) {
            const CodecSettings settings = CoddyacSettings{size, step, step};
            const auto trial = (*encoder)->attempt(settings, Progress());
            const auto encoded = (*encoder)->encode({settings}, Progress());
            QCOMPARE(trial->bytes, std::uint64_t(encoded->bytes.size()));
            const auto decoded = decodeAnimation(encoded->bytes);
            const double measured = differenceOf(source, **decoded, encoded->permutation).kgPercent;
            QVERIFY2(std::fabs(trial->kgErrorPercent - measured) < 1e-3 * measured + 2e-3,
                     qPrintable(QString("%1 %2").arg(trial->kgErrorPercent).arg(measured)));
            QVERIFY(encoded->bytes == encodeAnimation(source, {settings})->bytes || size < 15);
        }
    }

    void finerStepsGiveSmallerErrors()
    {
        const auto source = tests::waves(30, 400, 12);
        double last = 1e9;
        for (const double step : {0.1, 0.03, 0.01, 0.003, 0.001}) {
            const auto encoded = encodeAnimation(source, settingsOf(20, step, step));
            const double error =
                differenceOf(source, **decodeAnimation(encoded->bytes), encoded->permutation).kgPercent;
            QVERIFY(error < last);
            // Rounding alone would leave about a third of a step of each coefficient and each trajectory.
            QVERIFY(error < 100 * step * 4);
            last = error;
        }
    }

    void orderCostsWhatItsChunkCosts()
    {
        const auto source = tests::waves(20, 300, 5);
        const std::size_t without = encodeAnimation(source, settingsOf(5, 0.01, 0.01, false))->bytes.size();
        const std::size_t with = encodeAnimation(source, settingsOf(5, 0.01, 0.01, true))->bytes.size();
        QVERIFY(with > without && with < without + 300 * 2);
    }

    void sameInputSameBytes()
    {
        const auto source = tests::waves(20, 3000, 5);
        setThreadCount(1);
        const Bytes one = encodeAnimation(source, settingsOf(8, 0.01, 0.01))->bytes;
        setThreadCount(3);
        const Bytes three = encodeAnimation(source, settingsOf(8, 0.01, 0.01))->bytes;
        setThreadCount(0);
        QVERIFY(one == three);
    }

    void lanes_data()
    {
        QTest::addColumn<int>("columns");
        QTest::addColumn<QString>("kind");
        for (const char *kind : {"zero", "smooth", "noise", "extreme"})
            for (const int columns : {3, 6, 9, 300})
                QTest::newRow(qPrintable(QString("%1, %2").arg(kind).arg(columns))) << columns << kind;
    }
    void lanes()
    {
        QFETCH(int, columns);
        QFETCH(QString, kind);
        std::mt19937 random(7);
        std::vector<std::int64_t> values(std::size_t(columns) * 3);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = kind == "zero"     ? 0
                        : kind == "smooth" ? std::int64_t(1e6 * std::sin(0.05 * double(i / 3)))
                        : kind == "noise"  ? std::int64_t(random() % 2001) - 1000
                        : random() % 2 > 0 ? MaxLaneValue
                                           : -MaxLaneValue;
        const Bytes bytes = encodeLanes(std::size_t(columns), values);
        std::vector<std::int64_t> found;
        const auto result =
            decodeLanes(chunkOf(bytes), 3, std::size_t(columns), "lanes", Progress(),
                        [&](std::size_t, auto row) { found.insert(found.end(), row.begin(), row.end()); });
        QVERIFY(result.has_value());
        QVERIFY(found == values);
    }

    void bandsOfExtremesComeBack()
    {
        const auto connectivity = encodeConnectivity(tests::sheet(12, 9), Progress());
        const auto &neighbours = connectivity->coded.neighbours;
        std::mt19937 random(3);
        std::vector<std::int32_t> values(neighbours.size() * 4);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = i < neighbours.size() ? (random() % 2 > 0 ? MaxBandValue : -MaxBandValue)
                                              : std::int32_t(random() % 7) - 3;
        const Bytes bytes = *encodeByParallelograms(4, values, neighbours, Progress());
        std::vector<std::int32_t> found;
        const auto result =
            decodeByParallelograms(chunkOf(bytes), 4, neighbours, Progress(),
                                   [&](std::uint32_t, auto row) { found.insert(found.end(), row.begin(), row.end()); });
        QVERIFY(result.has_value());
        QVERIFY(found == values);
    }

    void predictionIsTheParallelogram()
    {
        const std::vector<std::int32_t> values{5, 7, 20};
        QCOMPARE(predictedByNeighbours(values, 3, {0, 1, 2}), std::int64_t(5 + 7 - 20));
        QCOMPARE(predictedByNeighbours(values, 3, {2, 2, 1}), std::int64_t(2 * 20 - 7));
        QCOMPARE(predictedByNeighbours(values, 3, {}), std::int64_t(20));
        QCOMPARE(predictedByNeighbours(values, 0, {}), std::int64_t(0));
    }

    void everyPrefixAndFlippedByteIsRejected()
    {
        for (const bool keepOrder : {false, true}) {
            const Bytes file = smallFile(keepOrder);
            for (std::size_t i = 0; i < file.size(); ++i) {
                QVERIFY(!decodeAnimation(Bytes(file.begin(), file.begin() + std::ptrdiff_t(i))));
                Bytes flipped = file;
                flipped[i] ^= 0xff;
                QVERIFY(!decodeAnimation(flipped));
            }
        }
    }

    /// With right checksums: what an attacker or another program could write.
    void damagedPayloadsNeverCrash()
    {
        const Bytes good = smallFile(true);
        for (const auto &[tag, payload] : tests::takeApart(good)) {
            for (std::size_t i = 0; i < payload.size(); ++i)
                for (const std::uint8_t change : {0x01, 0x10, 0x80, 0xff})
                    QVERIFY(outcomeOf(tests::withPayload(good, tag, [&](Bytes &p) { p[i] ^= change; })) != 1000);
            for (std::size_t length = 0; length < payload.size(); ++length)
                QVERIFY(outcomeOf(tests::withPayload(good, tag, [&](Bytes &p) { p.resize(length); })) != 1000);
        }
    }

    void damagedPartsAreNamed()
    {
        const Bytes good = smallFile(true);
        for (const auto &[tag, stage] : {std::pair{"CLRS", "connectivity"},
                                         {"ORDR", "vertex order"},
                                         {"MEAN", "means"},
                                         {"BASE", "basis"},
                                         {"COEF", "coefficients"}}) {
            const auto decoded = decodeAnimation(tests::withPayload(good, tag, [&](Bytes &p) { p.assign(4, 0xff); }));
            QVERIFY2(!decoded, tag);
            QCOMPARE(int(decoded.error().code), int(ErrorCode::CorruptStream));
            QCOMPARE(decoded.error().args, std::vector<std::string>{stage});
        }
        const auto field = [&](std::size_t at, std::uint8_t value) {
            return outcomeOf(tests::withPayload(good, "CDYP", [&](Bytes &p) { p.at(at) = value; }));
        };
        QCOMPARE(field(0, 0), int(ErrorCode::BadValue));       // no basis wanted
        QCOMPARE(field(8, 0x7f), int(ErrorCode::BadValue));    // step beyond its range
        QCOMPARE(field(16, 0xff), int(ErrorCode::BadValue));   // basis step below zero
        QCOMPARE(field(24, 0x7f), int(ErrorCode::BadValue));   // unit beyond all
        QCOMPARE(field(25, 5), int(ErrorCode::BadValue));      // a larger basis than wanted
        QCOMPARE(field(25, 3), int(ErrorCode::TrailingBytes)); // one less than there are
        for (const char *tag : {"CDYP", "CLRS", "MEAN", "BASE", "COEF"}) {
            tests::RawChunks chunks = tests::takeApart(good);
            std::erase_if(chunks, [&](const auto &chunk) { return chunk.first == tag; });
            QCOMPARE(outcomeOf(tests::putTogether(chunks)), int(ErrorCode::MissingChunk));
        }
        tests::RawChunks twice = tests::takeApart(good);
        for (std::size_t i = 0; i < twice.size(); ++i)
            if (twice[i].first == "ORDR") {
                twice.insert(twice.begin() + std::ptrdiff_t(i), twice[i]);
                break;
            }
        QCOMPARE(outcomeOf(tests::putTogether(twice)), int(ErrorCode::DuplicateChunk));
    }

    void hostileCountsDoNotAllocate()
    {
        const Bytes good = smallFile(false);
        const std::vector<std::uint8_t> much{0x80, 0x80, 0x80, 0x80, 0x04}; // 2^30
        for (std::size_t field = 0; field < 2; ++field) // vertices, triangles; each one byte in this file
            QCOMPARE(outcomeOf(tests::withPayload(good, "HEAD",
                                                  [&](Bytes &p) {
                                                      const auto at = p.begin() + 4 + std::ptrdiff_t(field);
                                                      p.insert(p.erase(at), much.begin(), much.end());
                                                  })),
                     int(ErrorCode::LimitExceeded));
    }

    void memoryLimitIsTheCallers()
    {
        const Bytes file = encodeAnimation(tests::waves(20, 500, 5), settingsOf(5, 0.001, 0.001))->bytes;
        DecodeLimits limits;
        limits.memoryBytes = 10000;
        QCOMPARE(int(decodeAnimation(file, Progress(), limits).error().code), int(ErrorCode::LimitExceeded));
        limits.memoryBytes = 8u << 20;
        QVERIFY(decodeAnimation(file, Progress(), limits).has_value());
    }

    void valuesTooLargeAreRefused()
    {
        // One vertex far off: in the smallest steps of the root mean square it is more than 30 bits hold.
        const tests::PlainAnimation wild(3, 20000, {}, [](std::uint32_t f, std::uint32_t v) {
            return v == 0 ? Vec3f{1e9f * float(f), 0, 0} : Vec3f{float(v % 7), float(f), 0};
        });
        const auto encoded = encodeAnimation(wild, settingsOf(20, 1e-7, 1e-7));
        QVERIFY(!encoded);
        QCOMPARE(int(encoded.error().code), int(ErrorCode::LimitExceeded));
    }

    void cancelStops()
    {
        const auto source = tests::waves(40, 3000, 10);
        for (const double at : {0.0, 0.3, 0.8}) {
            std::shared_ptr<Progress> handle;
            handle = std::make_shared<Progress>([&](double fraction) {
                if (fraction >= at)
                    handle->cancel();
            });
            const auto encoded = encodeAnimation(source, settingsOf(10, 0.01, 0.01), *handle);
            QVERIFY(!encoded);
            QCOMPARE(int(encoded.error().code), int(ErrorCode::Cancelled));
        }
    }
};

SANDREEL_TEST(TestCoddyacCodec)
#include "tst_coddyaccodec.moc"
