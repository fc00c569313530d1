// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"

#include <array>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace model {
class FrameSource;
enum class CodecId : std::uint8_t;
} // namespace model

namespace model::codec {

/// The version of the format that is written, and the newest that is read; FORMAT.md section 1 has the table.
inline constexpr std::uint8_t FormatMajor = 1;
inline constexpr std::uint8_t FormatMinor = 0;

/// FORMAT.md 3.1. As PNG's: a byte above 127 shows transfer as 7-bit text, the line ends show their conversion, and
/// 0x1a ends a listing in some shells.
inline constexpr std::array<std::uint8_t, 8> Magic{0x89, 'S', 'R', 'A', 0x0d, 0x0a, 0x1a, 0x0a};

inline constexpr std::string_view HeaderTag = "HEAD";
inline constexpr std::string_view EndTag = "TAIL";
inline constexpr std::size_t CrcLength = 4; ///< bytes, after the payload

inline constexpr std::uint64_t MaxCreatorLength = 255; ///< bytes
inline constexpr std::uint64_t MaxNameLength = 65535;  ///< bytes
inline constexpr std::uint32_t MaxVertices = 1u << 30;
inline constexpr std::uint32_t MaxTriangles = 1u << 30;
inline constexpr std::uint32_t MaxFrames = 1u << 26;
inline constexpr double MinFrameRate = 1e-6; ///< frames per second
inline constexpr double MaxFrameRate = 1e6;

/// The program that writes, e.g. "Sandreel 0.1.0".
const std::string &creatorName();

/// What is known about an animation before any codec is asked. FORMAT.md 3.3.
struct Header
{
    std::uint8_t major = FormatMajor;
    std::uint8_t minor = FormatMinor;
    std::uint64_t features = 0; ///< a set bit is a feature that a reader must know; none are defined yet
    std::uint8_t codec = 0;
    std::uint32_t vertexCount = 0;
    std::uint32_t triangleCount = 0;
    std::uint32_t frameCount = 0;
    double frameRate = 25;
    std::string creator;
    std::string name;
    Bytes extra; ///< fields that a newer minor version added, kept as they are
};

/// What the header of a file with this animation says.
Header headerOf(const FrameSource &source, CodecId codec);

struct Chunk
{
    std::string tag; ///< four characters
    std::span<const std::uint8_t> payload;
    std::uint64_t offset = 0; ///< of the payload in the file
    std::uint64_t size = 0;   ///< with tag, length and CRC
    std::uint32_t crc = 0;
};

/// A file taken apart; the payloads are views of it. All checksums have been verified.
struct Container
{
    Header header;
    std::vector<Chunk> chunks; ///< in the order of the file, the header's and the end's included

    bool has(std::string_view tag) const;
    /// The chunk with this tag. \error MissingChunk, DuplicateChunk
    Result<Chunk> only(std::string_view tag) const;
    /// The chunks with these tags, in this order. \error MissingChunk, DuplicateChunk
    Result<std::vector<Chunk>> each(std::initializer_list<std::string_view> tags) const;
    /// The chunk with this tag if there is one. \error DuplicateChunk
    Result<std::optional<Chunk>> optional(std::string_view tag) const;
};

/// A digest of their payloads.
std::uint64_t digestOf(std::span<const Chunk> chunks);

/// \error BadMagic, UnsupportedVersion, UnsupportedFeature, Truncated, ChecksumMismatch, MissingChunk, DuplicateChunk,
///        BadValue, TrailingBytes; each with its offset
Result<Container> readContainer(std::span<const std::uint8_t> file);

/// The chunk that a file which is not whole breaks off in.
struct CutChunk
{
    std::string tag;
    std::uint64_t length = 0; ///< of the whole payload, as declared: nothing of it need be true
    /// What has come of it; no checksum has been verified.
    std::span<const std::uint8_t> payload;
    std::uint64_t offset = 0; ///< of the payload in the file
};

/// Takes a file apart while its bytes come. Chunks that are whole have been verified as readContainer() does; the last
/// one may be cut short. Each byte is looked at once, however small the pieces are.
class ContainerReader
{
public:
    /// \error as readContainer() but Truncated, as soon as the bytes show it; the reader is of no use then
    Result<void> append(std::span<const std::uint8_t> piece);

    /// Null until its chunk is whole.
    const Header *header() const { return mParts.empty() ? nullptr : &mHeader; }
    /// Chunks that are whole, the header's included.
    std::size_t chunkCount() const { return mParts.size(); }
    /// A view of file(), valid until append().
    Chunk chunk(std::size_t index) const;
    /// The chunk after these, once tag and length are there. A view of file(), valid until append().
    std::optional<CutChunk> cut() const;
    /// The end was read.
    bool isComplete() const { return mEnded; }
    /// Bytes that the file has at least, as far as it is known.
    std::uint64_t leastBytes() const;
    /// All bytes so far.
    const Bytes &file() const { return mFile; }
    Bytes takeFile() { return std::move(mFile); }

private:
    struct Part
    {
        std::string tag;
        std::size_t offset = 0, length = 0;
        std::uint64_t size = 0;
        std::uint32_t crc = 0;
    };

    ByteReader rest() const { return ByteReader(std::span(mFile).subspan(mNext), mNext); }

    Bytes mFile;
    std::size_t mNext = 0; ///< where the chunk after mParts starts; 0 until the magic was seen
    Header mHeader;
    std::vector<Part> mParts;
    bool mEnded = false;
};

/// Puts a file together: the header, then what chunk() adds, then the end.
class ContainerWriter
{
public:
    explicit ContainerWriter(const Header &header);
    void chunk(std::string_view tag, std::span<const std::uint8_t> payload);
    Bytes finish();

private:
    ByteWriter mOut;
};

} // namespace model::codec
