// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/textnumber.h"
#include "tests/support/testmain.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <string>

using namespace model::io;

namespace {

/// Bit for bit what std::from_chars reads, at the same length.
bool readsLikeFromChars(const std::string &text)
{
    float fast = 7, expected = 7;
    const char *const end = text.data() + text.size();
    const char *const after = parseFloat(text.data(), end, fast);
    const auto [expectedAfter, error] = std::from_chars(text.data(), end, expected);
    if (error == std::errc::invalid_argument)
        return after == nullptr;
    if (error == std::errc::result_out_of_range) {
        double wide = 0;
        std::from_chars(text.data(), end, wide);
        expected = float(wide);
    }
    return after == expectedAfter && std::bit_cast<std::uint32_t>(fast) == std::bit_cast<std::uint32_t>(expected);
}

template <class Number>
std::string written(Number value, std::chars_format format, int precision)
{
    char buffer[400];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, format, precision).ptr};
}

std::string shortest(float value)
{
    char buffer[40];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

} // namespace

class TestTextNumber final : public QObject
{
    Q_OBJECT

private slots:
    void fixedNotationReadsLikeFromChars()
    {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> coordinate(-1000, 1000);
        for (int i = 0; i < 400'000; ++i) {
            const std::string text = written(coordinate(random), std::chars_format::fixed, i % 19);
            QVERIFY2(readsLikeFromChars(text), text.c_str());
        }
    }

    void everyKindOfFloatReadsLikeFromChars()
    {
        std::mt19937 random(2);
        for (int i = 0; i < 400'000; ++i) {
            const auto value = std::bit_cast<float>(std::uint32_t(random()));
            if (!std::isfinite(value))
                continue;
            const std::string text = shortest(value);
            QVERIFY2(readsLikeFromChars(text), text.c_str());
            const std::string exponent = written(value, std::chars_format::scientific, i % 20);
            QVERIFY2(readsLikeFromChars(exponent), exponent.c_str());
        }
    }

    /// Where rounding twice goes wrong: on and just beside the middle of two floats.
    void middlesOfTwoFloatsReadLikeFromChars()
    {
        std::mt19937 random(3);
        for (int i = 0; i < 100'000; ++i) {
            const auto low = std::bit_cast<float>(std::uint32_t(random()) & 0x7FFFFFFF);
            const float high = std::nextafter(low, std::numeric_limits<float>::infinity());
            if (!std::isfinite(low) || !std::isfinite(high))
                continue;
            const double middle = (double(low) + double(high)) / 2;
            for (const double value : {middle, std::nextafter(middle, 0.0), std::nextafter(middle, 1e300)}) {
                for (const int precision : {8, 12, 15, 16, 17, 25}) {
                    const std::string text = written(value, std::chars_format::scientific, precision);
                    QVERIFY2(readsLikeFromChars(text), text.c_str());
                    const std::string negative = '-' + text;
                    QVERIFY2(readsLikeFromChars(negative), negative.c_str());
                }
            }
            if (low > 1e-6f && low < 1e6f) {
                const std::string exact = written(middle, std::chars_format::fixed, 60);
                QVERIFY2(readsLikeFromChars(exact), exact.c_str());
            }
        }
    }

    void integersReadLikeFromChars()
    {
        for (std::uint64_t base : {0ull, 1ull << 24, 1ull << 25, 1ull << 53, 1ull << 63, 999'999'999'999'999'990ull}) {
            for (std::uint64_t i = 0; i < 5000; ++i) {
                const std::string text = std::to_string(base + i);
                QVERIFY2(readsLikeFromChars(text), text.c_str());
            }
        }
    }

    void oddFormsReadLikeFromChars()
    {
        for (const char *const text : {"0",
                                       "-0",
                                       "0.0",
                                       "-0.000",
                                       "00012.5",
                                       ".5",
                                       "-.5",
                                       "5.",
                                       ".",
                                       "-",
                                       "",
                                       "e5",
                                       ".e5",
                                       "1e",
                                       "1e+",
                                       "1e-",
                                       "1.5e",
                                       "1e5",
                                       "1E5",
                                       "1e+5",
                                       "1e-5",
                                       "1e00005",
                                       "1e000000000005",

                                       "1.5x",
                                       "1,5",
                                       "0x10",
                                       "1e5e5",
                                       "1.2.3",
                                       "nan",
                                       "NaN",
                                       "inf",
                                       "-inf",
                                       "infinity",
                                       "nan(x)",
                                       "1e38",
                                       "3.4028235e38",
                                       "3.4028236e38",
                                       "1e39",
                                       "-1e39",
                                       "1e-37",
                                       "1e-38",
                                       "1e-45",
                                       "1e-46",
                                       "-1e-46",
                                       "0e999",
                                       "0.00000000000000000000000000000000000000001",
                                       "123456789012345678901234567890",
                                       "0.123456789012345678901234567890",
                                       "1-2",
                                       "--1",
                                       "12345678",
                                       "123456789",
                                       "1.12345678",
                                       "1.1234567812345678",
                                       "1.123456781234567812345678"})
            QVERIFY2(readsLikeFromChars(text), text);
    }

    void beyondDoubleIsZeroOrInfinite()
    {
        const auto value = [](const std::string &text) {
            float result = 7;
            return parseFloat(text.data(), text.data() + text.size(), result) == text.data() + text.size() ? result : 7;
        };
        QCOMPARE(value("1e-400"), 0.0f);
        QVERIFY(std::signbit(value("-1e-400")));
        QCOMPARE(value("0." + std::string(500, '0') + "1"), 0.0f);
        QVERIFY(std::isinf(value("1e400")));
        QVERIFY(std::isinf(value("1e99999999999")));
        QVERIFY(std::isinf(value(std::string(500, '9'))));
        QVERIFY(value("-1e400") < 0);
    }

    void plusIsRead()
    {
        float value = 0;
        const std::string text = "+1.5";
        QVERIFY(parseFloat(text.data(), text.data() + text.size(), value));
        QCOMPARE(value, 1.5f);
        const std::string two = "+-1";
        QVERIFY(!parseFloat(two.data(), two.data() + two.size(), value));
    }

    /// In memory of the exact size, so that the address sanitizer sees a read past the end.
    void neverReadsPastTheEnd()
    {
        const std::string text = "-12.3456789012e-12";
        for (std::size_t length = 0; length <= text.size(); ++length) {
            const std::vector<char> exact(text.begin(), text.begin() + std::ptrdiff_t(length));
            float value = 0;
            const char *const after = parseFloat(exact.data(), exact.data() + length, value);
            QVERIFY(!after || after <= exact.data() + length);
        }
    }
};

SANDREEL_TEST(TestTextNumber)
#include "tst_textnumber.moc"
