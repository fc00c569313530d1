// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/entropy/bitmixer.h"
#include "model/codec/entropy/rangecoder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace model::codec {

/// Sizes of numbers as contexts: each of 0 ... 3, then two classes for each power of two. FORMAT.md 13.3.
inline std::uint32_t sizeClass(std::uint32_t value)
{
    if (value < 4)
        return value;
    const std::uint32_t top = std::uint32_t(std::bit_width(value)) - 1;
    return 2 * top + ((value >> (top - 1)) & 1);
}
/// Above sizeClass() of what ResidualLimit caps.
inline constexpr std::uint32_t SizeClasses = 24;
inline constexpr std::uint32_t ResidualLimit = 2000;
inline std::uint32_t cappedClass(std::uint32_t value)
{
    return sizeClass(std::min(value, ResidualLimit));
}

/// Largest magnitude of a residual.
inline constexpr std::int32_t MaxResidual = (1 << 30) - 1;

/// The cost of decisions in bits, for an encoder that chooses between values. Same interface as the range coders, but
/// nothing is written.
class DecisionCost
{
public:
    static double of(std::uint32_t probabilityOfOne, std::uint32_t value)
    {
        return Bits[(value ? probabilityOfOne : 65536 - probabilityOfOne) >> 4];
    }

private:
    static const std::array<float, 4097> Bits;
};

/// Codes signed integers, most of them zero, in several contexts at once; their probabilities are mixed.
/// FORMAT.md 13.3.
template <std::size_t Inputs, std::size_t Sets>
class ResidualModel
{
public:
    using Contexts = std::array<std::uint32_t, Inputs>;

    /// \param sizes  one more than the largest value of each context
    explicit ResidualModel(const Contexts &sizes)
    {
        std::size_t size = 0;
        for (std::size_t i = 0; i < Inputs; ++i) {
            mStarts[i] = size;
            size += sizes[i];
        }
        mDigits.resize(size);
    }

    /// Codes `value`, at most MaxResidual in magnitude; what a decoder passes is ignored. \param set  below Sets
    template <class Coder>
    std::int32_t code(Coder &coder, const Contexts &contexts, std::size_t set, std::int32_t value = 0)
    {
        std::uint32_t rest = std::uint32_t(value < 0 ? -value : value);
        Digits *digits[Inputs];
        for (std::size_t i = 0; i < Inputs; ++i)
            digits[i] = &mDigits[mStarts[i] + contexts[i]];
        std::uint32_t magnitude = 0;
        bool negative = false;
        // A digit says whether the magnitude is larger than the digits before it.
        while (magnitude < DigitCount && decide(coder, digits, magnitude, set, magnitude < rest)) {
            if (magnitude++ == 0)
                negative = coder.direct(1, value < 0) != 0;
        }
        if (magnitude == DigitCount)
            magnitude += codeTail(coder, rest - std::min(rest, std::uint32_t(DigitCount)));
        return negative ? -std::int32_t(magnitude) : std::int32_t(magnitude);
    }

    /// Bits that code() would take for this value.
    double cost(const Contexts &contexts, std::size_t set, std::int32_t value)
    {
        const std::uint32_t rest = std::uint32_t(value < 0 ? -value : value);
        Digits *digits[Inputs];
        for (std::size_t i = 0; i < Inputs; ++i)
            digits[i] = &mDigits[mStarts[i] + contexts[i]];
        double bits = rest > 0 ? 1 : 0;
        for (std::uint32_t digit = 0; digit < DigitCount && digit <= rest; ++digit)
            bits += DecisionCost::of(probability(digits, digit, set), digit < rest);
        if (rest >= DigitCount)
            bits += 2 * std::bit_width(rest - DigitCount + 1) - 1;
        return bits;
    }

private:
    static constexpr std::size_t DigitCount = 17;
    static constexpr unsigned CountLimit = 250;
    /// Digits that have a mixer of their own; the later ones share the last.
    static constexpr std::size_t MixedDigits = 3;
    static constexpr unsigned TailBits = 29;
    using Digits = std::array<CountedBit, DigitCount>;

public:
    /// More bytes than code() can read: no decision takes more than two.
    static constexpr std::size_t MostBytes = 2 * (DigitCount + 1 + TailBits + (TailBits - 1) / MaxDirectBits + 1);

    /// All that one call of code() changes.
    struct Memory
    {
        std::array<Digits, Inputs> digits;
        std::array<std::array<std::int32_t, Inputs>, MixedDigits> weights;
        std::array<AdaptiveBit, TailBits> tail;
    };
    Memory remember(const Contexts &contexts, std::size_t set) const
    {
        Memory memory;
        for (std::size_t i = 0; i < Inputs; ++i)
            memory.digits[i] = mDigits[mStarts[i] + contexts[i]];
        for (std::size_t m = 0; m < MixedDigits; ++m)
            memory.weights[m] = mMixers[m].weights(set);
        memory.tail = mTail;
        return memory;
    }
    /// As it was before code(): for a decoder that ran out of bytes in the middle of a residual.
    void restore(const Contexts &contexts, std::size_t set, const Memory &memory)
    {
        for (std::size_t i = 0; i < Inputs; ++i)
            mDigits[mStarts[i] + contexts[i]] = memory.digits[i];
        for (std::size_t m = 0; m < MixedDigits; ++m)
            mMixers[m].setWeights(set, memory.weights[m]);
        mTail = memory.tail;
    }

private:
    std::uint32_t probability(Digits *const (&digits)[Inputs], std::size_t digit, std::size_t set)
    {
        std::array<CountedBit *, Inputs> bits;
        for (std::size_t i = 0; i < Inputs; ++i)
            bits[i] = &(*digits[i])[digit];
        return mMixers[std::min(digit, MixedDigits - 1)].mix(bits, set);
    }

    template <class Coder>
    std::uint32_t decide(Coder &coder, Digits *const (&digits)[Inputs], std::size_t digit, std::size_t set, bool wanted)
    {
        const std::uint32_t bit = coder.decision(probability(digits, digit, set), wanted);
        mMixers[std::min(digit, MixedDigits - 1)].update(bit);
        for (Digits *d : digits)
            (*d)[digit].update(bit, CountLimit);
        return bit;
    }

    // Elias gamma, the length adaptive.
    template <class Coder>
    std::uint32_t codeTail(Coder &coder, std::uint32_t rest)
    {
        const unsigned wanted = unsigned(std::bit_width(rest + 1)) - 1;
        unsigned bits = 0;
        while (bits < TailBits && coder.bit(mTail[bits], bits < wanted))
            ++bits;
        std::uint32_t result = 1;
        for (unsigned left = bits; left > 0;) {
            const unsigned count = std::min(left, MaxDirectBits);
            left -= count;
            result = (result << count) | coder.direct(count, ((rest + 1) >> left) & ((1u << count) - 1));
        }
        return result - 1;
    }

    std::array<std::size_t, Inputs> mStarts{};
    std::vector<Digits> mDigits;
    std::array<BitMixer<Inputs, Sets>, MixedDigits> mMixers;
    std::array<AdaptiveBit, TailBits> mTail;
};

} // namespace model::codec
