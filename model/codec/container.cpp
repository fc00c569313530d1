// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/container.h"

#include "model/codec/crc32.h"
#include "model/codec/syntax.h"

#include <algorithm>

namespace model::codec {

namespace {

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

Result<Chunk> readChunk(ByteReader &reader)
{
    const std::uint64_t start = reader.offset();
    const auto tag = reader.bytes(4);
    for (const std::uint8_t c : tag)
        reader.require(isTagCharacter(c), "chunk tag", c, "letters and digits");
    const std::uint64_t length = reader.varUint();
    Chunk chunk;
    chunk.tag.assign(tag.begin(), tag.end());
    chunk.offset = reader.offset();
    chunk.payload = reader.bytes(length);
    chunk.crc = reader.u32();
    if (!reader.ok())
        return fail(reader.error());
    chunk.size = reader.offset() - start;
    if (crc32(chunk.payload, crc32(tag)) != chunk.crc)
        return fail(Error{ErrorCode::ChecksumMismatch, {chunk.tag}, {}, Error::None, start});
    return chunk;
}

} // namespace

const std::string &creatorName()
{
    static const std::string name = "Sandreel " SANDREEL_VERSION;
    return name;
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
        return fail(ErrorCode::MissingChunk, std::string(tag));
    const auto second = std::find_if(first + 1, chunks.end(), hasTag);
    if (second != chunks.end())
        return fail(Error{ErrorCode::DuplicateChunk, {std::string(tag)}, {}, Error::None, second->offset});
    return *first;
}

Result<Container> readContainer(std::span<const std::uint8_t> file)
{
    ByteReader reader(file);
    // A file cut short within its magic is still told from a file of another kind.
    const std::size_t there = std::min(file.size(), Magic.size());
    if (there == 0 || !std::equal(Magic.begin(), Magic.begin() + std::ptrdiff_t(there), file.begin()))
        return fail(Error{ErrorCode::BadMagic, {".anim"}, {}, Error::None, 0});
    reader.bytes(Magic.size());
    Container container;
    bool ended = false;
    while (!ended) {
        Result<Chunk> chunk = readChunk(reader);
        if (!chunk)
            return fail(std::move(chunk).error());
        ended = chunk->tag == EndTag;
        // The version decides how everything after it is read, so it comes first.
        if (container.chunks.empty()) {
            if (chunk->tag != HeaderTag)
                return fail(Error{ErrorCode::MissingChunk, {std::string(HeaderTag)}, {}, Error::None, Magic.size()});
            Result<Header> header = decodeHeader(*chunk);
            if (!header)
                return fail(std::move(header).error());
            container.header = std::move(*header);
        }
        if (ended && !chunk->payload.empty())
            return fail(Error{
                ErrorCode::TrailingBytes, {std::to_string(chunk->payload.size())}, {}, Error::None, chunk->offset});
        container.chunks.push_back(std::move(*chunk));
    }
    if (!reader.requireEnd())
        return fail(reader.error());
    if (const auto header = container.only(HeaderTag); !header)
        return fail(header.error());
    return container;
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
