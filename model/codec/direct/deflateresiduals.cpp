// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/direct/deflateresiduals.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

namespace model::codec {

namespace {

// zlib counts in unsigned int: longer data go to it in pieces.
constexpr std::size_t PieceBytes = std::size_t(1) << 30;
constexpr unsigned MaxPlanes = 4;

} // namespace

DeflateWriter::DeflateWriter(const MeshWalk &walk)
    : mCount(walk.vertexCount())
    , mFolded(3 * mCount)
{}

std::int32_t DeflateWriter::weight(std::size_t, std::size_t, std::int32_t value)
{
    mOut.u16(std::uint16_t(value));
    return value;
}

bool DeflateWriter::endFrame()
{
    const std::uint32_t largest = *std::max_element(mFolded.begin(), mFolded.end());
    unsigned planes = 0;
    while (planes < MaxPlanes && largest >> (8 * planes) != 0)
        ++planes;
    mOut.u8(std::uint8_t(planes));
    for (unsigned plane = 0; plane < planes; ++plane)
        for (const std::uint32_t folded : mFolded)
            mOut.u8(std::uint8_t(folded >> (8 * plane)));
    return true;
}

Bytes DeflateWriter::finish()
{
    Bytes packed;
    z_stream stream{};
    if (deflateInit(&stream, Z_BEST_COMPRESSION) != Z_OK)
        throw std::bad_alloc(); // its only cause here
    const Bytes &plain = mOut.data();
    std::vector<Bytef> block(1u << 16);
    std::size_t at = 0;
    int state = Z_OK;
    while (state != Z_STREAM_END) {
        if (stream.avail_in == 0 && at < plain.size()) {
            stream.next_in = const_cast<Bytef *>(plain.data() + at);
            stream.avail_in = uInt(std::min(PieceBytes, plain.size() - at));
            at += stream.avail_in;
        }
        stream.next_out = block.data();
        stream.avail_out = uInt(block.size());
        state = deflate(&stream, at == plain.size() ? Z_FINISH : Z_NO_FLUSH);
        packed.insert(packed.end(), block.data(), block.data() + (block.size() - stream.avail_out));
    }
    deflateEnd(&stream);
    return packed;
}

DeflateReader::DeflateReader(const MeshWalk &walk, std::span<const std::uint8_t> stream)
    : mCount(walk.vertexCount())
    , mFolded(3 * mCount)
    , mPlane(3 * mCount)
    , mStream(std::make_unique<z_stream>())
{
    *mStream = z_stream{};
    mStream->next_in = const_cast<Bytef *>(stream.data());
    mStream->avail_in = uInt(stream.size());
    mIsBad = stream.size() > std::numeric_limits<uInt>::max() || inflateInit(mStream.get()) != Z_OK;
}

DeflateReader::~DeflateReader()
{
    inflateEnd(mStream.get());
}

void DeflateReader::read(std::span<std::uint8_t> out)
{
    std::size_t at = 0;
    while (at < out.size() && !mIsBad) {
        mStream->next_out = out.data() + at;
        mStream->avail_out = uInt(std::min(PieceBytes, out.size() - at));
        const uInt room = mStream->avail_out;
        const int state = inflate(mStream.get(), Z_NO_FLUSH);
        at += room - mStream->avail_out;
        if (state != Z_OK && at < out.size())
            mIsBad = true;
    }
    if (mIsBad)
        std::fill(out.begin(), out.end(), std::uint8_t(0));
}

std::int32_t DeflateReader::weight(std::size_t, std::size_t, std::int32_t)
{
    std::uint8_t bytes[2];
    read(bytes);
    return std::int16_t(std::uint16_t(bytes[0] | (bytes[1] << 8)));
}

void DeflateReader::readFrame()
{
    mHasFrame = true;
    std::fill(mFolded.begin(), mFolded.end(), 0u);
    std::uint8_t planes = 0;
    read({&planes, 1});
    mIsBad = mIsBad || planes > MaxPlanes;
    for (unsigned plane = 0; plane < planes && !mIsBad; ++plane) {
        read(mPlane);
        for (std::size_t i = 0; i < mFolded.size(); ++i)
            mFolded[i] |= std::uint32_t(mPlane[i]) << (8 * plane);
    }
}

bool DeflateReader::isAtEnd()
{
    if (mIsBad)
        return false;
    std::uint8_t beyond = 0;
    mStream->next_out = &beyond;
    mStream->avail_out = 1;
    return inflate(mStream.get(), Z_NO_FLUSH) == Z_STREAM_END && mStream->avail_out == 1 && mStream->avail_in == 0;
}

} // namespace model::codec
