// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/cornertable.h"

#include <algorithm>

namespace model {

inline bool isDegenerate(const Triangle &t)
{
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Calls visit(sides) once for each edge of the triangles without a repeated index; `sides`, a span of const Corner,
/// are the corners opposite to the edge in ascending order. Edges come ascending by their smaller, then their larger
/// vertex. Linear time, but for vertices of very many triangles, whose edges are sorted. 4 bytes for a corner and a
/// vertex.
template <class Visit>
void forEachEdge(const Connectivity &connectivity, Visit &&visit)
{
    // The sides in the order of their smaller vertex, by counting; then those of each vertex by their larger one.
    const auto ends = [&](Corner c) {
        const Triangle &t = connectivity.triangles[c / 3];
        const std::uint32_t a = t[(c + 1) % 3], b = t[(c + 2) % 3];
        return std::pair(std::min(a, b), std::max(a, b));
    };
    const std::uint32_t cornerCount = std::uint32_t(3 * connectivity.triangles.size());
    std::vector<std::uint32_t> begins(std::size_t(connectivity.vertexCount) + 2);
    for (const Triangle &t : connectivity.triangles)
        if (!isDegenerate(t))
            for (unsigned i = 0; i < 3; ++i)
                ++begins[std::min(t[i], t[i == 2 ? 0 : i + 1]) + 2];
    for (std::size_t v = 2; v < begins.size(); ++v)
        begins[v] += begins[v - 1];
    std::vector<Corner> sides(begins.back());
    for (Corner c = 0; c < cornerCount; ++c)
        if (!isDegenerate(connectivity.triangles[c / 3]))
            sides[begins[ends(c).first + 1]++] = c;

    std::vector<std::uint64_t> bucket;
    std::vector<Corner> group;
    for (std::uint32_t v = 0; v < connectivity.vertexCount; ++v) {
        bucket.clear();
        for (std::uint32_t i = begins[v]; i < begins[v + 1]; ++i)
            bucket.push_back(std::uint64_t(ends(sides[i]).second) << 32 | sides[i]);
        std::sort(bucket.begin(), bucket.end());
        for (std::size_t first = 0, last = 0; first < bucket.size(); first = last) {
            group.clear();
            for (; last < bucket.size() && bucket[last] >> 32 == bucket[first] >> 32; ++last)
                group.push_back(Corner(bucket[last]));
            visit(std::span<const Corner>(group));
        }
    }
}

} // namespace model
