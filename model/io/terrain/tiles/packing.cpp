// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/tiles/packing.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <zlib.h>

namespace model::io {

namespace {

constexpr int Level = 1;
/// Deflate makes nothing smaller than this: what claims to be is no deflate stream, and needs no memory.
constexpr std::uint64_t LargestRatio = 1032;

/// A multiple is a 31-bit number with a sign: sums and differences of three stay in 64 bits.
constexpr double LargestMultiple = 0x1p30;
/// Exponents of units, relative to the base.
constexpr int FinestUnit = -60, CoarsestUnit = 20;

} // namespace

void writePacked(ByteWriter &out, std::span<const std::uint8_t> raw)
{
    Bytes packed(compressBound(uLong(raw.size())));
    uLongf size = uLongf(packed.size());
    if (!raw.empty() && compress2(packed.data(), &size, raw.data(), uLong(raw.size()), Level) == Z_OK &&
        size < raw.size()) {
        out.varUint(size);
        out.bytes(std::span(packed).first(size));
    } else {
        out.varUint(raw.size());
        out.bytes(raw);
    }
}

bool readPacked(ByteReader &in, std::size_t size, Bytes &raw)
{
    const std::uint64_t packedSize = in.varUint();
    const std::uint64_t offset = in.offset();
    const auto packed = in.bytes(packedSize);
    if (!in.require(packedSize <= size, "packed size", packedSize, "at most the bytes unpacked") ||
        !in.require(size <= packedSize * LargestRatio, "unpacked size", size, "at most the bytes left"))
        return false;
    raw.resize(size);
    if (packedSize == size) {
        std::copy(packed.begin(), packed.end(), raw.begin());
        return true;
    }
    uLongf got = uLongf(size);
    uLong used = uLong(packed.size());
    if (uncompress2(raw.data(), &got, packed.data(), &used) == Z_OK && got == size && used == packed.size())
        return true;
    in.setError(Error{ErrorCode::CorruptStream, {"deflate"}, {}, Error::None, offset});
    return false;
}

void writeWords(ByteWriter &out, std::span<const std::uint32_t> words)
{
    Bytes plane(words.size());
    for (int shift = 0; shift < 32; shift += 8) {
        for (std::size_t i = 0; i < words.size(); ++i)
            plane[i] = std::uint8_t(words[i] >> shift);
        writePacked(out, plane);
    }
}

bool readWords(ByteReader &in, std::size_t count, std::vector<std::uint32_t> &words)
{
    words.clear();
    Bytes plane;
    for (int shift = 0; shift < 32; shift += 8) {
        if (!readPacked(in, count, plane))
            return false;
        words.resize(count);
        for (std::size_t i = 0; i < count; ++i)
            words[i] |= std::uint32_t(plane[i]) << shift;
    }
    return true;
}

namespace {

bool isMultiple(double number, double unit)
{
    return std::bit_cast<std::uint64_t>(std::nearbyint(number / unit) * unit) == std::bit_cast<std::uint64_t>(number);
}

/// The exponent that makes files smallest: a finer unit costs each number a bit, and each number that is no multiple
/// takes most of its bits once more.
int chooseExponent(std::span<const double> numbers, double base)
{
    constexpr std::size_t Samples = 256;
    constexpr double ExceptionBits = 48;
    double largest = 0;
    for (const double number : numbers)
        largest = std::max(largest, std::abs(number));
    const auto fits = [&](int exponent) {
        const double unit = std::ldexp(base, exponent);
        return unit > 0x1p-900 && unit < 0x1p900 && largest / unit < LargestMultiple;
    };
    const std::size_t step = std::max<std::size_t>(1, numbers.size() / Samples);
    int best = CoarsestUnit;
    double bestCost = INFINITY;
    for (int exponent = CoarsestUnit; exponent >= FinestUnit && fits(exponent); --exponent) {
        std::size_t asked = 0, exact = 0;
        for (std::size_t i = 0; i < numbers.size(); i += step, ++asked)
            exact += isMultiple(numbers[i], std::ldexp(base, exponent));
        const double cost = -exponent + ExceptionBits * double(asked - exact) / double(std::max<std::size_t>(asked, 1));
        if (cost < bestCost) {
            bestCost = cost;
            best = exponent;
        }
        if (exact == asked)
            break;
    }
    // Numbers beyond all of that: any unit will do, and the differences hold them.
    while (!fits(best) && best < 1000)
        ++best;
    return best;
}

} // namespace

FixedPoint toFixedPoint(std::span<const double> numbers, double base)
{
    FixedPoint result;
    result.unit = std::ldexp(base, chooseExponent(numbers, base));
    result.multiples.resize(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double multiple = std::nearbyint(numbers[i] / result.unit);
        result.multiples[i] = std::abs(multiple) <= LargestMultiple ? std::int32_t(multiple) : 0;
        const auto bits = std::bit_cast<std::uint64_t>(numbers[i]);
        const auto known = std::bit_cast<std::uint64_t>(result.multiple(i));
        if (bits == known)
            continue;
        result.exceptions.push_back(std::uint32_t(i));
        result.differences.push_back(bits ^ known);
    }
    return result;
}

void writeFixedPoint(ByteWriter &out, const FixedPoint &numbers)
{
    out.f64(numbers.unit);
    out.varUint(numbers.exceptions.size());
    if (numbers.exceptions.empty())
        return;
    Bytes bits((numbers.multiples.size() + 7) / 8);
    for (const std::uint32_t i : numbers.exceptions)
        bits[i / 8] = std::uint8_t(bits[i / 8] | 1 << i % 8);
    writePacked(out, bits);
    Bytes plane(numbers.differences.size());
    for (int shift = 0; shift < 64; shift += 8) {
        for (std::size_t i = 0; i < plane.size(); ++i)
            plane[i] = std::uint8_t(numbers.differences[i] >> shift);
        writePacked(out, plane);
    }
}

bool readFixedPoint(ByteReader &in, std::size_t count, FixedPoint &numbers)
{
    numbers = {};
    numbers.unit = in.f64();
    const std::uint64_t exceptions = in.varUint();
    if (!in.require(std::isfinite(numbers.unit) && numbers.unit > 0, "unit", 0, "above zero") ||
        !in.require(exceptions <= count, "exception count", exceptions, "at most the vertices of the tile"))
        return false;
    if (exceptions == 0)
        return true;
    Bytes bits;
    if (!readPacked(in, (count + 7) / 8, bits))
        return false;
    for (std::size_t i = 0; i < count; ++i)
        if (bits[i / 8] >> i % 8 & 1)
            numbers.exceptions.push_back(std::uint32_t(i));
    if (!in.require(numbers.exceptions.size() == exceptions, "exception count", exceptions, "the bits that are set"))
        return false;
    Bytes plane;
    for (int shift = 0; shift < 64; shift += 8) {
        if (!readPacked(in, exceptions, plane))
            return false;
        numbers.differences.resize(exceptions);
        for (std::size_t i = 0; i < exceptions; ++i)
            numbers.differences[i] |= std::uint64_t(plane[i]) << shift;
    }
    return true;
}

double numberAt(const FixedPoint &numbers, std::size_t i, std::size_t &nextException)
{
    const double multiple = numbers.multiple(i);
    if (nextException >= numbers.exceptions.size() || numbers.exceptions[nextException] != i)
        return multiple;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(multiple) ^ numbers.differences[nextException++]);
}

} // namespace model::io
