// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/entropy/countedinteger.h"
#include "model/codec/entropy/integercoder.h"
#include "model/codec/entropy/rangecoder.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <limits>
#include <random>

using namespace model;
using namespace model::codec;

namespace {

struct Decision
{
    unsigned model = 0; ///< 8: direct
    std::uint32_t value = 0;
    unsigned count = 0;
};

std::vector<Decision> decisions(double probabilityOfOne, std::size_t count, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<Decision> result;
    for (std::size_t i = 0; i < count; ++i) {
        const bool one = random() < probabilityOfOne * 4294967296.0;
        if (random() % 16 == 0) {
            const unsigned bits = 1 + random() % MaxDirectBits;
            result.push_back({8, std::uint32_t(random() & ((1u << bits) - 1)), bits});
        } else {
            result.push_back({unsigned(i % 8), one, 0});
        }
    }
    return result;
}

Bytes encode(const std::vector<Decision> &all)
{
    RangeEncoder coder;
    std::array<AdaptiveBit, 8> models;
    for (const Decision &d : all)
        d.model == 8 ? coder.direct(d.count, d.value) : coder.bit(models[d.model], d.value);
    return coder.finish();
}

/// True if the stream decodes to exactly these and ends there.
bool decodesTo(std::span<const std::uint8_t> stream, const std::vector<Decision> &all)
{
    const Bytes own(stream.begin(), stream.end()); // of its own, so that reading past it is seen
    RangeDecoder coder(own);
    std::array<AdaptiveBit, 8> models;
    bool same = true;
    for (const Decision &d : all)
        same = (d.model == 8 ? coder.direct(d.count) : coder.bit(models[d.model])) == d.value && same;
    return same && coder.isAtEnd();
}

template <unsigned ClassBits>
void checkIntegers(const std::vector<std::int64_t> &values)
{
    RangeEncoder encoder;
    IntegerModels<ClassBits> models;
    for (std::size_t i = 0; i < values.size(); ++i)
        codeInteger(encoder, models, unsigned(i % SizeContexts), unsigned(i % 3), values[i]);
    const Bytes stream = encoder.finish();
    RangeDecoder decoder(stream);
    models = {};
    for (std::size_t i = 0; i < values.size(); ++i)
        QCOMPARE(qint64(codeInteger(decoder, models, unsigned(i % SizeContexts), unsigned(i % 3))), qint64(values[i]));
    QVERIFY(decoder.isAtEnd());
}

} // namespace

class TestRangeCoder final : public QObject
{
    Q_OBJECT

private slots:
    void streamsCanEndAnywhere()
    {
        for (const double p : {0.5, 0.02, 0.999}) {
            const std::vector<Decision> all = decisions(p, 3000, 5);
            const Bytes stream = encode(all);
            RangeDecoder coder(stream);
            std::array<AdaptiveBit, 8> models;
            for (std::size_t i = 0; !coder.hasReadPastEnd(); ++i) {
                // As if the encoder had stopped there.
                const Bytes ended = coder.endedHere();
                const std::vector<Decision> first(all.begin(), all.begin() + std::ptrdiff_t(i));
                if (i % 16 == 0)
                    QVERIFY(ended == encode(first));
                QVERIFY(decodesTo(ended, first));
                if (i == all.size())
                    break;
                all[i].model == 8 ? coder.direct(all[i].count) : coder.bit(models[all[i].model]);
            }
        }
    }

