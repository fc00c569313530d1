// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/codec/animationcodec.h"
#include "model/codec/trialencoder.h"
#include "tests/model/codec/animations.h"
#include "tests/model/codec/filesurgery.h"
#include "tests/support/rows.h"
#include "tests/support/testmain.h"

#include <QFile>

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

using namespace model;
using namespace model::codec;

namespace {

CompressionSettings settingsOf(double step, std::uint32_t basisSize = 0)
{
    return {ReelSettings{step, basisSize}};
}

/// Triangles as a multiset: those of the decoded mesh in the input's vertices, each turned so that its least corner
/// comes first.
std::vector<Triangle> comparable(std::vector<Triangle> triangles, const std::vector<std::uint32_t> *permutation)
{
    for (Triangle &t : triangles) {
        if (permutation)
            for (std::uint32_t &v : t)
                v = (*permutation)[v];
        Triangle least = t;
        for (int turn = 0; turn < 2; ++turn) {
            std::rotate(t.begin(), t.begin() + 1, t.end());
            least = std::min(least, t);
        }
        t = least;
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

Bytes small()
{
    const auto encoded = encodeAnimation(tests::waves(7, 30, 5), settingsOf(0.02));
    return encoded ? encoded->bytes : Bytes();
}

/// The error's code, or -1; 1000 where a position is not finite.
int outcomeOf(const Bytes &file)
{
    const auto decoded = decodeAnimation(file);
    if (!decoded)
        return int(decoded.error().code);
    for (std::uint32_t f = 0; f < std::min((*decoded)->frameCount(), 100u); ++f)
        for (const Vec3f p : (*decoded)->frame(f))
            if (!isFinite(p))
                return 1000;
    return -1;
}

} // namespace

class TestReelCodec final : public QObject
{
    Q_OBJECT

private slots:
    void everyAnimationComesBack_data() { tests::addRows(tests::animationTable()); }
    void everyAnimationComesBack()
    {
        QFETCH(int, row);
        const auto source = tests::animationTable()[std::size_t(row)].animation;
        double before = INFINITY;
        for (const double step : {0.05, 0.005, 0.0001}) {
            const auto encoded = encodeAnimation(*source, settingsOf(step));
            QVERIFY(encoded.has_value());
            const auto decoded = decodeAnimation(encoded->bytes);
            QVERIFY2(decoded.has_value(), qPrintable(QString::fromStdString(tests::errorText(encoded->bytes))));
            QCOMPARE((*decoded)->frameCount(), source->frameCount());
            QCOMPARE((*decoded)->name(), source->title);
            QCOMPARE((*decoded)->frameRate(), source->rate);
            QVERIFY((*decoded)->settings() == settingsOf(step));
            std::vector<std::uint32_t> sorted = encoded->permutation;
            std::sort(sorted.begin(), sorted.end());
            for (std::uint32_t v = 0; v < source->vertexCount(); ++v)
                QCOMPARE(sorted[v], v);
            QVERIFY(comparable((*decoded)->connectivity().triangles, &encoded->permutation) ==
                    comparable(source->connectivity().triangles, nullptr));

            const auto expected = tests::reordered(*source, encoded->permutation);
            if (QString(QTest::currentDataTag()).startsWith("all at one")) { // a KG error has nothing to relate to
                QVERIFY(tests::largestError(expected, **decoded) < 4 * step);
                continue;
            }
            const double error = tests::kgErrorPercent(expected, **decoded);
            // Floats far from the origin have a step of their own.
            const double floor = tests::animationTable()[std::size_t(row)].name == "far from the origin" ? 5 : 1e-4;
            QVERIFY2(error < 400 * step + floor, qPrintable(QString("step %1: %2 %").arg(step).arg(error)));
            QVERIFY(error <= before * 1.05 + floor);
            before = error;
        }
    }

    void theEncoderKnowsItsError_data()
    {
        QTest::addColumn<double>("step");
        QTest::addColumn<int>("basisSize");
        QTest::newRow("coarse") << 0.05 << 0;
        QTest::newRow("fine") << 0.0005 << 0;
        QTest::newRow("few trajectories") << 0.001 << 2;
    }
    void theEncoderKnowsItsError()
    {
        QFETCH(double, step);
        QFETCH(int, basisSize);
        const auto source = tests::waves(40, 500, 9);
        auto trials = prepareTrials(source, CodecId::Reel, Progress());
        QVERIFY(trials.has_value());
        const CompressionSettings settings = settingsOf(step, std::uint32_t(basisSize));
        const auto trial = (*trials)->attempt(settings.method, Progress());
        QVERIFY(trial.has_value());
        const auto encoded = encodeAnimation(source, settings);
        QVERIFY(encoded.has_value());
        QCOMPARE(trial->bytes, std::uint64_t(encoded->bytes.size()));
        const auto decoded = decodeAnimation(encoded->bytes);
        const double error = tests::kgErrorPercent(tests::reordered(source, encoded->permutation), **decoded);
        QVERIFY2(std::fabs(error - trial->kgErrorPercent) < 0.002 * error,
                 qPrintable(QString("%1 %2").arg(error).arg(trial->kgErrorPercent)));
        if (basisSize > 0)
            QCOMPARE((*decoded)->basisSize(), std::uint32_t(basisSize));
    }

    void smallerThanPcaAtTheSameError()
    {
        const auto source = tests::waves(60, 2000, 12);
        const auto reel = encodeAnimation(source, settingsOf(0.004));
        const auto pca = encodeAnimation(source, {PcaSettings{20, 300}});
        QVERIFY(reel.has_value() && pca.has_value());
        const double reelError =
            tests::kgErrorPercent(tests::reordered(source, reel->permutation), **decodeAnimation(reel->bytes));
        const double pcaError = tests::kgErrorPercent(source, **decodeAnimation(pca->bytes));
        QVERIFY2(reelError < pcaError, qPrintable(QString("%1 %2").arg(reelError).arg(pcaError)));
        QVERIFY2(reel->bytes.size() < pca->bytes.size() / 2,
                 qPrintable(QString("%1 %2").arg(reel->bytes.size()).arg(pca->bytes.size())));
    }

    void keptOrderIsTheInputs_data() { everyAnimationComesBack_data(); }
    void keptOrderIsTheInputs()
    {
        QFETCH(int, row);
        const auto source = tests::animationTable()[std::size_t(row)].animation;
        CompressionSettings settings = settingsOf(0.01);
        const auto free = encodeAnimation(*source, settings);
        settings.keepOrder = true;
        const auto kept = encodeAnimation(*source, settings);
        QVERIFY(free.has_value() && kept.has_value());
        const auto decodedFree = *decodeAnimation(free->bytes), decodedKept = *decodeAnimation(kept->bytes);
        QVERIFY(decodedKept->settings() == settings);
        QVERIFY(comparable(decodedKept->connectivity().triangles, nullptr) ==
                comparable(source->connectivity().triangles, nullptr));
        for (std::uint32_t f = 0; f < source->frameCount(); ++f)
            for (std::uint32_t v = 0; v < source->vertexCount(); ++v) {
                QCOMPARE(kept->permutation[v], v);
                QVERIFY(decodedKept->frame(f)[free->permutation[v]] == decodedFree->frame(f)[v]);
            }
    }

    void nothingMovesSoNothingIsCoded()
    {
        // Motion that all vertices share is in the means; the basis stays empty.
        const tests::PlainAnimation gliding(20, 60, tests::strip(60), [](std::uint32_t f, std::uint32_t v) {
            return Vec3f{float(v % 9) + 3 * float(f), float(v), float(f * f)};
        });
        const auto decoded = decodeAnimation(encodeAnimation(gliding, settingsOf(0.01))->bytes);
        QVERIFY(decoded.has_value());
        QCOMPARE((*decoded)->basisSize(), 0u);
    }

    void sameBytesWithAnyNumberOfThreads()
    {
        const auto source = tests::waves(50, 3000, 9);
        setThreadCount(1);
        const auto one = encodeAnimation(source, settingsOf(0.005));
        setThreadCount(5);
        const auto five = encodeAnimation(source, settingsOf(0.005));
        setThreadCount(0);
        QVERIFY(one.has_value() && five.has_value());
        QVERIFY(one->bytes == five->bytes);
        setThreadCount(1);
        const auto alone = decodeAnimation(one->bytes);
        setThreadCount(0);
        const auto together = decodeAnimation(one->bytes);
        for (std::uint32_t f = 0; f < 50; ++f)
            QVERIFY((*alone)->frame(f) == (*together)->frame(f));
    }

    // Files of released versions must decode for ever, to what they decoded to then.
    void goldenFilesDecode_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("step");
        QTest::addColumn<int>("strips");
        QTest::addColumn<QList<int>>("frames"); // that the text has
        QTest::newRow("1.0") << "reel-1.0" << 0.01 << 1 << QList{0, 1, 2, 3, 4};
        QTest::newRow("1.0, nine trajectories") << "reel-learned-1.0" << 0.0005 << 1 << QList{0, 11, 23};
        QTest::newRow("1.0, clusters") << "reel-parts-1.0" << 0.0005 << 4 << QList{0, 7, 23};
    }
    void goldenFilesDecode()
    {
        QFETCH(QString, name);
        QFETCH(double, step);
        QFETCH(int, strips);
        QFETCH(QList<int>, frames);
        QFile file(QStringLiteral(SANDREEL_SOURCE "/tests/data/anim/") + name + ".anim");
        QFile text(QStringLiteral(SANDREEL_SOURCE "/tests/data/anim/") + name + ".txt");
        QVERIFY(file.open(QIODevice::ReadOnly) && text.open(QIODevice::ReadOnly));
        const QByteArray raw = file.readAll();
        const auto decoded = decodeAnimation(Bytes(raw.begin(), raw.end()));
        QVERIFY(decoded.has_value());
        QVERIFY((*decoded)->settings() == settingsOf(step));
        QCOMPARE((*decoded)->name(), std::string("plain"));
        QCOMPARE(int((*decoded)->connectivity().triangles.size()), int((*decoded)->vertexCount()) - 2 * strips);
        const QList<QByteArray> numbers = text.readAll().replace(',', ' ').simplified().split(' ');
        qsizetype i = 0;
        for (const int f : frames)
            for (const Vec3f p : (*decoded)->frame(std::uint32_t(f)))
                for (const float x : {p.x, p.y, p.z})
                    QVERIFY(std::fabs(double(x) - numbers.at(i++).toDouble()) < 1e-6);
        QCOMPARE(i, numbers.size());
    }

    void everyPrefixIsRejected()
    {
        const Bytes file = small();
        QCOMPARE(outcomeOf(file), -1);
        for (std::size_t length = 0; length < file.size(); ++length)
            QVERIFY(!decodeAnimation(Bytes(file.begin(), file.begin() + std::ptrdiff_t(length))));
        Bytes longer = file;
        longer.push_back(0);
        QVERIFY(!decodeAnimation(longer));
    }

    void damagedPayloadsNeverCrash()
    {
        // With right checksums: what an attacker or another program could write.
        const Bytes good = small();
        for (const auto &[tag, payload] : tests::takeApart(good)) {
            for (std::size_t i = 0; i < payload.size(); ++i)
                for (const std::uint8_t change : {0x01, 0x80, 0xff})
                    QVERIFY(outcomeOf(tests::withPayload(good, tag, [&](Bytes &p) { p[i] ^= change; })) != 1000);
            // A shortened stream may happen to be another whole one; the checksum is there to tell.
            for (std::size_t length = 0; length < payload.size(); ++length)
                QVERIFY(outcomeOf(tests::withPayload(good, tag, [&](Bytes &p) { p.resize(length); })) != 1000);
            QVERIFY(outcomeOf(tests::withPayload(good, tag, [](Bytes &p) { p.push_back(7); })) != -1);
        }
    }

    void corruptedParametersHaveTheirErrors_data()
    {
        QTest::addColumn<int>("at");
        QTest::addColumn<QByteArray>("value");
        QTest::addColumn<QString>("field");
        const QByteArray infinity("\x00\x00\x00\x00\x00\x00\xf0\x7f", 8), zero(8, '\0');
        QTest::newRow("wanted step 0") << 0 << zero << "wanted step";
        QTest::newRow("wanted basis size") << 8 << QByteArray("\xff\x7f", 2) << "wanted basis size";
        QTest::newRow("step 0") << 9 << zero << "step";
        QTest::newRow("infinite step") << 9 << infinity << "step";
        QTest::newRow("infinite origin") << 19 << QByteArray("\x00\x00\x80\x7f", 4) << "origin";
        QTest::newRow("basis size") << 34 << QByteArray("\xff", 1) << "basis size";
    }
    void corruptedParametersHaveTheirErrors()
    {
        QFETCH(int, at);
        QFETCH(QByteArray, value);
        QFETCH(QString, field);
        const Bytes file = tests::withPayload(small(), "REEL", [&](Bytes &p) {
            if (field == "basis size")
                p.push_back(1); // two bytes
            for (int i = 0; i < value.size(); ++i)
                p[std::size_t(at + i)] = std::uint8_t(value[i]);
        });
        const auto decoded = decodeAnimation(file);
        QVERIFY(!decoded);
        QCOMPARE(int(decoded.error().code), int(ErrorCode::BadValue));
        QCOMPARE(QString::fromStdString(decoded.error().args.at(0)), field);
        QVERIFY(decoded.error().offset != Error::None);
    }

    void missingChunksHaveTheirErrors()
    {
        const Bytes good = small();
        for (const std::string tag : {"REEL", "CLRS", "SHAP", "BAND"}) {
            tests::RawChunks chunks = tests::takeApart(good);
            std::erase_if(chunks, [&](const auto &chunk) { return chunk.first == tag; });
            const auto decoded = decodeAnimation(tests::putTogether(chunks));
            QVERIFY(!decoded);
            QCOMPARE(int(decoded.error().code), int(ErrorCode::MissingChunk));
            QCOMPARE(decoded.error().args.at(0), tag);
        }
    }

    void memoryIsBounded()
    {
        const Bytes file = encodeAnimation(tests::waves(20, 500, 5), settingsOf(0.01))->bytes;
        DecodeLimits limits;
        limits.memoryBytes = 100000;
        QCOMPARE(int(decodeAnimation(file, Progress(), limits).error().code), int(ErrorCode::LimitExceeded));
        limits.memoryBytes = 8u << 20;
        QVERIFY(decodeAnimation(file, Progress(), limits).has_value());
    }

    void cancelStops()
    {
        const auto source = tests::waves(64, 3000, 10);
        const Bytes file = encodeAnimation(source, settingsOf(0.01))->bytes;
        for (const double at : {0.0, 0.1, 0.35, 0.5}) {
            std::shared_ptr<Progress> handle;
            handle = std::make_shared<Progress>([&](double fraction) {
                if (fraction >= at)
                    handle->cancel();
            });
            const auto encoded = encodeAnimation(source, settingsOf(0.01), *handle);
            QVERIFY(!encoded);
            QCOMPARE(int(encoded.error().code), int(ErrorCode::Cancelled));
            handle = std::make_shared<Progress>([&](double fraction) {
                if (fraction >= at)
                    handle->cancel();
            });
            const auto decoded = decodeAnimation(file, *handle);
            QVERIFY(!decoded);
            QCOMPARE(int(decoded.error().code), int(ErrorCode::Cancelled));
        }
    }
};

SANDREEL_TEST(TestReelCodec)
#include "tst_reelcodec.moc"
