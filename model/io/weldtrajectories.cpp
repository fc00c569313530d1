// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/weldtrajectories.h"

#include <bit>
#include <cstdint>

namespace model::io {

namespace {

// A comparison of two vertices goes through all frames and misses the cache in each: 64 of them take 10 ms at 1000
// frames.
constexpr std::size_t VerticesPerLook = 64;

std::vector<std::uint64_t> hashesOf(const std::vector<Vec3f> &positions, std::size_t vertexCount,
                                    const Progress &progress)
{
    std::vector<std::uint64_t> hashes(vertexCount, 0);
    for (std::size_t frame = 0; frame < positions.size() && !progress.isCancelled(); frame += vertexCount) {
        for (std::size_t i = 0; i < vertexCount; ++i) {
            const Vec3f &p = positions[frame + i];
            std::uint64_t &hash = hashes[i];
            for (const float c : {p.x, p.y, p.z}) {
                // Adding zero makes minus zero zero, which it equals.
                hash = (hash ^ std::bit_cast<std::uint32_t>(c + 0.0f)) * 0x9E3779B97F4A7C15;
                hash ^= hash >> 32;
            }
        }
    }
    return hashes;
}

} // namespace

Result<void> weldTrajectories(Connectivity &connectivity, std::vector<Vec3f> &positions, const Progress &progress)
{
    const std::size_t vertexCount = connectivity.vertexCount;
    const auto isSame = [&](std::size_t a, std::size_t b) {
        for (std::size_t frame = 0; frame < positions.size(); frame += vertexCount)
            if (positions[frame + a] != positions[frame + b])
                return false;
        return true;
    };

    // Open addressing, at most half full. An entry holds a vertex plus one.
    const std::vector<std::uint64_t> hashes = hashesOf(positions, vertexCount, progress);
    std::vector<std::uint32_t> table(std::bit_ceil(2 * vertexCount + 1), 0);
    const std::size_t mask = table.size() - 1;
    std::vector<std::uint32_t> kept;                  // the vertices that stay
    std::vector<std::uint32_t> newIndex(vertexCount); // of each vertex
    for (std::size_t i = 0; i < vertexCount; ++i) {
        if (i % VerticesPerLook == 0 && progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        std::size_t entry = std::size_t(hashes[i]) & mask;
        while (table[entry] && !(hashes[table[entry] - 1] == hashes[i] && isSame(table[entry] - 1, i)))
            entry = (entry + 1) & mask;
        if (!table[entry]) {
            table[entry] = std::uint32_t(i + 1);
            newIndex[i] = std::uint32_t(kept.size());
            kept.push_back(std::uint32_t(i));
        } else {
            newIndex[i] = newIndex[table[entry] - 1];
        }
    }

    auto out = positions.begin();
    for (std::size_t frame = 0; frame < positions.size(); frame += vertexCount) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        for (const std::uint32_t vertex : kept)
            *out++ = positions[frame + vertex]; // never behind where it reads
    }
    positions.erase(out, positions.end());
    positions.shrink_to_fit();
    for (Triangle &triangle : connectivity.triangles)
        for (std::uint32_t &index : triangle)
            index = newIndex[index];
    connectivity.vertexCount = std::uint32_t(kept.size());
    return {};
}

} // namespace model::io
