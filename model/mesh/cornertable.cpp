// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/cornertable.h"

#include "model/mesh/edgesides.h"

namespace model {

CornerTable::CornerTable(std::uint32_t vertexCount, std::vector<std::uint32_t> vertices, std::vector<Corner> opposites)
    : mVertexCount(vertexCount)
    , mVertices(std::move(vertices))
    , mOpposites(std::move(opposites))
{}

CornerTable CornerTable::of(const Connectivity &connectivity)
{
    std::vector<std::uint32_t> vertices;
    vertices.reserve(3 * connectivity.triangles.size());
    for (const Triangle &t : connectivity.triangles)
        vertices.insert(vertices.end(), t.begin(), t.end());
    std::vector<Corner> opposites(vertices.size(), NoCorner);
    forEachEdge(connectivity, [&](std::span<const Corner> sides) {
        // Opposite directions: the edge of one starts where that of the other ends.
        if (sides.size() == 2 && vertices[next(sides[0])] == vertices[previous(sides[1])]) {
            opposites[sides[0]] = sides[1];
            opposites[sides[1]] = sides[0];
        }
    });
    return {connectivity.vertexCount, std::move(vertices), std::move(opposites)};
}

Corner nextBorder(const CornerTable &table, Corner border)
{
    // Round the end of the edge, from triangle to triangle, to its other border edge.
    Corner c = CornerTable::next(border);
    while (table.opposite(c) != NoCorner)
        c = CornerTable::next(table.opposite(c));
    return c;
}

TopologyCounts topologyOf(const CornerTable &table)
{
    TopologyCounts counts;
    counts.triangles = table.triangleCount();
    std::vector<bool> seen(table.vertexCount());
    std::vector<bool> walked(table.cornerCount());
    for (Corner c = 0; c < table.cornerCount(); ++c) {
        if (!seen[table.vertex(c)]) {
            seen[table.vertex(c)] = true;
            ++counts.vertices;
        }
        counts.edges += table.opposite(c) == NoCorner || table.opposite(c) > c;
        if (table.opposite(c) != NoCorner || walked[c])
            continue;
        ++counts.borders;
        for (Corner at = c; !walked[at]; at = nextBorder(table, at))
            walked[at] = true;
    }
    std::vector<bool> reached(table.triangleCount());
    std::vector<std::uint32_t> left;
    for (std::uint32_t start = 0; start < table.triangleCount(); ++start) {
        if (reached[start])
            continue;
        ++counts.components;
        reached[start] = true;
        left.push_back(start);
        while (!left.empty()) {
            const std::uint32_t t = left.back();
            left.pop_back();
            for (Corner c = 3 * t; c < 3 * t + 3; ++c) {
                const Corner o = table.opposite(c);
                if (o == NoCorner || reached[o / 3])
                    continue;
                reached[o / 3] = true;
                left.push_back(o / 3);
            }
        }
    }
    return counts;
}

} // namespace model
