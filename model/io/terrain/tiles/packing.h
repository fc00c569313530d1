// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"

#include <cstdint>
#include <span>
#include <vector>

namespace model::io {

// The streams that a tile is made of. FORMAT.md, section 5. Names in errors are those of the document.

/// Appends `raw`, deflated if that makes it smaller: varUint length, then the bytes.
void writePacked(ByteWriter &out, std::span<const std::uint8_t> raw);
/// Reads what writePacked() wrote of `size` bytes. False, with the error in `in`, if it is anything else.
bool readPacked(ByteReader &in, std::size_t size, Bytes &raw);

/// 32-bit words as four streams, of their lowest bytes, the next, and so on.
void writeWords(ByteWriter &out, std::span<const std::uint32_t> words);
bool readWords(ByteReader &in, std::size_t count, std::vector<std::uint32_t> &words);

/// Small for small numbers of either sign.
inline std::uint32_t zigzag(std::int32_t value)
{
    return (std::uint32_t(value) << 1) ^ std::uint32_t(value >> 31);
}
inline std::int32_t unzigzag(std::uint32_t value)
{
    return std::int32_t(value >> 1) ^ -std::int32_t(value & 1);
}
inline std::uint64_t zigzag(std::int64_t value)
{
    return std::uint64_t(value) << 1 ^ std::uint64_t(value >> 63);
}
inline std::int64_t unzigzag(std::uint64_t value)
{
    return std::int64_t(value >> 1) ^ -std::int64_t(value & 1);
}

/// Numbers of a tile as multiples of a unit, nearly all of them exactly; the rest as the difference of their bits.
/// Lossless for every finite double.
struct FixedPoint
{
    double unit = 1;                        ///< above zero
    std::vector<std::int32_t> multiples;    ///< of each number, the nearest
    std::vector<std::uint32_t> exceptions;  ///< numbers that are not their multiple, ascending
    std::vector<std::uint64_t> differences; ///< bits of each exception, xor those of its multiple

    double multiple(std::size_t i) const { return double(multiples[i]) * unit; }
};

/// \param base  a step that the numbers may be multiples of: units are it times a power of two
FixedPoint toFixedPoint(std::span<const double> numbers, double base);
/// Writes everything but the multiples, which are predicted by who knows more about them.
void writeFixedPoint(ByteWriter &out, const FixedPoint &numbers);
bool readFixedPoint(ByteReader &in, std::size_t count, FixedPoint &numbers);
/// Precondition: `numbers.multiples` have been filled in.
double numberAt(const FixedPoint &numbers, std::size_t i, std::size_t &nextException);

} // namespace model::io
