// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/rangecoder.h"

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

} // namespace model::codec
