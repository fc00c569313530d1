// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/settingsfields.h"

#include "tests/support/testmain.h"

#include <limits>
#include <set>

using namespace model;

/// The list of the fields of each codec's settings, and their texts.
class TestSettingsFields final : public QObject
{
    Q_OBJECT

private:
    static std::set<std::string> keysOf(CodecSettings method)
    {
        std::set<std::string> keys;
        visitFields(method, [&](const auto &field, const auto &) { keys.emplace(field.key); });
        return keys;
    }

private slots:
    void eachCodecHasItsOwnFields()
    {
        using Keys = std::set<std::string>;
        QVERIFY(keysOf(DirectSettings()) == (Keys{"resolution", "predictor", "entropy"}));
        QVERIFY(keysOf(PcaSettings()) == (Keys{"basis", "resolution"}));
        QVERIFY(keysOf(CoddyacSettings()) == (Keys{"basis", "step", "basis-step"}));
        QVERIFY(keysOf(ReelSettings()) == (Keys{"basis", "step"}));
    }

    void defaultsAreOfTheirCodecAndAllowed()
    {
        for (const CodecId codec : {CodecId::Direct, CodecId::Pca, CodecId::Coddyac, CodecId::Reel}) {
            CodecSettings method = defaultSettings(codec);
            QVERIFY(CompressionSettings{method}.codec() == codec);
            visitFields(method, [](const auto &field, const auto &value) { QVERIFY(field.allows(value)); });
            QVERIFY(codecOfKey(codecKey(codec)) == codec);
        }
        QVERIFY(!codecOfKey("zip") && !codecOfKey(""));
    }

    void endsOfARangeBelongToIt()
    {
        CodecSettings method = PcaSettings();
        visitFields(method, [](const auto &field, auto value) {
            using Value = decltype(value);
            QVERIFY(field.allows(field.least) && field.allows(field.most));
            if constexpr (std::is_arithmetic_v<Value>) {
                QVERIFY(!field.allows(Value(field.most + 1)));
                QVERIFY(!field.allows(Value(field.least / 2)));
            }
            if constexpr (std::is_floating_point_v<Value>)
                QVERIFY(!field.allows(std::numeric_limits<Value>::quiet_NaN()));
        });
    }

    void textsAreReadBack_data()
    {
        QTest::addColumn<QString>("text");
        const auto row = [](const char *text) { QTest::newRow(text) << QString(text); };
        row("direct resolution=16384 predictor=B entropy=deflate");
        row("direct resolution=1 predictor=none entropy=range");
        row("direct resolution=16777216 predictor=N entropy=range");
        row("pca basis=1 resolution=1234.5");
        row("pca basis=20 resolution=10000 keep-order");
        row("coddyac basis=7 step=0.001 basis-step=1e-05");
        row("reel step=0.1 basis=0 keep-order");
    }
    void textsAreReadBack()
    {
        QFETCH(QString, text);
        const auto settings = settingsFromText(text.toStdString());
        QVERIFY(settings.has_value());
        QCOMPARE(QString::fromStdString(settingsText(*settings)), text);
    }

    void valuesAreThoseOfTheText()
    {
        const CompressionSettings direct{DirectSettings{77, Predictor::Accelerating, Entropy::Deflate}, true};
        QVERIFY(settingsFromText("DIRECT predictor=c entropy=Deflate keep-order resolution=77") == direct);
        QVERIFY(settingsFromText("coddyac step=0.25") == (CompressionSettings{CoddyacSettings{40, 0.25}}));
        QVERIFY(settingsFromText("pca") == CompressionSettings{PcaSettings()});
    }

    void otherTextsAreRefused()
    {
        for (const char *text : {"", "zip", "pca basis", "pca basis=", "pca basis=0", "pca basis=1001", "pca basis=1.5",
                                 "pca basis=-1", "pca step=0.1", "pca resolution=nan", "pca resolution=1e8",
                                 "pca basis=5x", "direct predictor=D", "direct entropy=0", "reel keep", "pca  basis=5"})
            QVERIFY2(!settingsFromText(text), text);
    }
};

SANDREEL_TEST(TestSettingsFields)
#include "tst_settingsfields.moc"
