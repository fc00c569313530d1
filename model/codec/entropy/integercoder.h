// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/entropy/rangecoder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace model::codec {

/// Sizes of numbers as contexts: about two classes for each power of two. FORMAT.md 4.2.
inline constexpr unsigned SizeContexts = 48;
inline unsigned sizeContext(std::uint64_t magnitude)
{
    if (magnitude < 2)
        return unsigned(magnitude);
    const unsigned bits = unsigned(std::bit_width(magnitude));
    return std::min(2 * bits - 2 + unsigned((magnitude >> (bits - 2)) & 1), SizeContexts - 1);
}

/// 0 for zero, 1 for positive, 2 for negative.
inline unsigned signContext(std::int64_t value)
{
    return value == 0 ? 0 : value > 0 ? 1 : 2;
}

/// The adaptive models of one kind of signed integer of less than 2^(2^ClassBits - 1) in magnitude.
///
/// An integer is coded as the number of bits of its magnitude (its class, a binary tree of ClassBits decisions), the
/// sign, the two bits below the leading one (adaptive), and the rest (not modelled: nothing can be learned there).
template <unsigned ClassBits>
struct IntegerModels
{
    std::array<std::array<AdaptiveBit, (1u << ClassBits)>, SizeContexts> classes;
    std::array<AdaptiveBit, 3> signs;
    std::array<std::array<AdaptiveBit, 4>, (1u << ClassBits)> leading;
};

/// Codes one integer. FORMAT.md 4.3.
/// \param size  context below SizeContexts: how large the integer is expected to be
/// \param sign  context below 3
template <class Coder, unsigned ClassBits>
std::int64_t codeInteger(Coder &coder, IntegerModels<ClassBits> &models, unsigned size, unsigned sign,
                         std::int64_t value = 0)
{
    const std::uint64_t magnitude = value < 0 ? 0 - std::uint64_t(value) : std::uint64_t(value);
    const unsigned wanted = unsigned(std::bit_width(magnitude));

    auto &tree = models.classes[size];
    unsigned node = 1;
    for (unsigned i = ClassBits; i-- > 0;)
        node = 2 * node + coder.bit(tree[node], (wanted >> i) & 1);
    const unsigned bits = node - (1u << ClassBits);
    if (bits == 0)
        return 0;

    const bool negative = coder.bit(models.signs[sign], value < 0) != 0;
    std::uint64_t result = 1;
    unsigned left = bits - 1;
    unsigned leadingNode = 1;
    for (unsigned i = 0; i < 2 && left > 0; ++i) {
        --left;
        const std::uint32_t bit = coder.bit(models.leading[bits][leadingNode], std::uint32_t(magnitude >> left) & 1);
        leadingNode = 2 * leadingNode + bit;
        result = 2 * result + bit;
    }
    while (left > 0) {
        const unsigned count = std::min(left, MaxDirectBits);
        left -= count;
        const std::uint32_t mask = (1u << count) - 1;
        result = (result << count) | coder.direct(count, std::uint32_t(magnitude >> left) & mask);
    }
    return negative ? std::int64_t(0 - result) : std::int64_t(result);
}

} // namespace model::codec
