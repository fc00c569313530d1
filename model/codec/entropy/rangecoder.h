// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace model::codec {

/// The probability that a binary decision is 1, learned from the decisions before. Two estimates, a quick and a steady
/// one, are averaged: better than either on data that change. FORMAT.md 4.1.
class AdaptiveBit
{
public:
    /// 15 bits, 35 ... 32732: never certain.
    std::uint32_t probabilityOfOne() const { return (std::uint32_t(mQuick) + mSteady) >> 2; }
    void update(std::uint32_t bit)
    {
        const std::uint32_t mask = (0u - bit) & 0xffff;
        const std::uint32_t quick = mQuick ^ mask;
        const std::uint32_t steady = mSteady ^ mask;
        mQuick = std::uint16_t((quick - (quick >> QuickShift)) ^ mask);
        mSteady = std::uint16_t((steady - (steady >> SteadyShift)) ^ mask);
    }

private:
    static constexpr unsigned QuickShift = 4;
    static constexpr unsigned SteadyShift = 7;
    std::uint16_t mQuick = 0x8000;
    std::uint16_t mSteady = 0x8000;
};

inline constexpr unsigned ProbabilityBits = 15;
/// Bits of a probability that is given to decision().
inline constexpr unsigned FineProbabilityBits = 16;
inline constexpr std::uint32_t MinRange = 1u << 24;
/// Most bits of one call of direct().
inline constexpr unsigned MaxDirectBits = 12;
/// Bytes of zeros that the decoder takes to follow a stream; the encoder ends it so that they do.
inline constexpr std::size_t ImpliedBytes = 3;

// Encoder and decoder have the same interface, so that a binarisation is written once for both: each function takes
// the value to encode, which the decoder ignores, and returns the value encoded or decoded.

/// Based on: G. N. N. Martin, Range encoding, 1979; I. Pavlov, LZMA (carry through a run of 0xff).
/// Differs: no leading zero byte; the last three bytes are implied.
class RangeEncoder
{
public:
    std::uint32_t bit(AdaptiveBit &model, std::uint32_t value)
    {
        take((mRange >> ProbabilityBits) * model.probabilityOfOne(), value);
        model.update(value);
        normalize();
        return value;
    }
    /// A decision whose probability to be 1 somebody else computed: 1 ... 2^FineProbabilityBits - 1.
    std::uint32_t decision(std::uint32_t probabilityOfOne, std::uint32_t value)
    {
        take((mRange >> FineProbabilityBits) * probabilityOfOne, value);
        normalize();
        return value;
    }
    /// `count` bits, at most MaxDirectBits, all values equally likely.
    std::uint32_t direct(unsigned count, std::uint32_t value)
    {
        mRange >>= count;
        mLow += std::uint64_t(mRange) * value;
        normalize();
        return value;
    }
    bool isBad() const { return false; }
    Bytes finish();

private:
    void take(std::uint32_t bound, std::uint32_t value)
    {
        if (value) {
            mRange = bound;
        } else {
            mLow += bound;
            mRange -= bound;
        }
    }
    void normalize()
    {
        while (mRange < MinRange) {
            mRange <<= 8;
            shiftLow();
        }
    }
    void shiftLow();

    Bytes mOut;
    std::uint64_t mLow = 0; ///< 33 bits: the top one is the carry
    std::uint32_t mRange = 0xffffffff;
    std::uint8_t mCache = 0;
    std::uint64_t mPending = 0; ///< bytes 0xff after mCache that a carry would change
    bool mStarted = false;
};

/// Safe on any bytes: past the end it reads zeros and isBad() becomes true; it never reads outside, never hangs.
class RangeDecoder
{
public:
    explicit RangeDecoder(std::span<const std::uint8_t> data)
        : mData(data)
    {
        for (int i = 0; i < 4; ++i)
            mCode = (mCode << 8) | next();
        if (mCode == mRange)
            markBad();
    }

    std::uint32_t bit(AdaptiveBit &model, std::uint32_t = 0)
    {
        const std::uint32_t value = taken((mRange >> ProbabilityBits) * model.probabilityOfOne());
        model.update(value);
        normalize();
        return value;
    }
    std::uint32_t decision(std::uint32_t probabilityOfOne, std::uint32_t = 0)
    {
        const std::uint32_t value = taken((mRange >> FineProbabilityBits) * probabilityOfOne);
        normalize();
        return value;
    }
    std::uint32_t direct(unsigned count, std::uint32_t = 0)
    {
        mRange >>= count;
        std::uint32_t value = mCode / mRange;
        if (value >> count) { // in the remainder of the division, where no encoder goes
            markBad();
            value = 0;
        }
        mCode -= value * mRange;
        normalize();
        return value;
    }
    /// True once the stream cannot have come from the encoder. What is decoded from then on is arbitrary.
    bool isBad() const { return mBad || mPosition > mData.size() + ImpliedBytes; }
    /// True if all decisions were decoded from a whole stream and nothing is left over.
    bool isAtEnd() const { return !mBad && mPosition == mData.size() + ImpliedBytes; }

    // For a stream whose end has not come yet: bytes past it are zeros here too, but must not be taken for any.
    /// Bytes read so far; it reads ahead.
    std::size_t position() const { return mPosition; }
    /// Bytes that were not read yet.
    std::size_t left() const { return mData.size() - std::min(mPosition, mData.size()); }
    bool hasReadPastEnd() const { return mPosition > mData.size(); }
    /// \param data  what it had, wherever it lies now, and more
    void extend(std::span<const std::uint8_t> data) { mData = data; }
    /// The stream that an encoder would have written if it had stopped here. Precondition: !hasReadPastEnd()
    Bytes endedHere() const;

private:
    std::uint32_t taken(std::uint32_t bound)
    {
        const std::uint32_t value = mCode < bound;
        const std::uint32_t zeroMask = value - 1u; // all ones for a zero
        mCode -= bound & zeroMask;
        mRange = (bound & ~zeroMask) | ((mRange - bound) & zeroMask);
        return value;
    }
    void normalize()
    {
        while (mRange < MinRange) {
            mRange <<= 8;
            mCode = (mCode << 8) | next();
        }
    }
    std::uint32_t next()
    {
        const std::size_t at = mPosition++;
        return at < mData.size() ? mData[at] : 0u;
    }
    void markBad()
    {
        mBad = true;
        mCode = 0; // keeps code < range
    }

    std::span<const std::uint8_t> mData;
    std::size_t mPosition = 0;
    std::uint32_t mRange = 0xffffffff;
    std::uint32_t mCode = 0;
    bool mBad = false;
};

} // namespace model::codec
