// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/textnumber.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace model::io {

namespace {

/// Of a number beyond double: too small rather than too large. Such a number has a negative exponent, or starts with
/// hundreds of zeros after its point.
bool isTiny(const char *p, const char *end)
{
    const char *const letter = std::find_if(p, end, [](char c) { return c == 'e' || c == 'E'; });
    if (letter != end)
        return letter + 1 != end && letter[1] == '-';
    const char *const point = std::find(p, end, '.');
    return std::all_of(p, point, [](char c) { return c == '0'; });
}

} // namespace

const char *parseFloatSlowly(const char *p, const char *end, float &value)
{
    if (p != end && *p == '+') {
        ++p;
        if (p != end && *p == '-')
            return nullptr;
    }
    const auto [after, error] = std::from_chars(p, end, value);
    if (error == std::errc())
        return after;
    if (error != std::errc::result_out_of_range)
        return nullptr;
    double wide = 0;
    const bool negative = *p == '-';
    if (std::from_chars(p, after, wide).ec == std::errc::result_out_of_range) {
        wide = isTiny(p + negative, after) ? 0.0 : std::numeric_limits<double>::infinity();
        wide = negative ? -wide : wide;
    }
    value = float(wide);
    return after;
}

} // namespace model::io
