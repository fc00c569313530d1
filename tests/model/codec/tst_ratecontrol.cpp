// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/codec/ratecontrol.h"
#include "tests/model/codec/animations.h"
#include "tests/support/testmain.h"

#include <limits>

using namespace model;
using namespace model::codec;

class TestRateControl final : public QObject
{
    Q_OBJECT

private slots:
    void qualityIsAKgError()
    {
        QCOMPARE(kgErrorOfQuality(0), 10.0);
        QVERIFY(std::fabs(kgErrorOfQuality(1) - 0.05) < 1e-12);
        QVERIFY(std::fabs(kgErrorOfQuality(0.5) - std::sqrt(10 * 0.05)) < 1e-12);
        for (double quality = 0; quality < 1; quality += 0.01) {
            QVERIFY(kgErrorOfQuality(quality) > kgErrorOfQuality(quality + 0.01));
            QVERIFY(std::fabs(qualityOfKgError(kgErrorOfQuality(quality)) - quality) < 1e-12);
        }
    }

    // What a trial says is what an encoder makes and a decoder shows.
    void trialsTellTheTruth_data() { addCodecs(); }
    void trialsTellTheTruth()
    {
        QFETCH(int, codec);
        const auto source = tests::waves(40, 600, 12);
        const auto encoder = prepareTrials(source, CodecId(codec), Progress());
        QVERIFY(encoder.has_value());
        for (std::size_t family = 0; family < (*encoder)->familyCount(); family += 3)
            for (const double fineness : {0.1, 0.4, 0.7}) {
                const CompressionSettings settings{(*encoder)->settingsAt(family, fineness)};
                QCOMPARE(int(settings.codec()), codec);
                const auto trial = (*encoder)->attempt(settings.method, Progress());
                const auto encoded = encodeAnimation(source, settings);
                QVERIFY(trial.has_value() && encoded.has_value());
                // The analysis for many trials may round otherwise than that for one.
                QVERIFY(std::fabs(double(trial->bytes) / double(encoded->bytes.size()) - 1) < 0.01);
                const double measured = tests::kgErrorPercent(tests::reordered(source, encoded->permutation),
                                                              **decodeAnimation(encoded->bytes));
                QVERIFY2(std::fabs(trial->kgErrorPercent - measured) < 0.01 * measured + 2e-5,
                         qPrintable(QString("%1 for %2").arg(trial->kgErrorPercent).arg(measured)));
                if (const auto quick = (*encoder)->quickKgError(settings.method, Progress()))
                    QCOMPARE(**quick, trial->kgErrorPercent);
            }
    }

    void finerIsLargerAndMoreExact_data() { addCodecs(); }
    void finerIsLargerAndMoreExact()
    {
        QFETCH(int, codec);
        const auto source = tests::waves(40, 600, 12);
        const auto encoder = std::move(*prepareTrials(source, CodecId(codec), Progress()));
        const std::size_t last = encoder->familyCount() - 1;
        const Trial coarsest = *encoder->attempt(encoder->settingsAt(last, 0), Progress());
        Trial before = coarsest;
        for (double fineness = 0.1; fineness <= 0.8; fineness += 0.1) {
            const Trial trial = *encoder->attempt(encoder->settingsAt(last, fineness), Progress());
            // Where nearly everything is rounded away, a little chance is left.
            QVERIFY(double(trial.bytes) > 0.99 * double(before.bytes));
            QVERIFY(trial.kgErrorPercent < 1.05 * before.kgErrorPercent);
            before = trial;
        }
        QVERIFY(before.bytes > 3 * coarsest.bytes && before.kgErrorPercent < 0.01 * coarsest.kgErrorPercent);
    }

    void targetsAreMet_data()
    {
        QTest::addColumn<int>("codec");
        QTest::addColumn<double>("value");
        QTest::addColumn<int>("kind");
        for (const CodecId codec : availableCodecs()) {
            for (const double percent : {8.0, 1.0, 0.1})
                QTest::addRow("%d: KG %g", int(codec), percent) << int(codec) << percent << 0;
            for (const double fraction : {0.05, 0.002})
                QTest::addRow("%d: vertex %g", int(codec), fraction) << int(codec) << fraction << 1;
            // The finest file of `reel` has 15 kB.
            for (const double bytes : {12000.0, codec == CodecId::Reel ? 9000.0 : 30000.0})
                QTest::addRow("%d: %g bytes", int(codec), bytes) << int(codec) << bytes << 2;
            QTest::addRow("%d: quality", int(codec)) << int(codec) << 0.6 << 3;
        }
    }
    void targetsAreMet()
    {
        QFETCH(int, codec);
        QFETCH(double, value);
        QFETCH(int, kind);
        const auto source = tests::waves(60, 800, 12);
        const QualityTarget target = kind == 0   ? QualityTarget(MaxKgError{value})
                                     : kind == 1 ? QualityTarget(MaxVertexError{value})
                                     : kind == 2 ? QualityTarget(MaxBytes{std::uint64_t(value)})
                                                 : QualityTarget(Quality{value});
        const auto result = encodeToTarget(source, CodecId(codec), false, target);
        QVERIFY2(result.has_value(), result ? "" : result.error().args.at(2).c_str());
        QCOMPARE(int(result->settings.codec()), codec);
        const auto decoded = *decodeAnimation(result->encoded.bytes);
        const double error = tests::kgErrorPercent(tests::reordered(source, result->encoded.permutation), *decoded);
        QVERIFY(std::fabs(error - result->errors.kgErrorPercent) < 1e-6 * error);
        const double reached = kind == 0   ? error / value
                               : kind == 1 ? result->errors.maxVertexError / result->errors.diagonal / value
                               : kind == 2 ? double(result->encoded.bytes.size()) / value
                                           : error / kgErrorOfQuality(value);
        // Met, and not by much more than is needed.
        const double least = kind == 1 ? 0.8 : value > 5 ? 0.85 : 0.95; // with few trajectories, errors come in jumps
        QVERIFY2(reached <= 1 && reached > least, qPrintable(QString::number(reached)));
    }

