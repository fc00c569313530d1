// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tests::plain {

/// FORMAT.md 13.2.
struct Node
{
    std::size_t vertex = 0; ///< or frame
    unsigned level = 0;
    std::vector<std::size_t> known, ring, adjacent; ///< nodes
    std::vector<std::uint64_t> ringLengths;
};

std::vector<Node> vertexNodes(const std::vector<std::array<std::int64_t, 3>> &triangles, std::size_t vertices);
std::vector<Node> frameNodes(std::size_t frames);

} // namespace tests::plain
