// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace model::codec {

// Probabilities of one binary decision from several models at once, mixed by weights that are learned as decisions
// pass. Integers only: encoder and decoder compute the same on any machine. FORMAT.md 4.4.
// Based on: M. Mahoney, Adaptive weighing of context models for lossless data compression, 2005 (PAQ); lpaq1.
// Differs: probabilities of 16 bits; models that count how often they were asked.

/// The mixer's scale: 2048 / 12 times ln(p / (1 - p)), from -MaxStretch to MaxStretch.
inline constexpr std::int32_t MaxStretch = 2047;
/// 65536 / (1 + exp(-0.75 i)) for i = -16 ... 16. Part of the format.
inline constexpr std::array<std::int32_t, 33> SquashTable{
    1,     1,     2,     4,     8,     17,    36,    77,    162,   342,   720,
    1506,  3108,  6249,  11955, 21025, 32768, 44511, 53581, 59287, 62428, 64030,
    64816, 65194, 65374, 65459, 65500, 65519, 65528, 65532, 65534, 65535, 65535,
};
/// No decision is taken for more certain than this; of 65536.
inline constexpr std::int32_t LeastProbability = 24;

/// The probability, of 16 bits, of a value in the mixer's scale.
constexpr std::uint32_t squash(std::int32_t stretched)
{
    const std::uint32_t shifted = std::uint32_t(stretched + 2048);
    const std::size_t at = shifted >> 7;
    const std::int32_t part = std::int32_t(shifted & 127);
    const std::int32_t p = SquashTable[at] + ((SquashTable[at + 1] - SquashTable[at]) * part >> 7);
    return std::uint32_t(p < LeastProbability           ? LeastProbability
                         : p > 65536 - LeastProbability ? 65536 - LeastProbability
                                                        : p);
}

/// The inverse, for the middle of each 1/4096 of probability.
inline constexpr std::array<std::int16_t, 4096> StretchTable = [] {
    std::array<std::int16_t, 4096> table{};
    std::int32_t x = -MaxStretch;
    for (std::uint32_t p = 0; p < 4096; ++p) {
        while (x < MaxStretch && squash(x) < 16 * p + 8)
            ++x;
        table[p] = std::int16_t(x);
    }
    return table;
}();

/// A number for the values of a context; the high bits are the best.
constexpr std::uint32_t contextHash(std::initializer_list<std::uint32_t> values)
{
    std::uint32_t hash = 0;
    for (const std::uint32_t value : values)
        hash = (hash + value + 1) * 0x9e3779b1u;
    return hash;
}

/// The probability that a decision is 1 in one context: the mean of what was seen, then of the latest.
class CountedBit
{
public:
    std::uint32_t probabilityOfOne() const { return mProbability; } ///< 16 bits
    void update(std::uint32_t bit, unsigned limit)
    {
        const std::int32_t target = std::int32_t(bit << 16) - std::int32_t(bit);
        mProbability = std::uint16_t(mProbability + ((target - mProbability) * Shares[mCount] >> ShareBits));
        mCount = std::uint16_t(mCount + (mCount < limit));
    }

    static constexpr unsigned MaxLimit = 1023;

private:
    static constexpr unsigned ShareBits = 15;
    /// 2^ShareBits / (count + 1.5): the share of a decision after `count` others.
    static constexpr std::array<std::int32_t, MaxLimit + 1> Shares = [] {
        std::array<std::int32_t, MaxLimit + 1> shares{};
        for (std::size_t i = 0; i < shares.size(); ++i)
            shares[i] = std::int32_t((2u << ShareBits) / (2 * i + 3));
        return shares;
    }();
    std::uint16_t mProbability = 0x8000;
    std::uint16_t mCount = 0;
};

/// What a mixer is made with that sees few decisions: its weights learn up to six times as quickly at first. Meshes of
/// 500 to 5000 triangles become 0.5 to 1 % smaller, larger ones stay as they are.
inline constexpr std::int64_t FirstHaste = 960;

/// Mixes the probabilities of `Inputs` models.
/// \tparam Sets   sets of weights, one of which is chosen by a small context
/// \tparam Haste  0, or FirstHaste
template <std::size_t Inputs, std::size_t Sets, std::int64_t Haste = 0>
class BitMixer
{
public:
    BitMixer()
    {
        for (auto &set : mWeights)
            set.fill(FirstWeight);
    }

    /// \returns the probability that the decision is 1, as decision() of the range coder takes it
    std::uint32_t mix(const std::array<CountedBit *, Inputs> &models, std::size_t set)
    {
        mSet = set;
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < Inputs; ++i) {
            mStretched[i] = StretchTable[models[i]->probabilityOfOne() >> 4];
            sum += std::int64_t(mStretched[i]) * mWeights[set][i];
        }
        const std::int64_t mixed = sum >> WeightBits;
        mProbability = squash(std::int32_t(mixed > MaxStretch    ? MaxStretch
                                           : mixed < -MaxStretch ? -MaxStretch
                                                                 : mixed));
        return mProbability;
    }
    /// Learns from the decision that mix() was asked about last.
    void update(std::uint32_t bit)
    {
        const std::int64_t error = std::int64_t(bit << 16) - std::int64_t(mProbability);
        const std::int64_t rate = rateOf(mSet);
        for (std::size_t i = 0; i < Inputs; ++i)
            // After some 2^29 certain decisions a weight starts again from the other end.
            mWeights[mSet][i] = std::int32_t(std::uint32_t(mWeights[mSet][i]) +
                                             std::uint32_t(mStretched[i] * error * rate >> RateBits));
    }

    const std::array<std::int32_t, Inputs> &weights(std::size_t set) const { return mWeights[set]; }
    void setWeights(std::size_t set, const std::array<std::int32_t, Inputs> &weights) { mWeights[set] = weights; }

private:
    static constexpr unsigned WeightBits = 16;
    static constexpr std::int32_t FirstWeight = std::int32_t((1 << WeightBits) * 14 / (10 * Inputs));
    static constexpr std::int64_t Rate = 12;
    static constexpr unsigned RateBits = 18;
    static constexpr std::uint16_t MostAsked = 1023;
    static constexpr std::array<std::uint8_t, MostAsked + 1> Rates = [] {
        std::array<std::uint8_t, MostAsked + 1> rates{};
        for (std::size_t i = 0; i < rates.size(); ++i)
            rates[i] = std::uint8_t(Rate + Haste / std::int64_t(16 + i));
        return rates;
    }();

    std::int64_t rateOf([[maybe_unused]] std::size_t set)
    {
        if constexpr (Haste == 0) {
            return Rate;
        } else {
            std::uint16_t &asked = mAsked[set];
            const std::int64_t rate = Rates[asked];
            asked = std::uint16_t(asked + (asked < MostAsked));
            return rate;
        }
    }

    std::array<std::array<std::int32_t, Inputs>, Sets> mWeights;
    std::array<std::uint16_t, Haste == 0 ? 0 : Sets> mAsked{}; ///< decisions that each set has seen
    std::array<std::int32_t, Inputs> mStretched{};
    std::size_t mSet = 0;
    std::uint32_t mProbability = 0x8000;
};

} // namespace model::codec
