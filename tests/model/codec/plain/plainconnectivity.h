// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tests {

/// What FORMAT.md 12 makes of the chunk `CLRS`, by a second, plain decoder that was written from the document alone.
struct PlainConnectivity
{
    std::vector<std::array<std::int64_t, 3>> triangles;
    /// 12.7: left, right, opposite of each vertex; -1: none
    std::vector<std::array<std::int64_t, 3>> neighbours;
};

/// Throws a std::string if the stream is not as it must be.
PlainConnectivity decodeConnectivityPlainly(const std::vector<std::uint8_t> &payload, std::uint64_t vertices,
                                            std::uint64_t triangles);

/// FORMAT.md 15: the place of each vertex. Throws a std::string.
std::vector<std::int64_t> decodeOrderPlainly(const std::vector<std::uint8_t> &payload,
                                             const std::vector<std::array<std::int64_t, 3>> &neighbours);

} // namespace tests
