// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/vertexedges.h"

#include <algorithm>

namespace model {

VertexEdges::VertexEdges(const Connectivity &connectivity)
    : mFirst(std::size_t(connectivity.vertexCount) + 1)
{
    mEdges.reserve(connectivity.triangles.size() * 3);
    for (const Triangle &triangle : connectivity.triangles)
        for (int corner = 0; corner < 3; ++corner) {
            const auto [a, b] = std::minmax(triangle[std::size_t(corner)], triangle[std::size_t((corner + 1) % 3)]);
            if (a != b)
                mEdges.push_back({a, b});
        }
    std::ranges::sort(mEdges);
    mEdges.erase(std::unique(mEdges.begin(), mEdges.end()), mEdges.end());
    mEdges.shrink_to_fit();

    for (const Edge &edge : mEdges)
        for (const std::uint32_t end : edge)
            ++mFirst[end + 1];
    for (std::size_t i = 1; i < mFirst.size(); ++i)
        mFirst[i] += mFirst[i - 1];
    mAtVertex.resize(2 * mEdges.size());
    std::vector<std::size_t> next(mFirst.begin(), mFirst.end() - 1);
    for (std::size_t e = 0; e < mEdges.size(); ++e)
        for (const std::uint32_t end : mEdges[e])
            mAtVertex[next[end]++] = std::uint32_t(e);
}

void findEdgesAround(const VertexEdges &edges, std::uint32_t vertex, std::vector<std::uint32_t> &found)
{
    const std::span<const std::uint32_t> own = edges.at(vertex);
    found.assign(own.begin(), own.end());
    for (const std::uint32_t edge : own) {
        const std::span<const std::uint32_t> next = edges.at(edges.otherEnd(edge, vertex));
        found.insert(found.end(), next.begin(), next.end());
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
}

} // namespace model
