// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/entropy/bitmixer.h"
#include "model/codec/entropy/rangecoder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace model::codec {

/// Decisions after which a counted model forgets the older ones; 100 and 1000 are within 0.3 % for connectivity.
inline constexpr unsigned CountedMemory = 255;

/// One decision by a single counted model: learns from the first few at once, and hardly wavers where nothing can be
/// learned. FORMAT.md 4.6.
template <class Coder>
bool codeCounted(Coder &coder, CountedBit &model, bool wanted = false)
{
    const std::uint32_t probability = std::clamp<std::uint32_t>(
        model.probabilityOfOne(), std::uint32_t(LeastProbability), 65536 - std::uint32_t(LeastProbability));
    const std::uint32_t bit = coder.decision(probability, wanted);
    model.update(bit, CountedMemory);
    return bit != 0;
}

/// The models of one kind of integer of which a mesh has few, so that it must be learned quickly: the number of bits in
/// unary, the sign, three bits below the leading one, the rest as it is. FORMAT.md 4.6.
class CountedInteger
{
public:
    /// \param wanted  0 ... 2^MaxBits - 1
    template <class Coder>
    std::int64_t codeCount(Coder &coder, std::int64_t wanted)
    {
        return code(coder, wanted, false);
    }
    /// \param wanted  -2^MaxBits + 1 ... 2^MaxBits - 1
    template <class Coder>
    std::int64_t codeSigned(Coder &coder, std::int64_t wanted)
    {
        return code(coder, wanted, true);
    }

private:
    static constexpr unsigned MaxBits = 34; // differences of 32-bit numbers
    static constexpr unsigned LeadingBits = 3;

    template <class Coder>
    std::int64_t code(Coder &coder, std::int64_t wanted, bool hasSign)
    {
        const std::uint64_t magnitude = std::uint64_t(wanted < 0 ? -wanted : wanted);
        const unsigned size = unsigned(std::bit_width(magnitude));
        unsigned bits = 0;
        while (bits < MaxBits && codeCounted(coder, mSizes[bits], bits < size))
            ++bits;
        if (bits == 0)
            return 0;
        const bool negative = hasSign && codeCounted(coder, mSign, wanted < 0);
        std::uint64_t result = 1;
        unsigned left = bits - 1;
        for (unsigned i = 0; i < LeadingBits && left > 0; ++i) {
            --left;
            result = 2 * result + codeCounted(coder, mLeading[bits][result], magnitude >> left & 1);
        }
        while (left > 0) {
            const unsigned count = std::min(left, MaxDirectBits);
            left -= count;
            const std::uint32_t mask = (1u << count) - 1;
            result = result << count | coder.direct(count, std::uint32_t(magnitude >> left) & mask);
        }
        return negative ? -std::int64_t(result) : std::int64_t(result);
    }

    std::array<CountedBit, MaxBits> mSizes;
    CountedBit mSign;
    std::array<std::array<CountedBit, 1u << LeadingBits>, MaxBits + 1> mLeading;
};

} // namespace model::codec
