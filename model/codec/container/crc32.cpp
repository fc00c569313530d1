// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/container/crc32.h"

#include <array>

namespace model::codec {

namespace {

// Slicing-by-8: eight bytes a step, one table for each. Table t holds the effect of a byte that t more bytes follow.
using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr Tables makeTables()
{
    Tables tables{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t value = i;
        for (int bit = 0; bit < 8; ++bit)
            value = (value >> 1) ^ ((value & 1) ? 0xedb88320u : 0u);
        tables[0][i] = value;
    }
    for (std::size_t t = 1; t < 8; ++t)
        for (std::size_t i = 0; i < 256; ++i)
            tables[t][i] = (tables[t - 1][i] >> 8) ^ tables[0][tables[t - 1][i] & 0xff];
    return tables;
}

constexpr Tables T = makeTables();

} // namespace

std::uint32_t crc32(std::span<const std::uint8_t> data, std::uint32_t crc)
{
    crc = ~crc;
    std::size_t i = 0;
    for (; i + 8 <= data.size(); i += 8) {
        const std::uint8_t *p = data.data() + i;
        const std::uint32_t first = crc ^ (std::uint32_t(p[0]) | std::uint32_t(p[1]) << 8 | std::uint32_t(p[2]) << 16 |
                                           std::uint32_t(p[3]) << 24);
        crc = T[7][first & 0xff] ^ T[6][(first >> 8) & 0xff] ^ T[5][(first >> 16) & 0xff] ^ T[4][first >> 24] ^
              T[3][p[4]] ^ T[2][p[5]] ^ T[1][p[6]] ^ T[0][p[7]];
    }
    for (; i < data.size(); ++i)
        crc = (crc >> 8) ^ T[0][(crc ^ data[i]) & 0xff];
    return ~crc;
}

} // namespace model::codec
