// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/model/codec/plain/plainreader.h"

// FORMAT.md 4.4, written from the document alone.
namespace tests::plain {

struct CountedModel
{
    std::int64_t p = 32768, n = 0;
};

/// Models of one kind that come into being when they are first asked for.
using CountedModels = std::map<std::uint64_t, CountedModel>;

struct WeightSet
{
    explicit WeightSet(std::size_t inputs)
        : w(inputs, std::int32_t(91750 / inputs))
    {}
    std::vector<std::int32_t> w;
    std::int64_t asked = 0;
};

inline std::int64_t squash(std::int64_t x)
{
    static constexpr std::int64_t S[33] = {1,     1,     2,     4,     8,     17,    36,    77,    162,   342,   720,
                                           1506,  3108,  6249,  11955, 21025, 32768, 44511, 53581, 59287, 62428, 64030,
                                           64816, 65194, 65374, 65459, 65500, 65519, 65528, 65532, 65534, 65535, 65535};
    const std::int64_t i = (x + 2048) / 128, f = (x + 2048) % 128;
    const std::int64_t p = S[i] + ((S[i + 1] - S[i]) * f >> 7);
    return std::min<std::int64_t>(std::max<std::int64_t>(p, 24), 65512);
}

inline std::int64_t stretch(std::int64_t p)
{
    std::int64_t x = -2047;
    while (x < 2047 && squash(x) < 16 * (p / 16) + 8)
        ++x;
    return x;
}

inline void learn(CountedModel &m, unsigned bit, std::int64_t limit = 255)
{
    m.p += (65535 * std::int64_t(bit) - m.p) * (65536 / (2 * m.n + 3)) >> 15;
    m.n = std::min(m.n + 1, limit);
}

/// \param haste  960 for weights that learn as those of 12.4
inline unsigned mixed(Range &coder, const std::vector<CountedModel *> &models, WeightSet &set, std::int64_t limit = 255,
                      std::int64_t haste = 0)
{
    std::vector<std::int64_t> x;
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < models.size(); ++i) {
        x.push_back(stretch(models[i]->p));
        sum += x[i] * set.w[i];
    }
    const std::int64_t q = squash(std::min<std::int64_t>(std::max<std::int64_t>(sum >> 16, -2047), 2047));
    const unsigned bit = coder.decision(std::uint32_t(q));
    const std::int64_t e = 65536 * std::int64_t(bit) - q;
    const std::int64_t rate = 12 + haste / (16 + std::min<std::int64_t>(set.asked++, 1023));
    for (std::size_t i = 0; i < models.size(); ++i)
        set.w[i] = std::int32_t(std::uint32_t(set.w[i]) + std::uint32_t(x[i] * e * rate >> 18));
    for (CountedModel *m : models)
        learn(*m, bit, limit);
    return bit;
}

// 4.6
inline unsigned counted(Range &coder, CountedModel &m)
{
    const unsigned bit = coder.decision(std::uint32_t(std::min<std::int64_t>(std::max<std::int64_t>(m.p, 24), 65512)));
    learn(m, bit);
    return bit;
}

struct CountedIntegers
{
    CountedModel sizes[34], sign, leading[35][8];

    std::int64_t decode(Range &coder, bool hasSign)
    {
        unsigned n = 0;
        while (n < 34 && counted(coder, sizes[n]))
            ++n;
        if (n == 0)
            return 0;
        const bool negative = hasSign && counted(coder, sign);
        std::int64_t m = 1;
        unsigned left = n - 1;
        for (int i = 0; i < 3 && left > 0; ++i, --left)
            m = 2 * m + counted(coder, leading[n][m]);
        while (left > 0) {
            const unsigned now = std::min(left, 12u);
            m = (m << now) + coder.direct(now);
            left -= now;
        }
        return negative ? -m : m;
    }
};

} // namespace tests::plain
