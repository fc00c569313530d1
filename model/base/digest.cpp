// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: Yann Collet, xxHash fast digest algorithm, specification 0.2.0, section XXH64.
#include "model/base/digest.h"

#include <bit>
#include <cstring>

namespace model {

namespace {

constexpr std::uint64_t Prime1 = 0x9e3779b185ebca87;
constexpr std::uint64_t Prime2 = 0xc2b2ae3d27d4eb4f;
constexpr std::uint64_t Prime3 = 0x165667b19e3779f9;
constexpr std::uint64_t Prime4 = 0x85ebca77c2b2ae63;
constexpr std::uint64_t Prime5 = 0x27d4eb2f165667c5;
constexpr std::size_t StripeBytes = 32;

template <class T>
T take(const std::byte *&at)
{
    T value;
    std::memcpy(&value, at, sizeof value);
    at += sizeof value;
    return value;
}

constexpr std::uint64_t round(std::uint64_t lane, std::uint64_t input)
{
    return std::rotl(lane + input * Prime2, 31) * Prime1;
}

std::uint64_t digestOfStripes(const std::byte *&at, const std::byte *end, std::uint64_t seed)
{
    std::uint64_t lanes[4] = {seed + Prime1 + Prime2, seed + Prime2, seed, seed - Prime1};
    while (std::size_t(end - at) >= StripeBytes)
        for (std::uint64_t &lane : lanes)
            lane = round(lane, take<std::uint64_t>(at));
    std::uint64_t result =
        std::rotl(lanes[0], 1) + std::rotl(lanes[1], 7) + std::rotl(lanes[2], 12) + std::rotl(lanes[3], 18);
    for (const std::uint64_t lane : lanes)
        result = (result ^ round(0, lane)) * Prime1 + Prime4;
    return result;
}

} // namespace

std::uint64_t digestOf(std::span<const std::byte> bytes, std::uint64_t seed)
{
    const std::byte *at = bytes.data();
    const std::byte *const end = at + bytes.size();
    std::uint64_t result = bytes.size() >= StripeBytes ? digestOfStripes(at, end, seed) : seed + Prime5;
    result += bytes.size();
    while (end - at >= 8)
        result = std::rotl(result ^ round(0, take<std::uint64_t>(at)), 27) * Prime1 + Prime4;
    if (end - at >= 4)
        result = std::rotl(result ^ (take<std::uint32_t>(at) * Prime1), 23) * Prime2 + Prime3;
    while (at != end)
        result = std::rotl(result ^ (take<std::uint8_t>(at) * Prime5), 11) * Prime1;
    result = (result ^ (result >> 33)) * Prime2;
    result = (result ^ (result >> 29)) * Prime3;
    return result ^ (result >> 32);
}

} // namespace model
