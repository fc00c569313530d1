// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

namespace model::codec {

/// CRC-32 of zlib, PNG and gzip: reflected polynomial 0xedb88320, start and final value inverted.
/// \param crc  the result for the bytes before, to go on from there; 0 at the start
std::uint32_t crc32(std::span<const std::uint8_t> data, std::uint32_t crc = 0);

} // namespace model::codec
