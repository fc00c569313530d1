// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/geometry/vec.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

namespace model::io {

/// Positions as they lie in a point cache: 32-bit floats x, y, z, one vertex after the other. Converts between that
/// and memory, in place and both ways.
inline void swapBytesUnlessNative(std::span<Vec3f> positions, std::endian order)
{
    if (order == std::endian::native)
        return;
    for (Vec3f &p : positions) {
        for (float *const c : {&p.x, &p.y, &p.z}) {
            auto bits = std::bit_cast<std::uint32_t>(*c);
            bits = bits << 24 | (bits & 0xFF00) << 8 | (bits >> 8 & 0xFF00) | bits >> 24;
            *c = std::bit_cast<float>(bits);
        }
    }
}

} // namespace model::io
