// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"

#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace model {

using Bytes = std::vector<std::uint8_t>;

/// Appends numbers to a byte vector: little-endian, whatever the machine; unsigned LEB128 for varints.
class ByteWriter
{
public:
    void u8(std::uint8_t value) { mBytes.push_back(value); }
    void u16(std::uint16_t value) { fixed(value, 2); }
    void u32(std::uint32_t value) { fixed(value, 4); }
    void u64(std::uint64_t value) { fixed(value, 8); }
    void f32(float value) { u32(std::bit_cast<std::uint32_t>(value)); }
    void f64(double value) { u64(std::bit_cast<std::uint64_t>(value)); }
    void varUint(std::uint64_t value);
    void bytes(std::span<const std::uint8_t> values) { mBytes.insert(mBytes.end(), values.begin(), values.end()); }
    /// varUint length, then the UTF-8 bytes.
    void text(std::string_view value);

    const Bytes &data() const { return mBytes; }
    Bytes take() { return std::move(mBytes); }

private:
    void fixed(std::uint64_t value, int count);
    Bytes mBytes;
};

/// Reads what ByteWriter wrote. Keeps the first error and its offset; after it, every read returns zero and does
/// nothing, so that a sequence of reads may be checked once. Never reads past the end, never allocates by a count
/// that the bytes left cannot hold.
class ByteReader
{
public:
    /// \param base  offset of `data` in the file, for the errors
    explicit ByteReader(std::span<const std::uint8_t> data, std::uint64_t base = 0)
        : mData(data)
        , mBase(base)
    {}

    std::uint8_t u8() { return std::uint8_t(fixed(1)); }
    std::uint16_t u16() { return std::uint16_t(fixed(2)); }
    std::uint32_t u32() { return std::uint32_t(fixed(4)); }
    std::uint64_t u64() { return fixed(8); }
    float f32() { return std::bit_cast<float>(u32()); }
    double f64() { return std::bit_cast<double>(u64()); }
    std::uint64_t varUint();
    /// `count` bytes as they lie in the data; empty after an error.
    std::span<const std::uint8_t> bytes(std::uint64_t count);
    /// Text of at most `maxLength` bytes, as ByteWriter::text wrote it.
    std::string text(std::uint64_t maxLength);

    /// Fails with BadValue{field, value, range} at the present offset unless `condition`.
    bool require(bool condition, std::string_view field, std::uint64_t value, std::string_view range);
    /// Fails with TrailingBytes unless everything was read.
    bool requireEnd();

    std::size_t left() const { return mError ? 0 : mData.size() - mPosition; }
    std::uint64_t offset() const { return mBase + mPosition; }
    bool ok() const { return !mError; }
    /// Precondition: !ok().
    Error error() const { return *mError; }
    void setError(Error error);

private:
    std::uint64_t fixed(std::size_t count);
    bool need(std::uint64_t count);

    std::span<const std::uint8_t> mData;
    std::uint64_t mBase;
    std::size_t mPosition = 0;
    std::optional<Error> mError;
};

} // namespace model
