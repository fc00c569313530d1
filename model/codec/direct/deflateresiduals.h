// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"
#include "model/codec/direct/prediction.h"

#include <memory>

struct z_stream_s;

namespace model::codec {

// Residuals packed by zlib, with the interface of residualcoders.h. A frame is its weights, two bytes each, then a byte
// that says how many bytes the largest residual has, then the lowest bytes of all residuals (all x, all y, all z), then
// the next ones. FORMAT.md 11.6.

class DeflateWriter
{
public:
    explicit DeflateWriter(const MeshWalk &walk);

    void startFrame(bool) {}
    std::int32_t weight(std::size_t axis, std::size_t feature, std::int32_t value);
    std::int32_t residual(std::size_t place, std::size_t axis, std::int32_t value)
    {
        mFolded[axis * mCount + place] = (std::uint32_t(value) << 1) ^ std::uint32_t(value >> 31);
        return value;
    }
    bool endFrame();
    /// All frames, compressed.
    Bytes finish();

private:
    std::size_t mCount;
    std::vector<std::uint32_t> mFolded; ///< 0, -1, 1, -2, ... as 0, 1, 2, 3, ...
    ByteWriter mOut;
};

class DeflateReader
{
public:
    DeflateReader(const MeshWalk &walk, std::span<const std::uint8_t> stream);
    ~DeflateReader();

    void startFrame(bool) { mHasFrame = false; }
    std::int32_t weight(std::size_t axis, std::size_t feature, std::int32_t);
    std::int32_t residual(std::size_t place, std::size_t axis, std::int32_t)
    {
        if (!mHasFrame)
            readFrame();
        const std::uint32_t folded = mFolded[axis * mCount + place];
        return std::int32_t(folded >> 1) ^ -std::int32_t(folded & 1);
    }
    bool endFrame() { return !mIsBad; }
    /// True if the stream ends here and is whole.
    bool isAtEnd();

private:
    void readFrame();
    void read(std::span<std::uint8_t> out);

    std::size_t mCount;
    std::vector<std::uint32_t> mFolded;
    std::vector<std::uint8_t> mPlane;
    std::unique_ptr<z_stream_s> mStream;
    bool mHasFrame = false;
    bool mIsBad = false;
};

} // namespace model::codec