    void streamsCanComeInPieces()
    {
        // Nothing is decided by bytes that have not come, nor read twice.
        const std::vector<Decision> all = decisions(0.1, 2000, 9);
        const Bytes stream = encode(all);
        Bytes there(stream.begin(), stream.begin() + 4);
        RangeDecoder coder(there);
        std::array<AdaptiveBit, 8> models;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const RangeDecoder before = coder;
            const auto modelsBefore = models;
            const auto decode = [&] {
                return all[i].model == 8 ? coder.direct(all[i].count) : coder.bit(models[all[i].model]);
            };
            std::uint32_t value = decode();
            while (coder.hasReadPastEnd() && there.size() < stream.size()) {
                const Bytes longer(stream.begin(), stream.begin() + std::ptrdiff_t(there.size() + 1));
                there = longer; // elsewhere in memory
                coder = before;
                coder.extend(there);
                models = modelsBefore;
                value = decode();
            }
            QCOMPARE(value, all[i].value);
        }
        QVERIFY(coder.isAtEnd());
        QVERIFY(there == stream);
    }

    void roundTrip_data()
    {
        QTest::addColumn<double>("probability");
        QTest::addColumn<int>("count");
        for (const double p : {0.0, 0.001, 0.3, 0.5, 0.97, 1.0})
            for (const int n : {0, 1, 2, 17, 20000})
                QTest::addRow("%g of %d", p, n) << p << n;
    }
    void roundTrip()
    {
        QFETCH(double, probability);
        QFETCH(int, count);
        for (unsigned seed = 0; seed < 20; ++seed) {
            const auto all = decisions(probability, std::size_t(count), seed);
            QVERIFY(decodesTo(encode(all), all));
        }
    }

    void carryRunsThroughManyBytes()
    {
        // Direct bits of ones push low towards the top of its range; a one in a model then tips it over.
        std::vector<Decision> all;
        for (unsigned i = 0; i < 4000; ++i) {
            all.push_back({8, 0xfff, 12});
            if (i % 50 == 49)
                all.push_back({0, i % 100 == 99, 0});
        }
        QVERIFY(decodesTo(encode(all), all));
    }

    void everyPrefixAndExtensionIsRejected()
    {
        const auto all = decisions(0.2, 300, 7);
        Bytes stream = encode(all);
        for (std::size_t length = 0; length < stream.size(); ++length)
            QVERIFY(!decodesTo(std::span(stream).first(length), all));
        for (const std::uint8_t extra : {0x00, 0x01, 0x80, 0xff}) {
            stream.push_back(extra);
            QVERIFY(!decodesTo(stream, all));
            stream.pop_back();
        }
    }

    void anyBytesEndInAnError()
    {
        std::mt19937 random(3);
        for (int i = 0; i < 200; ++i) {
            Bytes garbage(random() % 40);
            for (auto &byte : garbage)
                byte = std::uint8_t(random());
            RangeDecoder coder(garbage);
            AdaptiveBit model;
            for (int n = 0; n < 2000 && !coder.isBad(); ++n)
                n % 3 ? coder.bit(model) : coder.direct(1 + random() % MaxDirectBits);
            QVERIFY(coder.isBad());
        }
        const Bytes top(8, 0xff); // code == range
        QVERIFY(RangeDecoder(top).isBad());
    }

    void skewedDecisionsCostAboutTheirEntropy()
    {
        constexpr std::size_t Count = 100000;
        constexpr double P = 0.05;
        std::mt19937 random(5);
        RangeEncoder coder;
        AdaptiveBit model;
        for (std::size_t i = 0; i < Count; ++i)
            coder.bit(model, random() < P * 4294967296.0);
        const double entropy = -P * std::log2(P) - (1 - P) * std::log2(1 - P);
        QVERIFY(8.0 * double(coder.finish().size()) < 1.06 * entropy * Count);
    }

    void probabilitiesStayInside()
    {
        for (const std::uint32_t bit : {0u, 1u}) {
            AdaptiveBit model;
            for (int i = 0; i < 10000; ++i)
                model.update(bit);
            QCOMPARE(model.probabilityOfOne(), bit ? 32732u : 35u);
        }
    }

    void integersOfAllSizes()
    {
        std::vector<std::int64_t> narrow{0, 1, -1, 2, -2, 3, 4, 7, 8, 4095, 4096, -4097};
        for (int i = 0; i < 31; ++i)
            for (const std::int64_t d : {-1, 0})
                narrow.push_back((i % 2 ? 1 : -1) * ((std::int64_t(1) << i) + d));
        narrow.push_back((std::int64_t(1) << 31) - 1);
        narrow.push_back(-((std::int64_t(1) << 31) - 1));
        checkIntegers<5>(narrow);
        std::vector<std::int64_t> wide = narrow;
        wide.push_back(std::numeric_limits<std::int64_t>::max());
        wide.push_back(-std::numeric_limits<std::int64_t>::max());
        checkIntegers<6>(wide);
    }

    void countedIntegersOfAllSizes()
    {
        constexpr std::int64_t Largest = (std::int64_t(1) << 34) - 1;
        std::vector<std::int64_t> values{0, 1, -1, 2, -3, Largest, -Largest, Largest, 0};
        for (unsigned bits = 1; bits < 34; ++bits)
            for (const std::int64_t near : {-1, 0, 1})
                values.push_back(((std::int64_t(1) << bits) + near) * (bits % 2 == 0 ? 1 : -1));
        RangeEncoder encoder;
        CountedInteger writtenSigned, writtenCount;
        for (const std::int64_t value : values) {
            writtenSigned.codeSigned(encoder, value);
            writtenCount.codeCount(encoder, std::abs(value));
        }
        const Bytes bytes = encoder.finish();
        RangeDecoder decoder(bytes);
        CountedInteger readSigned, readCount;
        for (const std::int64_t value : values) {
            QCOMPARE(readSigned.codeSigned(decoder, 0), value);
            QCOMPARE(readCount.codeCount(decoder, 0), std::abs(value));
        }
        QVERIFY(decoder.isAtEnd());
    }

    /// Whatever the bytes are, the integers stay within their bounds: nothing that adds 32-bit numbers to them
    /// overflows.
    void countedIntegersOfAnyBytes()
    {
        std::mt19937 random(5);
        for (int round = 0; round < 200; ++round) {
            Bytes bytes(64);
            for (std::uint8_t &byte : bytes)
                byte = round == 0 ? 0 : std::uint8_t(random());
            RangeDecoder decoder(bytes);
            CountedInteger integers, counts;
            while (!decoder.isBad()) {
                QVERIFY(std::abs(integers.codeSigned(decoder, 0)) < std::int64_t(1) << 34);
                const std::int64_t count = counts.codeCount(decoder, 0);
                QVERIFY(count >= 0 && count < std::int64_t(1) << 34);
            }
        }
    }

    /// What is there only a few times is learned at once: a value that comes again and again costs little from the
    /// third time on, and decisions in which nothing can be learned cost hardly more than one bit.
    void countedModelsLearnQuickly()
    {
        RangeEncoder encoder;
        CountedInteger lengths;
        for (int i = 0; i < 100; ++i)
            lengths.codeCount(encoder, 12);
        QVERIFY(encoder.finish().size() <= 10);
        RangeEncoder coins;
        CountedBit coin;
        std::mt19937 random(1);
        for (int i = 0; i < 80000; ++i)
            codeCounted(coins, coin, random() & 1);
        QVERIFY(coins.finish().size() < 10030);
    }

    void sizesMapToRisingContexts()
    {
        const unsigned expected[] = {0, 1, 2, 3, 4, 4, 5, 5, 6, 6, 6, 6, 7};
        for (unsigned i = 0; i < std::size(expected); ++i)
            QCOMPARE(sizeContext(i), expected[i]);
        QCOMPARE(sizeContext(std::numeric_limits<std::uint64_t>::max()), SizeContexts - 1);
    }
};

SANDREEL_TEST(TestRangeCoder)
#include "tst_rangecoder.moc"
