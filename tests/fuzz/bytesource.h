// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"

#include <cstdint>
#include <span>

namespace tests {

/// Takes numbers from a fuzzer's bytes; zeros once they are used up, so that every input means something.
class ByteSource
{
public:
    explicit ByteSource(std::span<const std::uint8_t> data)
        : mData(data)
    {}

    bool isEmpty() const { return mAt >= mData.size(); }
    std::uint8_t u8() { return isEmpty() ? std::uint8_t(0) : mData[mAt++]; }
    std::uint32_t u16() { return std::uint32_t(u8()) << 8 | u8(); }
    /// 0 ... most, by as many bytes as it takes.
    std::uint32_t below(std::uint32_t count) { return (count <= 256 ? u8() : u16()) % count; }
    /// An integer of any size up to 2^`bits`, small ones by few bytes.
    std::int64_t integer(unsigned bits)
    {
        const std::uint8_t first = u8();
        if (first < 224)
            return std::int64_t(first) - 112;
        std::uint64_t value = 0;
        for (unsigned i = 0; i <= unsigned(first % 8); ++i)
            value = value << 8 | u8();
        value &= (std::uint64_t(1) << bits) - 1;
        return first & 8 ? -std::int64_t(value) : std::int64_t(value);
    }
    model::Bytes rest()
    {
        const auto left = mData.subspan(std::min(mAt, mData.size()));
        mAt = mData.size();
        return {left.begin(), left.end()};
    }

private:
    std::span<const std::uint8_t> mData;
    std::size_t mAt = 0;
};

} // namespace tests
