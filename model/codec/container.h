// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace model::codec {

/// The version of the format that is written, and the newest that is read; FORMAT.md section 1 has the table.
inline constexpr std::uint8_t FormatMajor = 1;
inline constexpr std::uint8_t FormatMinor = 0;

/// FORMAT.md 3.1. As PNG's: a byte above 127 shows transfer as 7-bit text, the line ends show their conversion, and
/// 0x1a ends a listing in some shells.
inline constexpr std::array<std::uint8_t, 8> Magic{0x89, 'S', 'R', 'A', 0x0d, 0x0a, 0x1a, 0x0a};

inline constexpr std::string_view HeaderTag = "HEAD";
inline constexpr std::string_view EndTag = "TAIL";

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
};

/// \error BadMagic, UnsupportedVersion, UnsupportedFeature, Truncated, ChecksumMismatch, MissingChunk, DuplicateChunk,
///        BadValue, TrailingBytes; each with its offset
Result<Container> readContainer(std::span<const std::uint8_t> file);

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
