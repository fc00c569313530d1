// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/direct/meshwalk.h"

#include <algorithm>
#include <numeric>

namespace model::codec {

namespace {

/// A triangle's edge and the corner opposite to it.
struct Edge
{
    std::uint32_t low, high, apex;

    bool isSameEdge(const Edge &other) const { return low == other.low && high == other.high; }
    friend auto operator<=>(const Edge &, const Edge &) = default;
};

/// All edges of all triangles, sorted; those that lead from a vertex to itself are left out.
std::vector<Edge> sortedEdges(const Connectivity &connectivity)
{
    std::vector<Edge> edges;
    edges.reserve(3 * connectivity.triangles.size());
    for (const Triangle &t : connectivity.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            if (a != b)
                edges.push_back({std::min(a, b), std::max(a, b), t[(i + 2) % 3]});
        }
    std::sort(edges.begin(), edges.end());
    return edges;
}

template <class Visit>
void visitUniqueEdges(std::span<const Edge> edges, Visit &&visit)
{
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (i == 0 || !edges[i].isSameEdge(edges[i - 1]))
            visit(edges[i]);
}

/// Lists of numbers, one for each vertex, in one array.
struct Lists
{
    std::vector<std::uint32_t> first; ///< #V + 1
    std::vector<std::uint32_t> items;

    std::span<const std::uint32_t> of(std::size_t v) const
    {
        return {items.data() + first[v], first[v + 1] - first[v]};
    }
};

Lists neighbourLists(std::span<const Edge> edges, std::size_t vertices)
{
    Lists lists{std::vector<std::uint32_t>(vertices + 1), {}};
    visitUniqueEdges(edges, [&](const Edge &e) {
        ++lists.first[e.low + 1];
        ++lists.first[e.high + 1];
    });
    std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
    lists.items.resize(lists.first.back());
    std::vector<std::uint32_t> next(lists.first.begin(), lists.first.end() - 1);
    visitUniqueEdges(edges, [&](const Edge &e) {
        lists.items[next[e.low]++] = e.high;
        lists.items[next[e.high]++] = e.low;
    });
    return lists;
}

/// Next is the vertex that most lately came to the most known neighbours; without any, the lowest number.
std::vector<std::uint32_t> growingOrder(const Lists &neighbours, std::size_t vertices)
{
    // More than 8 known neighbours are as good as 8, and keep the piles few.
    constexpr std::uint32_t MostCounted = 8;
    std::vector<std::uint32_t> order;
    order.reserve(vertices);
    std::vector<std::uint8_t> knownCount(vertices, 0);
    std::vector<bool> isDone(vertices, false);
    std::array<std::vector<std::uint32_t>, MostCounted + 1> piles;
    for (std::uint32_t start = 0; start < vertices; ++start) {
        if (isDone[start])
            continue;
        piles[0].push_back(start);
        for (std::size_t top = 0;;) {
            if (piles[top].empty()) {
                if (top == 0)
                    break;
                --top;
                continue;
            }
            const std::uint32_t vertex = piles[top].back();
            piles[top].pop_back();
            if (isDone[vertex] || knownCount[vertex] != top)
                continue; // done, or on a higher pile since
            isDone[vertex] = true;
            order.push_back(vertex);
            for (const std::uint32_t other : neighbours.of(vertex)) {
                if (isDone[other] || knownCount[other] == MostCounted)
                    continue;
                const std::size_t count = ++knownCount[other];
                piles[count].push_back(other);
                top = std::max(top, count);
            }
        }
    }
    return order;
}

} // namespace

MeshWalk::MeshWalk(const Connectivity &connectivity, Order order)
{
    const std::size_t vertices = connectivity.vertexCount;
    const std::vector<Edge> edges = sortedEdges(connectivity);
    const Lists neighbours = neighbourLists(edges, vertices);
    if (order == Order::Growing) {
        mOrder = growingOrder(neighbours, vertices);
    } else {
        mOrder.resize(vertices);
        std::iota(mOrder.begin(), mOrder.end(), 0u);
    }
    std::vector<std::uint32_t> place(vertices);
    for (std::uint32_t i = 0; i < vertices; ++i)
        place[mOrder[i]] = i;

    mFirstKnown.reserve(vertices + 1);
    mFirstKnown.push_back(0);
    mKnown.reserve(neighbours.items.size() / 2);
    for (std::uint32_t i = 0; i < vertices; ++i) {
        for (const std::uint32_t other : neighbours.of(mOrder[i]))
            if (place[other] < i)
                mKnown.push_back(other);
        if (mKnown.size() == mFirstKnown.back() && i > 0)
            mKnown.push_back(mOrder[i - 1]);
        mFirstKnown.push_back(std::uint32_t(mKnown.size()));
    }

    // Two triangles that follow one another in the sorted list and share an edge make a parallelogram, if its last
    // corner is the apex of one of them. (Pairing all triangles of a crowded edge could take quadratic time.)
    const auto complete = [&](std::size_t i) {
        const Edge &e = edges[i], &f = edges[i + 1];
        const bool isFirstLater = place[e.apex] > place[f.apex];
        const std::uint32_t last = isFirstLater ? e.apex : f.apex;
        const bool isKnown =
            e.isSameEdge(f) && e.apex != f.apex && place[e.low] < place[last] && place[e.high] < place[last];
        return std::pair(isKnown, std::pair(last, Parallelogram{e.low, e.high, isFirstLater ? f.apex : e.apex}));
    };
    mFirstParallelogram.assign(vertices + 1, 0);
    for (std::size_t i = 0; i + 1 < edges.size(); ++i)
        if (const auto [isKnown, found] = complete(i); isKnown)
            ++mFirstParallelogram[place[found.first] + 1];
    std::partial_sum(mFirstParallelogram.begin(), mFirstParallelogram.end(), mFirstParallelogram.begin());
    mParallelograms.resize(mFirstParallelogram.back());
    std::vector<std::uint32_t> next(mFirstParallelogram.begin(), mFirstParallelogram.end() - 1);
    for (std::size_t i = 0; i + 1 < edges.size(); ++i)
        if (const auto [isKnown, found] = complete(i); isKnown)
            mParallelograms[next[place[found.first]]++] = found.second;
}

std::size_t MeshWalk::memoryBytes() const
{
    return sizeof(std::uint32_t) *
               (mOrder.capacity() + mFirstKnown.capacity() + mKnown.capacity() + mFirstParallelogram.capacity()) +
           sizeof(Parallelogram) * mParallelograms.capacity();
}

} // namespace model::codec
