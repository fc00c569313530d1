// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/codec/animationcodec.h"
#include "tests/model/codec/animations.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <thread>

using namespace model;
using namespace model::codec;

class TestPcaCodec final : public QObject
{
    Q_OBJECT

private slots:
    void roundTrip_data()
    {
        QTest::addColumn<int>("row");
        const auto table = tests::animationTable();
        for (std::size_t i = 0; i < table.size(); ++i)
            QTest::newRow(table[i].name.c_str()) << int(i);
    }
    void roundTrip()
    {
        QFETCH(int, row);
        const auto entry = tests::animationTable()[std::size_t(row)];
        const FrameSource &source = *entry.animation;
        CompressionSettings settings;
        settings.basisSize = 60;
        settings.resolution = 1e5;
        const auto encoded = encodeAnimation(source, settings);
        QVERIFY(encoded.has_value());
        const auto decoded = decodeAnimation(encoded->bytes);
        QVERIFY(decoded.has_value());
        const DecodedAnimation &animation = **decoded;
        QCOMPARE(animation.frameCount(), source.frameCount());
        QVERIFY(animation.connectivity() == source.connectivity());
        QCOMPARE(animation.frameRate(), 24.0);
        QCOMPARE(animation.name(), std::string("plain"));
        QVERIFY(animation.settings() == settings);
        QVERIFY(animation.encoded() == encoded->bytes);
        // Half a unit in the last place of the largest coordinate comes on top of the quantisation.
        const double bound = 1e-3 + (entry.name == "far from the origin" ? 0.25 : 0);
        QVERIFY2(tests::largestError(source, animation) < bound,
                 qPrintable(QString::number(tests::largestError(source, animation))));
    }
};

SANDREEL_TEST(TestPcaCodec)
#include "tst_pcacodec.moc"
