// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// For fuzzers whose input is an `.anim` file: without these a checksum would stop nearly every changed file.
namespace tests {

struct RawChunk
{
    std::string tag;
    model::Bytes payload;
};

/// The chunks up to the first that is not whole; any bytes.
std::vector<RawChunk> chunksOf(std::span<const std::uint8_t> file);
/// With the magic, lengths and checksums that are right.
model::Bytes fileOf(const std::vector<RawChunk> &chunks);

/// The file with the checksums of all whole chunks mended; everything else as it is.
model::Bytes withChecksums(std::span<const std::uint8_t> file);

} // namespace tests
