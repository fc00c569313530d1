// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace model::io {

/// Any number that std::from_chars reads, also with a leading '+'; too small a number is zero, too large a one
/// infinite. \returns one past the number, or null if there is none at `p`
const char *parseFloatSlowly(const char *p, const char *end, float &value);

namespace detail {

constexpr int MinExponent = -37;
constexpr int MaxExponent = 18;
constexpr std::array<double, MaxExponent - MinExponent + 1> PowersOfTen = {
    1e-37, 1e-36, 1e-35, 1e-34, 1e-33, 1e-32, 1e-31, 1e-30, 1e-29, 1e-28, 1e-27, 1e-26, 1e-25, 1e-24,
    1e-23, 1e-22, 1e-21, 1e-20, 1e-19, 1e-18, 1e-17, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10,
    1e-9,  1e-8,  1e-7,  1e-6,  1e-5,  1e-4,  1e-3,  1e-2,  1e-1,  1e0,   1e1,   1e2,   1e3,   1e4,
    1e5,   1e6,   1e7,   1e8,   1e9,   1e10,  1e11,  1e12,  1e13,  1e14,  1e15,  1e16,  1e17,  1e18};
constexpr std::array<std::uint32_t, 9> IntegerPowersOfTen = {1,      10,      100,      1000,     10000,
                                                             100000, 1000000, 10000000, 100000000};

inline bool isDigit(char c)
{
    return unsigned(c - '0') < 10;
}

/// Appends the decimal digits at `p` to `mantissa` (which wraps after 19 of them). \returns one past the digits
inline const char *appendDigits(const char *p, const char *end, std::uint64_t &mantissa)
{
    if constexpr (std::endian::native == std::endian::little) {
        // Eight bytes at once, without a branch on how many of them are digits: that would be mispredicted.
        while (end - p >= 8) {
            std::uint64_t bytes;
            std::memcpy(&bytes, p, 8);
            bytes ^= 0x3030303030303030;
            const std::uint64_t others = ((bytes + 0x7676767676767676) | bytes) & 0x8080808080808080;
            const unsigned count = others ? unsigned(std::countr_zero(others)) / 8 : 8;
            if (count == 0)
                return p;
            std::uint64_t digits = bytes << (64 - 8 * count); // the last digit in the highest byte
            digits = (digits * 10) + (digits >> 8);
            digits = (((digits & 0x000000FF000000FF) * 0x000F424000000064) +
                      (((digits >> 16) & 0x000000FF000000FF) * 0x0000271000000001)) >>
                     32;
            mantissa = mantissa * IntegerPowersOfTen[count] + std::uint32_t(digits);
            p += count;
            if (count < 8)
                return p;
        }
    }
    while (p != end && isDigit(*p))
        mantissa = mantissa * 10 + unsigned(*p++ - '0');
    return p;
}

} // namespace detail

/// The decimal number at `p` as the nearest float, bit for bit as std::from_chars gives it, and faster.
/// \returns one past the number, or null if there is none at `p`
///
/// How: mantissa times power of ten in double is off by at most 3 units in its last place. Unless it lies that close
/// to the middle between two floats, rounding it to float gives what rounding the exact value would. The rest (also
/// long, tiny and huge numbers) takes the slow way.
inline const char *parseFloat(const char *const begin, const char *end, float &value)
{
    using namespace detail;
    constexpr int MaxDigits = 18; // fit in 63 bits
    constexpr std::uint64_t Tolerance = 8;
    constexpr std::uint64_t DroppedBits = (std::uint64_t(1) << 29) - 1; // 52 - 23 bits of the significand
    constexpr std::uint64_t Middle = std::uint64_t(1) << 28;

    const char *p = begin;
    if (p != end && (*p == '-' || *p == '+'))
        ++p;
    std::uint64_t mantissa = 0;
    const char *const integer = p;
    while (p != end && isDigit(*p))
        mantissa = mantissa * 10 + unsigned(*p++ - '0');
    auto digits = p - integer;
    std::ptrdiff_t exponent = 0;
    if (p != end && *p == '.') {
        const char *const fraction = ++p;
        p = appendDigits(p, end, mantissa);
        digits += p - fraction;
        exponent = fraction - p;
    }
    if (digits == 0 || digits > MaxDigits)
        return parseFloatSlowly(begin, end, value);
    if (p != end && (*p == 'e' || *p == 'E')) {
        const char *q = p + 1;
        const bool negative = q != end && *q == '-';
        if (q != end && (*q == '-' || *q == '+'))
            ++q;
        int written = 0;
        const char *const first = q;
        while (q != end && isDigit(*q) && q - first < 4)
            written = written * 10 + (*q++ - '0');
        if (q == first || (q != end && isDigit(*q)))
            return parseFloatSlowly(begin, end, value);
        exponent += negative ? -written : written;
        p = q;
    }
    if (mantissa == 0) {
        value = *begin == '-' ? -0.0f : 0.0f;
        return p;
    }
    if (exponent < MinExponent || exponent > MaxExponent)
        return parseFloatSlowly(begin, end, value);
    const double magnitude = double(std::int64_t(mantissa)) * PowersOfTen[std::size_t(exponent - MinExponent)];
    if ((std::bit_cast<std::uint64_t>(magnitude) & DroppedBits) - (Middle - Tolerance) <= 2 * Tolerance)
        return parseFloatSlowly(begin, end, value);
    value = float(*begin == '-' ? -magnitude : magnitude);
    return p;
}

} // namespace model::io
