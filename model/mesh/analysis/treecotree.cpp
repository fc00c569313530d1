// SPDX-License-Identifier: GPL-3.0-or-later
// Based on:
// - D. Eppstein: Dynamic Generators of Topologically Embedded Graphs, 2003 (tree-cotree)
// - J. Erickson, K. Whittlesey: Greedy Optimal Homotopy and Homology Generators, 2005 (the cotree is a maximum spanning
//   tree of the dual graph, weighted by the length of the loop that each edge makes)
// Differs: what two ways have in common is dropped from a loop, so that it is simple; as a closed curve that may move
// freely it is the same.
#include "model/mesh/analysis/treecotree.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>

namespace model {

namespace {
constexpr std::uint32_t None = ~std::uint32_t(0);
}

TreeCotree::Graph::Graph(const ClosedSurface &surface_)
    : surface(surface_)
    , begins(surface_.vertexCount() + 2)
    , arcs(surface_.halfEdgeCount())
{
    for (const std::uint32_t vertex : surface.start)
        ++begins[vertex + 2];
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    for (std::uint32_t h = 0; h < surface.halfEdgeCount(); ++h)
        arcs[begins[surface.start[h] + 1]++] = {h, surface.end(h), surface.length[h]};
}

TreeCotree::TreeCotree(const Graph &graph, std::uint32_t root, const Progress &progress)
    : mGraph(graph)
{
    growTree(root);
    if (!progress.isCancelled())
        growCotree();
}

void TreeCotree::growTree(std::uint32_t root)
{
    const std::uint32_t count = mGraph.surface.vertexCount();
    mDistance.assign(count, std::numeric_limits<float>::max());
    mFrom.assign(count, None);
    mDepth.assign(count, 0);
    std::vector<bool> isDone(count);
    using Entry = std::pair<float, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    mDistance[root] = 0;
    queue.push({0.0f, root});
    while (!queue.empty()) {
        const std::uint32_t vertex = queue.top().second;
        queue.pop();
        if (isDone[vertex])
            continue;
        isDone[vertex] = true;
        for (std::uint32_t i = mGraph.begins[vertex]; i < mGraph.begins[vertex + 1]; ++i) {
            const Graph::Arc &arc = mGraph.arcs[i];
            const float distance = mDistance[vertex] + arc.length;
            if (isDone[arc.end] || !(distance < mDistance[arc.end]))
                continue;
            mDistance[arc.end] = distance;
            mFrom[arc.end] = arc.halfEdge;
            mDepth[arc.end] = mDepth[vertex] + 1;
            queue.push({distance, arc.end});
        }
    }
}

bool TreeCotree::isInTree(std::uint32_t h) const
{
    const ClosedSurface &surface = mGraph.surface;
    return mFrom[surface.end(h)] == h || mFrom[surface.start[h]] == surface.opposite[h];
}

void TreeCotree::growCotree()
{
    const ClosedSurface &surface = mGraph.surface;
    using Entry = std::pair<float, std::uint32_t>; // length of the loop, half-edge
    std::vector<Entry> edges;
    edges.reserve(surface.halfEdgeCount() / 2 - surface.vertexCount() + 1);
    for (std::uint32_t h = 0; h < surface.halfEdgeCount(); ++h)
        if (h < surface.opposite[h] && !isInTree(h))
            edges.push_back({mDistance[surface.start[h]] + mDistance[surface.end(h)] + surface.length[h], h});
    std::sort(edges.begin(), edges.end(), std::greater<>());

    std::vector<std::uint32_t> root(surface.faceCount);
    std::iota(root.begin(), root.end(), 0u);
    const auto rootOf = [&](std::uint32_t face) {
        while (root[face] != face)
            face = root[face] = root[root[face]];
        return face;
    };
    mIsInCotree.assign(surface.halfEdgeCount(), false);
    for (const auto &[length, h] : edges) {
        const std::uint32_t a = rootOf(surface.face[h]), b = rootOf(surface.face[surface.opposite[h]]);
        if (a == b) {
            mLeftover.push_back(h);
        } else {
            root[a] = b;
            mIsInCotree[h] = mIsInCotree[surface.opposite[h]] = true;
        }
    }
    std::sort(mLeftover.begin(), mLeftover.end());
}

EdgeLoop TreeCotree::loopOver(std::uint32_t halfEdge) const
{
    // Both ways towards the root, until they meet.
    const ClosedSurface &surface = mGraph.surface;
    std::uint32_t a = surface.start[halfEdge], b = surface.end(halfEdge);
    std::vector<std::uint32_t> fromA, fromB; // half-edges of the tree
    while (a != b) {
        const bool stepA = mDepth[a] >= mDepth[b];
        std::uint32_t &at = stepA ? a : b;
        (stepA ? fromA : fromB).push_back(mFrom[at]);
        at = surface.start[mFrom[at]];
    }
    EdgeLoop loop;
    loop.halfEdges.assign(fromA.rbegin(), fromA.rend());
    loop.halfEdges.push_back(halfEdge);
    for (const std::uint32_t h : fromB)
        loop.halfEdges.push_back(surface.opposite[h]);
    for (const std::uint32_t h : loop.halfEdges) {
        loop.vertices.push_back(surface.start[h]);
        loop.length += double(surface.length[h]);
    }
    return loop;
}

std::vector<EdgeLoop> TreeCotree::loops() const
{
    std::vector<EdgeLoop> result;
    for (const std::uint32_t h : mLeftover)
        result.push_back(loopOver(h));
    return result;
}

} // namespace model
