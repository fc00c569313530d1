// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/io/textcursor.h"

#include <array>
#include <cstdint>
#include <vector>

namespace model::io {

enum class PlyType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

inline std::size_t sizeOf(PlyType type)
{
    constexpr std::array<std::size_t, 8> Sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return Sizes[std::size_t(type)];
}
inline bool isInteger(PlyType type)
{
    return type < PlyType::Float32;
}

struct PlyProperty
{
    /// What the reader takes from it.
    enum class Role : std::uint8_t { None, X, Y, Z, Corners };

    PlyType type = PlyType::Float32; ///< of the value, or of each value of a list
    bool isList = false;
    PlyType countType = PlyType::Uint8; ///< of a list's length
    Role role = Role::None;
};

struct PlyElement
{
    enum class Kind : std::uint8_t { Other, Vertex, Face };

    Kind kind = Kind::Other;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// Bytes of one element in a binary file, lists taken as empty.
    std::uint64_t minBytes() const;
};

struct PlyHeader
{
    enum class Format : std::uint8_t { Text, LittleEndian, BigEndian };

    Format format = Format::Text;
    std::vector<PlyElement> elements;
    std::uint64_t vertexCount = 0;
    std::uint64_t faceCount = 0;
};

/// Parses the header and leaves the cursor at the first byte of the data. Errors: see parsePly.
Result<PlyHeader> parsePlyHeader(TextCursor &cursor);

} // namespace model::io
