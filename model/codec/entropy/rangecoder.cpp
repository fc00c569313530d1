// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/entropy/rangecoder.h"

namespace model::codec {

void RangeEncoder::shiftLow()
{
    const bool carry = mLow > 0xffffffffu;
    if (mLow < 0xff000000u || carry) {
        // Nothing comes before the first byte: the code value is below 1, so a carry cannot reach it.
        if (mStarted)
            mOut.push_back(std::uint8_t(mCache + carry));
        for (; mPending > 0; --mPending)
            mOut.push_back(std::uint8_t(0xff + carry));
        mCache = std::uint8_t(mLow >> 24);
        mStarted = true;
    } else {
        ++mPending;
    }
    mLow = (mLow & 0x00ffffff) << 8;
}

Bytes RangeEncoder::finish()
{
    // Any value in [low, low + range) decodes alike, and range >= 2^24: take the one whose low three bytes are zero.
    mLow = (mLow + (MinRange - 1)) & ~std::uint64_t(MinRange - 1);
    shiftLow();
    shiftLow();
    return std::move(mOut);
}

Bytes RangeDecoder::endedHere() const
{
    // What was read, as one number, is the encoder's low plus the decoder's code: take that away, then end as
    // finish() does.
    Bytes stream(mData.begin(), mData.begin() + std::ptrdiff_t(mPosition));
    std::int64_t carry = std::int64_t(MinRange - 1) - std::int64_t(mCode);
    for (std::size_t i = stream.size(); i-- > 0 && carry != 0;) {
        carry += stream[i];
        stream[i] = std::uint8_t(carry & 0xff);
        carry >>= 8;
    }
    stream.resize(stream.size() - ImpliedBytes);
    return stream;
}

} // namespace model::codec
