// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/picture/graintexture.h"

#include <algorithm>
#include <cmath>

namespace views {

namespace {

/// -1 ... 1 for each corner of a lattice. Source: the finalizer of MurmurHash3 (Appleby, public domain).
float randomAt(std::uint32_t x, std::uint32_t y, std::uint32_t seed)
{
    std::uint32_t h = x * 0x9e3779b1u ^ (y + seed) * 0x85ebca6bu;
    h = (h ^ (h >> 16)) * 0x85ebca6bu;
    h = (h ^ (h >> 13)) * 0xc2b2ae35u;
    h ^= h >> 16;
    return float(h) / 2147483648.0f - 1;
}

/// Value noise with `cells` cells along a tile of side 1.
float noise(float x, float y, std::uint32_t cells, std::uint32_t seed)
{
    const float u = x * float(cells), v = y * float(cells);
    const auto i = std::uint32_t(u), j = std::uint32_t(v);
    const auto eased = [](float t) { return t * t * (3 - 2 * t); };
    const float s = eased(u - float(i)), t = eased(v - float(j));
    const auto at = [&](std::uint32_t di, std::uint32_t dj) {
        return randomAt((i + di) % cells, (j + dj) % cells, seed);
    };
    const float below = at(0, 0) + s * (at(1, 0) - at(0, 0));
    const float above = at(0, 1) + s * (at(1, 1) - at(0, 1));
    return below + t * (above - below);
}

std::uint8_t toByte(float value)
{
    return std::uint8_t(std::clamp(std::lround(value * 127 + 128), 0L, 255L));
}

} // namespace

std::vector<std::uint8_t> makeGrains()
{
    constexpr int Side = GrainSide;
    std::vector<float> heights(std::size_t(Side) * Side);
    for (int j = 0; j < Side; ++j)
        for (int i = 0; i < Side; ++i) {
            const float x = float(i) / Side, y = float(j) / Side;
            heights[std::size_t(j) * Side + i] = 0.40f * noise(x, y, 128, 1) + 0.34f * noise(x, y, 61, 2) +
                                                 0.18f * noise(x, y, 23, 3) + 0.14f * noise(x, y, 7, 4);
        }
    const auto height = [&](int i, int j) {
        return heights[std::size_t((j + Side) % Side) * Side + std::size_t((i + Side) % Side)];
    };
    std::vector<std::uint8_t> texels(heights.size() * 4);
    for (int j = 0; j < Side; ++j)
        for (int i = 0; i < Side; ++i) {
            std::uint8_t *texel = &texels[(std::size_t(j) * Side + i) * 4];
            texel[0] = toByte(height(i - 1, j) - height(i + 1, j));
            texel[1] = toByte(height(i, j - 1) - height(i, j + 1));
            texel[2] = toByte(height(i, j));
            texel[3] = toByte(randomAt(std::uint32_t(i), std::uint32_t(j), 9));
        }
    return texels;
}

} // namespace views
