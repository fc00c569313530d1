// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/codec/plain/plainnodes.h"

#include <algorithm>
#include <map>
#include <set>

namespace tests::plain {

namespace {

struct Link
{
    std::size_t to;
    std::uint64_t length;
};

struct Removed
{
    std::size_t vertex, round;
    std::vector<Link> ring, known;
};

/// The graph that is left.
struct Graph
{
    std::vector<std::vector<Link>> links;

    std::vector<Link> nearest(std::size_t v) const
    {
        std::map<std::size_t, std::uint64_t> distance{{v, 0}};
        std::set<std::pair<std::uint64_t, std::size_t>> front{{0, v}};
        std::vector<Link> result;
        while (!front.empty() && result.size() < 12) {
            const auto [length, u] = *front.begin();
            front.erase(front.begin());
            if (u != v)
                result.push_back({u, length});
            for (std::size_t i = 0; i < links[u].size() && i < 32; ++i) {
                const Link &link = links[u][i];
                const std::uint64_t now = length + link.length;
                const auto known = distance.find(link.to);
                if (known != distance.end() && known->second <= now)
                    continue;
                if (known != distance.end())
                    front.erase({known->second, link.to});
                distance[link.to] = now;
                front.insert({now, link.to});
            }
        }
        return result;
    }

    void remove(std::size_t v)
    {
        const std::vector<Link> ring = links[v];
        links[v].clear();
        for (const Link &link : ring)
            std::erase_if(links[link.to], [&](const Link &back) { return back.to == v; });
        if (ring.empty())
            return;
        Link heir = ring.front();
        for (const Link &link : ring)
            if (links[link.to].size() < links[heir.to].size())
                heir = link;
        for (const Link &link : ring) {
            const auto isLinked = [&](const Link &other) { return other.to == link.to; };
            if (link.to == heir.to || std::any_of(links[heir.to].begin(), links[heir.to].end(), isLinked))
                continue;
            links[heir.to].push_back({link.to, heir.length + link.length});
            links[link.to].push_back({heir.to, heir.length + link.length});
        }
    }
};

} // namespace

std::vector<Node> vertexNodes(const std::vector<std::array<std::int64_t, 3>> &triangles, std::size_t vertices)
{
    std::vector<std::set<std::size_t>> neighbours(vertices);
    for (const auto &t : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t a = std::size_t(t[i]), b = std::size_t(t[(i + 1) % 3]);
            if (a != b) {
                neighbours[a].insert(b);
                neighbours[b].insert(a);
            }
        }
    Graph graph;
    for (const auto &list : neighbours) {
        graph.links.emplace_back();
        for (const std::size_t u : list)
            graph.links.back().push_back({u, 16});
    }
    std::vector<std::size_t> left;
    for (std::size_t v = 0; v < vertices; ++v)
        left.push_back(v);
    std::vector<Removed> removed;
    std::size_t round = 0;
    for (; left.size() > 1 && round < 200; ++round) {
        std::vector<bool> isBlocked(vertices, false);
        std::vector<std::size_t> chosen;
        for (std::size_t d = 0; d <= 12; ++d)
            for (const std::size_t v : left)
                if (graph.links[v].size() == d && !isBlocked[v]) {
                    chosen.push_back(v);
                    for (const Link &link : graph.links[v])
                        isBlocked[link.to] = true;
                }
        if (chosen.size() == left.size())
            chosen.pop_back();
        if (chosen.empty())
            break;
        for (const std::size_t v : chosen) {
            removed.push_back({v, round, graph.links[v], graph.nearest(v)});
            graph.remove(v);
            std::erase(left, v);
        }
    }
    for (const std::size_t v : left) {
        std::vector<Link> first = graph.links[v];
        first.resize(std::min<std::size_t>(first.size(), 12));
        removed.push_back({v, round, first, first});
        graph.remove(v);
    }

    std::vector<Node> nodes(vertices);
    std::vector<std::size_t> nodeOf(vertices);
    for (std::size_t i = 0; i < vertices; ++i)
        nodeOf[removed[vertices - 1 - i].vertex] = i;
    for (std::size_t i = 0; i < vertices; ++i) {
        const Removed &from = removed[vertices - 1 - i];
        Node &node = nodes[i];
        node.vertex = from.vertex;
        node.level = unsigned(round - from.round);
        for (const Link &link : from.known)
            node.known.push_back(nodeOf[link.to]);
        if (node.known.empty() && i > 0)
            node.known.push_back(i - 1);
        for (const Link &link : from.ring) {
            node.ring.push_back(nodeOf[link.to]);
            node.ringLengths.push_back(link.length);
        }
        for (const std::size_t u : neighbours[from.vertex])
            node.adjacent.push_back(nodeOf[u]);
    }
    return nodes;
}

std::vector<Node> frameNodes(std::size_t frames)
{
    std::size_t power = 1;
    while (power < frames)
        power *= 2;
    std::vector<Node> nodes(1);
    std::vector<std::size_t> nodeOf(frames);
    for (unsigned level = 1; power >> level > 0; ++level)
        for (std::size_t frame = power >> level; frame < frames; frame += 2 * (power >> level)) {
            nodeOf[frame] = nodes.size();
            Node node;
            node.vertex = frame;
            node.level = level;
            nodes.push_back(node);
        }
    for (Node &node : nodes) {
        std::vector<std::pair<std::size_t, std::size_t>> others; // distance, frame
        for (const Node &other : nodes)
            if (other.level < node.level)
                others.push_back({other.vertex < node.vertex ? node.vertex - other.vertex : other.vertex - node.vertex,
                                  other.vertex});
        std::sort(others.begin(), others.end());
        for (std::size_t i = 0; i < others.size() && i < 5; ++i)
            node.known.push_back(nodeOf[others[i].second]);
        if (node.vertex > 0)
            node.adjacent.push_back(nodeOf[node.vertex - 1]);
        if (node.vertex + 1 < frames)
            node.adjacent.push_back(nodeOf[node.vertex + 1]);
    }
    return nodes;
}

} // namespace tests::plain
