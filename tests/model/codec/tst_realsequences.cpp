// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/animationcodec.h"
#include "model/codec/container/progressivereader.h"
#include "tests/model/codec/animations.h"
#include "tests/support/realdata.h"
#include "tests/support/testmain.h"

#include <cmath>

using namespace model;
using namespace model::codec;

class TestRealSequences final : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { SANDREEL_REQUIRE_DATA(); }

    // KG error in per cent and size in bits per frame and vertex, basis 20, resolution 10000, in the cube; a few per
    // cent above what was measured for model/codec/README.md.
    void errorAndSize_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("largestError");
        QTest::addColumn<double>("largestSize");
        QTest::newRow("chicken") << "chicken" << 3.45 << 0.75;
        QTest::newRow("cow") << "cow" << 1.83 << 1.52;
        QTest::newRow("dance") << "dance" << 1.20 << 1.24;
        QTest::newRow("samba") << "samba" << 1.78 << 1.78;
    }
    void errorAndSize()
    {
        QFETCH(QString, name);
        QFETCH(double, largestError);
        QFETCH(double, largestSize);
        const auto source = tests::normalised(*tests::readPointCache(tests::sequenceFolder(name).toStdString()));
        QVERIFY(source.vertexCount() > 1000);
        const CompressionSettings settings{PcaSettings{20, 10000}};
        const auto encoded = encodeAnimation(source, settings);
        QVERIFY(encoded.has_value());
        const auto decoded = decodeAnimation(encoded->bytes);
        QVERIFY(decoded.has_value());
        QVERIFY((*decoded)->connectivity() == source.connectivity());
        const double error = tests::kgErrorPercent(source, **decoded);
        const double size = 8.0 * double(encoded->bytes.size()) / source.frameCount() / source.vertexCount();
        QVERIFY2(error > 0 && error < largestError, qPrintable(QString::number(error)));
        QVERIFY2(size < largestSize, qPrintable(QString::number(size)));
    }

    void aReelFileShowsMoreWithEachByte()
    {
        const auto source = tests::normalised(*tests::readPointCache(tests::sequenceFolder("dance").toStdString()));
        const auto encoded = encodeAnimation(source, {ReelSettings()});
        QVERIFY(encoded.has_value());
        const auto expected = tests::reordered(source, encoded->permutation);
        ProgressiveReader reader;
        double before = INFINITY;
        for (const std::size_t percent : {10, 20, 40, 60, 80, 100}) {
            const std::size_t end = encoded->bytes.size() * percent / 100;
            const std::size_t start = std::size_t(reader.bytesRead());
            QVERIFY(reader.append(std::span(encoded->bytes).subspan(start, end - start)).has_value());
            if (!reader.isPlayable()) {
                qInfo("%3zu %% of the bytes: nothing to show", percent);
                continue;
            }
            const double error = tests::kgErrorPercent(expected, *reader.animation());
            qInfo("%3zu %% of the bytes: %u of %u trajectories, KG error %.3f %%", percent, reader.bandCount(),
                  reader.bandsInFile(), error);
            QVERIFY(error < before);
            before = error;
        }
        QVERIFY2(before < 1.3, qPrintable(QString::number(before)));
    }
};

SANDREEL_TEST(TestRealSequences)
#include "tst_realsequences.moc"
