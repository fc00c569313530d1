// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/bytes.h"

namespace model {

void ByteWriter::fixed(std::uint64_t value, int count)
{
    for (int i = 0; i < count; ++i)
        mBytes.push_back(std::uint8_t(value >> (8 * i)));
}

void ByteWriter::varUint(std::uint64_t value)
{
    while (value >= 0x80) {
        mBytes.push_back(std::uint8_t(value | 0x80));
        value >>= 7;
    }
    mBytes.push_back(std::uint8_t(value));
}

void ByteWriter::text(std::string_view value)
{
    varUint(value.size());
    mBytes.insert(mBytes.end(), value.begin(), value.end());
}

void ByteReader::setError(Error error)
{
    if (!mError)
        mError = std::move(error);
}

bool ByteReader::need(std::uint64_t count)
{
    if (mError)
        return false;
    const std::uint64_t there = mData.size() - mPosition;
    if (count <= there)
        return true;
    setError(Error{ErrorCode::Truncated, {std::to_string(count), std::to_string(there)}, {}, Error::None, offset()});
    return false;
}

std::uint64_t ByteReader::fixed(std::size_t count)
{
    if (!need(count))
        return 0;
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count; ++i)
        value |= std::uint64_t(mData[mPosition + i]) << (8 * i);
    mPosition += count;
    return value;
}

std::uint64_t ByteReader::varUint()
{
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
        const std::uint8_t byte = u8();
        // The tenth byte may carry only the top bit.
        if (!require(shift < 63 || byte <= 1, "varint", byte, "0 ... 2^64-1"))
            return 0;
        value |= std::uint64_t(byte & 0x7f) << shift;
        if (!(byte & 0x80))
            break;
    }
    return mError ? 0 : value;
}

std::span<const std::uint8_t> ByteReader::bytes(std::uint64_t count)
{
    if (!need(count))
        return {};
    const auto result = mData.subspan(mPosition, std::size_t(count));
    mPosition += std::size_t(count);
    return result;
}

std::string ByteReader::text(std::uint64_t maxLength)
{
    const std::uint64_t length = varUint();
    if (!require(length <= maxLength, "text length", length, "0 ... " + std::to_string(maxLength)))
        return {};
    const auto raw = bytes(length);
    return {raw.begin(), raw.end()};
}

bool ByteReader::require(bool condition, std::string_view field, std::uint64_t value, std::string_view range)
{
    if (!condition)
        setError(Error{ErrorCode::BadValue,
                       {std::string(field), std::to_string(value), std::string(range)},
                       {},
                       Error::None,
                       offset()});
    return !mError;
}

bool ByteReader::requireEnd()
{
    if (!mError && mPosition != mData.size())
        setError(Error{ErrorCode::TrailingBytes, {std::to_string(left())}, {}, Error::None, offset()});
    return !mError;
}

} // namespace model
