// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/reel/residualmodel.h"
#include "tests/support/testmain.h"

#include <random>

using namespace model::codec;

namespace {

using Model = ResidualModel<2, 3>;

struct Sample
{
    Model::Contexts contexts;
    std::size_t set;
    std::int32_t value;
};

std::vector<Sample> samples(std::size_t count, double zeros)
{
    std::mt19937 random(1);
    std::geometric_distribution<int> size(0.4);
    std::vector<Sample> result;
    for (std::size_t i = 0; i < count; ++i) {
        const std::int32_t magnitude = random() % 1000 < zeros * 1000 ? 0 : 1 + size(random);
        result.push_back({{std::uint32_t(random() % 5), std::uint32_t(random() % 7)},
                          random() % 3,
                          random() % 2 ? magnitude : -magnitude});
    }
    return result;
}

} // namespace

class TestResidualModel final : public QObject
{
    Q_OBJECT

private slots:
    void roundTrip()
    {
        std::vector<Sample> all = samples(3000, 0.5);
        for (const std::int32_t value :
             {0, 1, -1, 16, 17, 18, -17, -18, 19, 20, 1000, -123456, MaxResidual, -MaxResidual})
            all.push_back({{4, 6}, 2, value});
        RangeEncoder encoder;
        Model writing({5, 7});
        for (const Sample &s : all)
            QCOMPARE(writing.code(encoder, s.contexts, s.set, s.value), s.value);
        const model::Bytes bytes = encoder.finish();
        RangeDecoder decoder(bytes);
        Model reading({5, 7});
        for (const Sample &s : all)
            QCOMPARE(reading.code(decoder, s.contexts, s.set), s.value);
        QVERIFY(decoder.isAtEnd());
    }

    void costIsWhatIsWritten()
    {
        const std::vector<Sample> all = samples(20000, 0.8);
        RangeEncoder encoder;
        Model model({5, 7});
        double bits = 0;
        for (const Sample &s : all) {
            bits += model.cost(s.contexts, s.set, s.value);
            model.code(encoder, s.contexts, s.set, s.value);
        }
        const double written = 8.0 * double(encoder.finish().size());
        QVERIFY2(std::fabs(written - bits) < 0.01 * written, qPrintable(QString("%1 %2").arg(written).arg(bits)));
    }

    void askingForTheCostChangesNothing()
    {
        const std::vector<Sample> all = samples(2000, 0.8);
        const auto coded = [&](bool ask) {
            RangeEncoder encoder;
            Model model({5, 7});
            for (const Sample &s : all) {
                if (ask)
                    for (const std::int32_t other : {0, 3, 40})
                        model.cost(s.contexts, s.set, other);
                model.code(encoder, s.contexts, s.set, s.value);
            }
            return encoder.finish();
        };
        QVERIFY(coded(true) == coded(false));
    }

    void learnsWhatIsRare()
    {
        // One in a hundred: 0.081 bits of entropy each, and the sign.
        std::mt19937 random(2);
        RangeEncoder encoder;
        Model model({5, 7});
        for (int i = 0; i < 100000; ++i)
            model.code(encoder, {0, 0}, 0, random() % 100 == 0 ? 1 : 0);
        const double bits = 8.0 * double(encoder.finish().size()) / 100000;
        QVERIFY2(bits < 1.06 * (0.0808 + 0.01), qPrintable(QString::number(bits)));
    }

    void anyBytesEnd()
    {
        std::mt19937 random(4);
        for (int round = 0; round < 50; ++round) {
            model::Bytes bytes(random() % 40);
            for (auto &b : bytes)
                b = std::uint8_t(random());
            RangeDecoder decoder(bytes);
            Model model({5, 7});
            for (int i = 0; i < 300; ++i) {
                const std::int32_t value = model.code(decoder, {1, 2}, 0);
                QVERIFY(std::abs(std::int64_t(value)) <= std::int64_t(MaxResidual) + 17);
            }
        }
    }
};

SANDREEL_TEST(TestResidualModel)
#include "tst_residualmodel.moc"
