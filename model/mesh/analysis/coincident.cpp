// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/analysis/coincident.h"

#include <bit>

namespace model {

namespace {

std::uint64_t hashOf(Vec3f p)
{
    std::uint64_t hash = 0;
    for (const float c : {p.x, p.y, p.z}) {
        hash = (hash ^ std::bit_cast<std::uint32_t>(c + 0.0f)) * 0x9e3779b97f4a7c15u; // -0 + 0 is +0
        hash ^= hash >> 29;
    }
    return hash * 0xbf58476d1ce4e5b9u >> 16;
}

} // namespace

std::vector<ProblemIds> findCoincidentVertices(std::span<const Vec3f> positions)
{
    // An open table, at most half full.
    const std::size_t size = std::bit_ceil(2 * positions.size() + 1);
    std::vector<std::uint32_t> table(size, NoId);
    std::vector<ProblemIds> pairs;
    for (std::uint32_t v = 0; v < positions.size(); ++v) {
        std::size_t at = hashOf(positions[v]) & (size - 1);
        while (table[at] != NoId && !(positions[table[at]] == positions[v]))
            at = (at + 1) & (size - 1);
        if (table[at] == NoId)
            table[at] = v;
        else
            pairs.push_back({v, table[at]});
    }
    return pairs;
}

} // namespace model
