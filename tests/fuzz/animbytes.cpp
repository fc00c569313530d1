// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/animbytes.h"

#include <zlib.h>

using namespace model;

namespace tests {

namespace {

constexpr std::uint8_t Magic[8]{0x89, 'S', 'R', 'A', 0x0d, 0x0a, 0x1a, 0x0a};

std::uint32_t checksum(std::span<const std::uint8_t> tag, std::span<const std::uint8_t> payload)
{
    uLong crc = ::crc32(0, tag.data(), uInt(tag.size()));
    if (!payload.empty())
        crc = ::crc32(crc, payload.data(), uInt(payload.size()));
    return std::uint32_t(crc);
}

} // namespace

std::vector<RawChunk> chunksOf(std::span<const std::uint8_t> file)
{
    std::vector<RawChunk> chunks;
    ByteReader reader(file);
    reader.bytes(sizeof Magic);
    while (reader.left() > 0) {
        const auto tag = reader.bytes(4);
        const auto payload = reader.bytes(reader.varUint());
        reader.u32();
        if (!reader.ok())
            break;
        chunks.push_back({std::string(tag.begin(), tag.end()), Bytes(payload.begin(), payload.end())});
    }
    return chunks;
}

Bytes fileOf(const std::vector<RawChunk> &chunks)
{
    ByteWriter writer;
    writer.bytes(Magic);
    for (const RawChunk &chunk : chunks) {
        const Bytes tag(chunk.tag.begin(), chunk.tag.end());
        writer.bytes(tag);
        writer.varUint(chunk.payload.size());
        writer.bytes(chunk.payload);
        writer.u32(checksum(tag, chunk.payload));
    }
    return writer.take();
}

Bytes withChecksums(std::span<const std::uint8_t> file)
{
    Bytes result(file.begin(), file.end());
    ByteReader reader(file);
    reader.bytes(sizeof Magic);
    while (reader.left() > 0) {
        const auto tag = reader.bytes(4);
        const auto payload = reader.bytes(reader.varUint());
        const std::uint64_t at = reader.offset();
        reader.u32();
        if (!reader.ok())
            break;
        for (unsigned i = 0; i < 4; ++i)
            result[at + i] = std::uint8_t(checksum(tag, payload) >> (8 * i));
    }
    return result;
}

} // namespace tests
