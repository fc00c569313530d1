// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/parallel.h"
#include "model/mesh/cornertable.h"

#include <algorithm>

namespace model {

inline bool isDegenerate(const Triangle &t)
{
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Calls visit(sides) once for each edge of the triangles without a repeated index; `sides`, a span of const Corner,
/// are the corners opposite to the edge in ascending order. Edges with the same smaller vertex come in the order of
/// their larger one; different smaller vertices are visited from several threads at once. Linear time, but for vertices
/// of very many triangles, whose edges are sorted. 4 bytes for a corner and a vertex.
template <class Visit>
void forEachEdge(const Connectivity &connectivity, const Visit &visit)
{
    // The sides in the order of their smaller vertex, by counting; then those of each vertex by their larger one.
    constexpr unsigned Next[3] = {1, 2, 0};
    std::vector<std::uint32_t> begins(std::size_t(connectivity.vertexCount) + 2);
    for (const Triangle &t : connectivity.triangles)
        if (!isDegenerate(t))
            for (unsigned i = 0; i < 3; ++i)
                ++begins[std::min(t[i], t[Next[i]]) + 2];
    for (std::size_t v = 2; v < begins.size(); ++v)
        begins[v] += begins[v - 1];
    std::vector<Corner> sides(begins.back());
    Corner corner = 0;
    for (const Triangle &t : connectivity.triangles) {
        if (!isDegenerate(t))
            for (unsigned i = 0; i < 3; ++i)
                sides[begins[std::min(t[Next[i]], t[Next[Next[i]]]) + 1]++] = corner + i;
        corner += 3;
    }

    constexpr std::size_t Grain = 1 << 14; // vertices
    parallelRanges(connectivity.vertexCount, Grain, [&](std::size_t first, std::size_t last) {
        std::vector<std::uint64_t> bucket;
        std::vector<Corner> group;
        for (std::size_t v = first; v < last; ++v) {
            bucket.clear();
            for (std::uint32_t i = begins[v]; i < begins[v + 1]; ++i) {
                const Triangle &t = connectivity.triangles[sides[i] / 3];
                const unsigned at = Next[sides[i] % 3];
                bucket.push_back(std::uint64_t(std::max(t[at], t[Next[at]])) << 32 | sides[i]);
            }
            std::sort(bucket.begin(), bucket.end());
            for (std::size_t begin = 0, end = 0; begin < bucket.size(); begin = end) {
                group.clear();
                for (; end < bucket.size() && bucket[end] >> 32 == bucket[begin] >> 32; ++end)
                    group.push_back(Corner(bucket[end]));
                visit(std::span<const Corner>(group));
            }
        }
    });
}

} // namespace model