    void sameTargetSameBytes()
    {
        const auto source = tests::waves(30, 300, 8);
        setThreadCount(1);
        const auto one = encodeToTarget(source, CodecId::Pca, false, MaxKgError{1});
        setThreadCount(3);
        const auto three = encodeToTarget(source, CodecId::Pca, false, MaxKgError{1});
        setThreadCount(0);
        QVERIFY(one->encoded.bytes == three->encoded.bytes);
    }

    void theSearchFindsTheBestFamily()
    {
        // All families, all the way: slow, and what the search must come close to.
        const auto source = tests::waves(60, 800, 12);
        const double percent = 1;
        const auto encoder = std::move(*prepareTrials(source, CodecId::Pca, Progress()));
        std::uint64_t smallest = std::numeric_limits<std::uint64_t>::max();
        for (std::size_t family = 0; family < encoder->familyCount(); ++family)
            for (double fineness = 0; fineness <= 0.8; fineness += 0.01)
                if (const Trial trial = *encoder->attempt(encoder->settingsAt(family, fineness), Progress());
                    trial.kgErrorPercent <= percent) {
                    smallest = std::min(smallest, trial.bytes);
                    break;
                }
        std::vector<Trial> trials;
        const auto found = searchSettings(*encoder, MaxKgError{percent}, Progress(),
                                          [&](const Trial &trial) { trials.push_back(trial); });
        QVERIFY(double(found->bytes) < 1.02 * double(smallest));
        QVERIFY(trials.size() > 4 && trials.size() < 100);
        const auto isFound = [&](const Trial &t) { return t.settings == found->settings && t.bytes == found->bytes; };
        QVERIFY(std::any_of(trials.begin(), trials.end(), isFound));
    }

    void whatCannotBeReachedIsSaid_data() { addCodecs(); }
    void whatCannotBeReachedIsSaid()
    {
        QFETCH(int, codec);
        const auto source = tests::waves(30, 300, 8);
        const QualityTarget targets[] = {MaxBytes{100}, MaxKgError{0}, MaxKgError{101},   MaxKgError{std::nan("")},
                                         Quality{-0.1}, Quality{1.1},  MaxVertexError{0}, MaxVertexError{2}};
        for (const QualityTarget &target : targets) {
            const auto result = encodeToTarget(source, CodecId(codec), false, target);
            QVERIFY(!result);
            QCOMPARE(int(result.error().code), int(ErrorCode::BadSetting));
            QCOMPARE(result.error().args.size(), std::size_t(3));
        }
    }

    void errorBeyondTheCodecIsSaid()
    {
        // Noise that no small basis holds.
        const tests::PlainAnimation noise(200, 700, tests::strip(700), [](std::uint32_t f, std::uint32_t v) {
            const std::uint32_t x = (f * 7919 + v) * 2654435761u;
            return Vec3f{float(x >> 20), float((x * 31) >> 20), float((x * 977) >> 20)};
        });
        const auto result = encodeToTarget(noise, CodecId::Pca, false, MaxKgError{0.1});
        QVERIFY(!result);
        QCOMPARE(result.error().args.at(0), std::string("largest KG error"));
        QVERIFY(QString::fromStdString(result.error().args.at(2)).startsWith("from a KG error of "));
    }

    void emptyAnimationsAndUnknownCodecsAreRefused()
    {
        const tests::PlainAnimation noVertices(3, 0, {}, [](auto, auto) { return Vec3f{}; });
        QCOMPARE(int(prepareTrials(noVertices, CodecId::Pca, Progress()).error().code), int(ErrorCode::NoVertices));
        const auto source = tests::waves(3, 9, 1);
        QCOMPARE(int(prepareTrials(source, CodecId(77), Progress()).error().code), int(ErrorCode::UnknownCodec));
    }

    void stillAnimationsNeedNothing()
    {
        const tests::PlainAnimation still(5, 4, tests::strip(4), [](auto, std::uint32_t v) {
            return Vec3f{float(v), float(v % 2), 0};
        });
        for (const CodecId codec : availableCodecs())
            QVERIFY(encodeToTarget(still, codec, false, MaxKgError{1}).has_value());
        const tests::PlainAnimation point(5, 1, {}, [](auto, auto) { return Vec3f{1, 2, 3}; });
        for (const CodecId codec : availableCodecs())
            QVERIFY(encodeToTarget(point, codec, false, MaxKgError{1}).has_value());
    }

    void cancelStops_data() { addCodecs(); }
    void cancelStops()
    {
        QFETCH(int, codec);
        const auto source = tests::waves(60, 800, 12);
        for (const double at : {0.0, 0.1, 0.3, 0.5}) {
            std::shared_ptr<Progress> handle;
            handle = std::make_shared<Progress>([&](double fraction) {
                if (fraction >= at)
                    handle->cancel();
            });
            const auto result = encodeToTarget(source, CodecId(codec), false, MaxKgError{1}, *handle);
            QVERIFY(!result);
            QCOMPARE(int(result.error().code), int(ErrorCode::Cancelled));
        }
    }

private:
    static void addCodecs()
    {
        QTest::addColumn<int>("codec");
        for (const CodecId codec : availableCodecs())
            QTest::addRow("%d", int(codec)) << int(codec);
    }
};

SANDREEL_TEST(TestRateControl)
#include "tst_ratecontrol.moc"
