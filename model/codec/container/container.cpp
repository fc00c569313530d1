// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/container/container.h"

#include "model/animation/compressionsettings.h"
#include "model/animation/framesource.h"
#include "model/base/digest.h"
#include "model/codec/container/crc32.h"
#include "model/codec/container/syntax.h"

#include <algorithm>

namespace model::codec {

namespace {

constexpr std::size_t TagLength = 4;
// No payload is as long: sums of lengths do not overflow.
constexpr std::uint64_t MaxLength = std::uint64_t(1) << 62;

std::string versionText(unsigned major, unsigned minor)
{
    return std::to_string(major) + '.' + std::to_string(minor);
}

std::span<const std::uint8_t> bytesOf(std::string_view text)
{
    return {reinterpret_cast<const std::uint8_t *>(text.data()), text.size()};
}

bool isTagCharacter(std::uint8_t c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

// FORMAT.md 3.3, after the version
template <class Stream, class Fields>
bool headerSyntax(Stream &s, Fields &h)
{
    return s.varUint(h.features) && s.u8(h.codec) && s.varUint(h.vertexCount) &&
           s.require(h.vertexCount >= 1 && h.vertexCount <= MaxVertices, "vertex count", h.vertexCount, "1 ... 2^30") &&
           s.varUint(h.triangleCount) &&
           s.require(h.triangleCount <= MaxTriangles, "triangle count", h.triangleCount, "0 ... 2^30") &&
           s.varUint(h.frameCount) &&
           s.require(h.frameCount >= 1 && h.frameCount <= MaxFrames, "frame count", h.frameCount, "1 ... 2^26") &&
           s.f64(h.frameRate) && s.requireReal(h.frameRate, MinFrameRate, MaxFrameRate, "frame rate") &&
           s.text(h.creator, MaxCreatorLength) && s.text(h.name, MaxNameLength);
}

Bytes encodeHeader(const Header &header)
{
    SyntaxWriter writer;
    writer.u8(header.major);
    writer.u8(header.minor);
    headerSyntax(writer, header);
    Bytes bytes = writer.take();
    bytes.insert(bytes.end(), header.extra.begin(), header.extra.end());
    return bytes;
}

Result<Header> decodeHeader(const Chunk &chunk)
{
    Header header;
    ByteReader reader(chunk.payload, chunk.offset);
    header.major = reader.u8();
    header.minor = reader.u8();
    if (reader.ok() && header.major > FormatMajor)
        return fail(Error{ErrorCode::UnsupportedVersion,
                          {versionText(header.major, header.minor), versionText(FormatMajor, FormatMinor)},
                          {},
                          Error::None,
                          chunk.offset});
    reader.require(header.major == FormatMajor, "format version", header.major, std::to_string(FormatMajor));
    SyntaxReader syntax(reader);
    if (headerSyntax(syntax, header) && header.features != 0)
        return fail(Error{ErrorCode::UnsupportedFeature,
                          {"feature bits " + std::to_string(header.features)},
                          {},
                          Error::None,
                          chunk.offset + 2});
    if (reader.ok() && header.minor > FormatMinor) {
        const auto extra = reader.bytes(reader.left());
        header.extra.assign(extra.begin(), extra.end());
    }
    if (!reader.requireEnd())
        return fail(reader.error());
    return header;
}

struct ChunkStart
{
    std::string tag;
    std::uint64_t length = 0;
};

ChunkStart readChunkStart(ByteReader &reader)
{
    ChunkStart start;
    const auto tag = reader.bytes(TagLength);
    for (const std::uint8_t c : tag)
        reader.require(isTagCharacter(c), "chunk tag", c, "letters and digits");
    start.length = reader.varUint();
    start.tag.assign(tag.begin(), tag.end());
    return start;
}

Result<Chunk> readChunk(ByteReader &reader)
{
    const std::uint64_t start = reader.offset();
    const auto [tag, length] = readChunkStart(reader);
    Chunk chunk;
    chunk.tag = tag;
    chunk.offset = reader.offset();
    chunk.payload = reader.bytes(length);
    chunk.crc = reader.u32();
    if (!reader.ok())
        return fail(reader.error());
    chunk.size = reader.offset() - start;
    if (crc32(chunk.payload, crc32(bytesOf(tag))) != chunk.crc)
        return fail(Error{ErrorCode::ChecksumMismatch, {chunk.tag}, {}, Error::None, start});
    return chunk;
}

// A file cut short within its magic is still told from a file of another kind.
bool startsWithMagic(std::span<const std::uint8_t> file)
{
    const std::size_t there = std::min(file.size(), Magic.size());
    return there > 0 && std::equal(Magic.begin(), Magic.begin() + std::ptrdiff_t(there), file.begin());
}

/// What is asked of a chunk by its place in the file. \param header  filled by the first chunk
Result<void> acceptChunk(const Chunk &chunk, bool isFirst, Header &header)
{
    // The version decides how everything after it is read, so it comes first.
    if (isFirst) {
        if (chunk.tag != HeaderTag)
            return fail(Error{ErrorCode::MissingChunk, {std::string(HeaderTag)}, {}, Error::None, Magic.size()});
        Result<Header> decoded = decodeHeader(chunk);
        if (!decoded)
            return fail(std::move(decoded).error());
        header = std::move(*decoded);
    } else if (chunk.tag == HeaderTag) {
        return fail(Error{ErrorCode::DuplicateChunk, {std::string(HeaderTag)}, {}, Error::None, chunk.offset});
    }
    if (chunk.tag == EndTag && !chunk.payload.empty())
        return fail(
            Error{ErrorCode::TrailingBytes, {std::to_string(chunk.payload.size())}, {}, Error::None, chunk.offset});
    return {};
}

} // namespace

const std::string &creatorName()
{
    static const std::string name = "Sandreel " SANDREEL_VERSION;
    return name;
}

Header headerOf(const FrameSource &source, CodecId codec)
{
    Header header;
    header.codec = std::uint8_t(codec);
    header.vertexCount = source.vertexCount();
    header.triangleCount = std::uint32_t(source.connectivity().triangles.size());
    header.frameCount = source.frameCount();
    header.frameRate = source.frameRate();
    header.creator = creatorName();
    header.name = source.name();
    return header;
}

bool Container::has(std::string_view tag) const
{
    return std::any_of(chunks.begin(), chunks.end(), [&](const Chunk &chunk) { return chunk.tag == tag; });
}

Result<Chunk> Container::only(std::string_view tag) const
{
    const auto hasTag = [&](const Chunk &chunk) { return chunk.tag == tag; };
    const auto first = std::find_if(chunks.begin(), chunks.end(), hasTag);
    if (first == chunks.end())
        return fail(Error{ErrorCode::MissingChunk, {std::string(tag)}, {}, Error::None, chunks.back().offset});
    const auto second = std::find_if(first + 1, chunks.end(), hasTag);
    if (second != chunks.end())
        return fail(Error{ErrorCode::DuplicateChunk, {std::string(tag)}, {}, Error::None, second->offset});
    return *first;
}

Result<std::vector<Chunk>> Container::each(std::initializer_list<std::string_view> tags) const
{
    std::vector<Chunk> result;
    for (const std::string_view tag : tags) {
        Result<Chunk> chunk = only(tag);
        if (!chunk)
            return fail(std::move(chunk).error());
        result.push_back(std::move(*chunk));
    }
    return result;
}

Result<std::optional<Chunk>> Container::optional(std::string_view tag) const
{
    if (!has(tag))
        return std::nullopt;
    return only(tag).map([](Chunk chunk) { return std::optional(std::move(chunk)); });
}

std::uint64_t digestOf(std::span<const Chunk> chunks)
{
    std::uint64_t digest = 0;
    for (const Chunk &chunk : chunks)
        digest = digestOfArray(chunk.payload, digest);
    return digest;
}

Result<Container> readContainer(std::span<const std::uint8_t> file)
{
    if (!startsWithMagic(file))
        return fail(Error{ErrorCode::BadMagic, {".anim"}, {}, Error::None, 0});
    ByteReader reader(file);
    reader.bytes(Magic.size());
    Container container;
    bool ended = false;
    while (!ended) {
        Result<Chunk> chunk = readChunk(reader);
        if (!chunk)
            return fail(std::move(chunk).error());
        ended = chunk->tag == EndTag;
        if (const auto accepted = acceptChunk(*chunk, container.chunks.empty(), container.header); !accepted)
            return fail(accepted.error());
        container.chunks.push_back(std::move(*chunk));
    }
    if (!reader.requireEnd())
        return fail(reader.error());
    return container;
}

Result<void> ContainerReader::append(std::span<const std::uint8_t> piece)
{
    mFile.insert(mFile.end(), piece.begin(), piece.end());
    if (!mFile.empty() && !startsWithMagic(mFile))
        return fail(Error{ErrorCode::BadMagic, {".anim"}, {}, Error::None, 0});
    if (mFile.size() < Magic.size())
        return {};
    mNext = std::max(mNext, Magic.size());
    while (!mEnded) {
        ByteReader reader = rest();
        const Result<Chunk> chunk = readChunk(reader);
        if (!chunk && chunk.error().code == ErrorCode::Truncated)
            return {}; // for now
        if (!chunk)
            return fail(chunk.error());
        if (const auto accepted = acceptChunk(*chunk, mParts.empty(), mHeader); !accepted)
            return fail(accepted.error());
        mParts.push_back({chunk->tag, std::size_t(chunk->offset), chunk->payload.size(), chunk->size, chunk->crc});
        mNext = std::size_t(reader.offset());
        mEnded = chunk->tag == EndTag;
    }
    ByteReader end = rest();
    if (!end.requireEnd())
        return fail(end.error());
    return {};
}

Chunk ContainerReader::chunk(std::size_t index) const
{
    const Part &part = mParts[index];
    return {part.tag, std::span(mFile).subspan(part.offset, part.length), part.offset, part.size, part.crc};
}

std::optional<CutChunk> ContainerReader::cut() const
{
    if (mNext == 0 || mEnded)
        return {};
    ByteReader reader = rest();
    const auto [tag, length] = readChunkStart(reader);
    if (!reader.ok())
        return {};
    const std::uint64_t offset = reader.offset();
    return CutChunk{tag, length, reader.bytes(std::min<std::uint64_t>(length, reader.left())), offset};
}

std::uint64_t ContainerReader::leastBytes() const
{
    if (mEnded)
        return mFile.size();
    constexpr std::uint64_t EndLength = TagLength + 1 + CrcLength;
    const std::optional<CutChunk> chunk = cut();
    if (!chunk)
        return std::max<std::uint64_t>(mFile.size() + 1, std::max(mNext, Magic.size()) + EndLength);
    const std::uint64_t end = chunk->offset + std::min(chunk->length, MaxLength) + CrcLength;
    return end + (chunk->tag == EndTag ? 0 : EndLength);
}

ContainerWriter::ContainerWriter(const Header &header)
{
    for (const std::uint8_t byte : Magic)
        mOut.u8(byte);
    chunk(HeaderTag, encodeHeader(header));
}

void ContainerWriter::chunk(std::string_view tag, std::span<const std::uint8_t> payload)
{
    mOut.bytes(bytesOf(tag));
    mOut.varUint(payload.size());
    mOut.bytes(payload);
    mOut.u32(crc32(payload, crc32(bytesOf(tag))));
}

Bytes ContainerWriter::finish()
{
    chunk(EndTag, {});
    return mOut.take();
}

} // namespace model::codec
