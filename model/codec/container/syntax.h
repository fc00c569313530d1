// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"
#include "model/base/numbertext.h"

#include <string>

namespace model::codec {

/// The writing side of a syntax: a function template over the stream that names each field once, so that writer and
/// reader cannot drift apart. Each call returns false only on the reading side, after the first error.
class SyntaxWriter
{
public:
    bool u8(std::uint8_t value) { return mOut.u8(value), true; }
    bool f32(float value) { return mOut.f32(value), true; }
    bool f64(double value) { return mOut.f64(value), true; }
    template <class Integer>
    bool varUint(Integer value)
    {
        return mOut.varUint(value), true;
    }
    bool text(const std::string &value, std::uint64_t) { return mOut.text(value), true; }
    bool require(bool, std::string_view, std::uint64_t, std::string_view) { return true; }
    bool requireReal(double, double, double, std::string_view) { return true; }

    Bytes take() { return mOut.take(); }

private:
    ByteWriter mOut;
};

/// The reading side: fills the fields and checks them.
class SyntaxReader
{
public:
    explicit SyntaxReader(ByteReader &in)
        : mIn(in)
    {}

    bool u8(std::uint8_t &value) { return value = mIn.u8(), mIn.ok(); }
    bool f32(float &value) { return value = mIn.f32(), mIn.ok(); }
    bool f64(double &value) { return value = mIn.f64(), mIn.ok(); }
    template <class Integer>
    bool varUint(Integer &value)
    {
        const std::uint64_t read = mIn.varUint();
        value = Integer(read);
        return mIn.require(value == read, "count", read, "32 bits");
    }
    bool text(std::string &value, std::uint64_t maxLength) { return value = mIn.text(maxLength), mIn.ok(); }
    bool require(bool condition, std::string_view field, std::uint64_t value, std::string_view range)
    {
        return mIn.require(condition, field, value, range);
    }
    /// Refuses a real number outside min ... max, and NaN.
    bool requireReal(double value, double min, double max, std::string_view field)
    {
        if (!(value >= min && value <= max))
            mIn.setError({ErrorCode::BadValue,
                          {std::string(field), numberText(value), numberText(min) + " ... " + numberText(max)},
                          {},
                          Error::None,
                          mIn.offset()});
        return mIn.ok();
    }

private:
    ByteReader &mIn;
};

} // namespace model::codec
