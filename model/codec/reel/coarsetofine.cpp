// SPDX-License-Identifier: GPL-3.0-or-later
// Based on:
// - D. Dobkin, D. Kirkpatrick: Determining the separation of preprocessed polyhedra, 1990 (independent sets)
// Differs: works on the graph of edges alone, so that any connectivity will do; a removed vertex hands its links to one
// neighbour, and links have lengths.
#include "model/codec/reel/coarsetofine.h"

#include <algorithm>
#include <numeric>

namespace model::codec {

namespace {

// A vertex with more neighbours stays until some of them are gone.
constexpr std::uint32_t MaxRing = 12;
// Links of one node that the search for the nearest looks at: a hub must not make it slow.
constexpr std::size_t MaxSearched = 32;
// Far more than the halving of any real mesh needs.
constexpr std::uint8_t MaxLevels = 200;
// To a node that no link leads to, of another part of the mesh.
constexpr std::uint32_t Apart = 6 * UnitLength;
constexpr std::uint32_t Unreached = ~std::uint32_t(0);
constexpr std::size_t CancelInterval = 1024;

struct Link
{
    std::uint32_t to;
    std::uint32_t length;
};

/// What was around a vertex when it was removed.
struct Around
{
    std::vector<Link> ring;
    std::vector<Link> nearest;
};

/// Lists in the order of removal, which the nodes turn round.
class LinkLists
{
public:
    void add(std::span<const Link> list)
    {
        mLinks.insert(mLinks.end(), list.begin(), list.end());
        mStarts.push_back(mLinks.size());
    }
    std::span<const Link> operator[](std::size_t i) const
    {
        return {mLinks.data() + mStarts[i], mLinks.data() + mStarts[i + 1]};
    }

private:
    std::vector<Link> mLinks;
    std::vector<std::size_t> mStarts{0};
};

/// The graph that is left while vertices are removed.
class ShrinkingGraph
{
public:
    explicit ShrinkingGraph(const NodeLists &adjacent)
        : mLinks(adjacent.size())
        , mDegrees(adjacent.size())
        , mAlive(adjacent.size(), true)
        , mDistances(adjacent.size(), Unreached)
    {
        for (std::size_t v = 0; v < adjacent.size(); ++v) {
            mDegrees[v] = std::uint32_t(adjacent[v].size());
            mLinks[v].reserve(adjacent[v].size());
            for (const std::uint32_t u : adjacent[v])
                mLinks[v].push_back({u, UnitLength});
        }
    }

    std::uint32_t degree(std::uint32_t v) const { return mDegrees[v]; }
    bool isAlive(std::uint32_t v) const { return mAlive[v]; }
    /// The links to what is left.
    const std::vector<Link> &links(std::uint32_t v)
    {
        std::vector<Link> &list = mLinks[v];
        if (list.size() != mDegrees[v])
            std::erase_if(list, [&](const Link &link) { return !mAlive[link.to]; });
        return list;
    }

    void lookAround(std::uint32_t v, Around &around)
    {
        around.ring = links(v);
        around.nearest.clear();
        mFrontier.clear();
        mTouched.assign(1, v);
        mDistances[v] = 0;
        reachFrom({v, 0});
        while (around.nearest.size() < MaxKnown && !mFrontier.empty()) {
            const auto next = std::min_element(mFrontier.begin(), mFrontier.end(), [](const Link &a, const Link &b) {
                return a.length != b.length ? a.length < b.length : a.to < b.to;
            });
            const Link reached = *next;
            *next = mFrontier.back();
            mFrontier.pop_back();
            if (reached.length > mDistances[reached.to])
                continue;
            around.nearest.push_back(reached);
            reachFrom(reached);
        }
        for (const std::uint32_t u : mTouched)
            mDistances[u] = Unreached;
    }

    /// Takes a vertex away; the neighbour with the fewest neighbours gets its links.
    void remove(std::uint32_t v)
    {
        const std::vector<Link> ring = links(v);
        mAlive[v] = false;
        mLinks[v] = {};
        for (const Link &link : ring)
            forget(link.to);
        if (ring.empty())
            return;
        const Link heir = *std::min_element(
            ring.begin(), ring.end(), [&](const Link &a, const Link &b) { return mDegrees[a.to] < mDegrees[b.to]; });
        for (const Link &link : ring)
            if (link.to != heir.to)
                connect(heir.to, link.to, heir.length + link.length);
    }

private:
    void reachFrom(const Link &from)
    {
        std::size_t searched = 0, gone = 0;
        for (const Link &link : mLinks[from.to]) {
            if (!mAlive[link.to]) {
                ++gone;
                continue;
            }
            const std::uint32_t distance = from.length + link.length;
            std::uint32_t &known = mDistances[link.to];
            if (distance < known) {
                if (known == Unreached)
                    mTouched.push_back(link.to);
                known = distance;
                mFrontier.push_back({link.to, distance});
            }
            if (++searched == MaxSearched)
                break;
        }
        if (gone > MaxSearched) // a hub whose first links all went: not to be passed over each time
            links(from.to);
    }

    // A hub's list is not searched for each neighbour that goes: what is gone is dropped once it is half of the list.
    void forget(std::uint32_t v)
    {
        --mDegrees[v];
        if (mLinks[v].size() > 2 * std::size_t(mDegrees[v]) + MaxRing)
            links(v);
    }

    void connect(std::uint32_t a, std::uint32_t b, std::uint32_t length)
    {
        const bool aIsShorter = mLinks[a].size() <= mLinks[b].size();
        const std::vector<Link> &list = mLinks[aIsShorter ? a : b];
        const std::uint32_t other = aIsShorter ? b : a;
        if (std::any_of(list.begin(), list.end(), [&](const Link &link) { return link.to == other; }))
            return;
        mLinks[a].push_back({b, length});
        mLinks[b].push_back({a, length});
        ++mDegrees[a];
        ++mDegrees[b];
    }

    std::vector<std::vector<Link>> mLinks; ///< some to vertices that are gone
    std::vector<std::uint32_t> mDegrees;   ///< of what is left
    std::vector<bool> mAlive;
    std::vector<std::uint32_t> mDistances;
    std::vector<std::uint32_t> mTouched;
    std::vector<Link> mFrontier;
};

NodeLists neighboursOf(const Connectivity &connectivity)
{
    const auto visitSides = [&](auto &&visit) {
        for (const Triangle &t : connectivity.triangles)
            for (std::size_t i = 0; i < 3; ++i)
                if (const std::uint32_t a = t[i], b = t[(i + 1) % 3]; a != b) {
                    visit(a, b);
                    visit(b, a);
                }
    };
    // Counted first, so that it takes no more memory than it must.
    std::vector<std::size_t> ends(std::size_t(connectivity.vertexCount) + 1);
    visitSides([&](std::uint32_t a, std::uint32_t) { ++ends[a + 1]; });
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<std::uint32_t> sides(ends.back());
    visitSides([&](std::uint32_t a, std::uint32_t b) { sides[ends[a]++] = b; });
    // Now ends[a] is where the list of a ends.
    std::size_t begin = 0, kept = 0;
    std::vector<std::uint32_t> counts(connectivity.vertexCount);
    for (std::uint32_t v = 0; v < connectivity.vertexCount; ++v) {
        const auto first = sides.begin() + std::ptrdiff_t(begin), last = sides.begin() + std::ptrdiff_t(ends[v]);
        begin = ends[v];
        std::sort(first, last);
        const auto unique = std::unique(first, last);
        counts[v] = std::uint32_t(unique - first);
        std::copy(first, unique, sides.begin() + std::ptrdiff_t(kept));
        kept += counts[v];
    }
    NodeLists result;
    result.reserve(counts.size(), kept);
    std::size_t at = 0;
    for (const std::uint32_t count : counts) {
        result.add(std::span(sides).subspan(at, count));
        at += count;
    }
    return result;
}

/// Vertices of `left` with at most MaxRing neighbours, no two of them neighbours; those with few neighbours first.
std::vector<std::uint32_t> independentSet(ShrinkingGraph &graph, const std::vector<std::uint32_t> &left,
                                          std::vector<bool> &blocked)
{
    std::array<std::vector<std::uint32_t>, MaxRing + 1> byDegree;
    for (const std::uint32_t v : left) {
        blocked[v] = false;
        if (graph.degree(v) <= MaxRing)
            byDegree[graph.degree(v)].push_back(v);
    }
    std::vector<std::uint32_t> chosen;
    for (const std::vector<std::uint32_t> &same : byDegree)
        for (const std::uint32_t v : same)
            if (!blocked[v]) {
                chosen.push_back(v);
                for (const Link &link : graph.links(v))
                    blocked[link.to] = true;
            }
    return chosen;
}

/// Splits links to vertices into lists of nodes and lengths.
void addLinks(std::span<const Link> links, const std::vector<std::uint32_t> &nodes, NodeLists &lists,
              NodeLists &lengths, std::vector<std::uint32_t> &scratch)
{
    scratch.clear();
    for (const Link &link : links)
        scratch.push_back(nodes[link.to]);
    lists.add(scratch);
    scratch.clear();
    for (const Link &link : links)
        scratch.push_back(link.length);
    lengths.add(scratch);
}

} // namespace

Result<CoarseToFine> coarseToFine(const Connectivity &connectivity, const Progress &progress)
{
    const NodeLists adjacent = neighboursOf(connectivity);
    ShrinkingGraph graph(adjacent);
    const std::size_t count = connectivity.vertexCount;
    std::vector<std::uint32_t> left(count);
    std::iota(left.begin(), left.end(), 0u);
    std::vector<bool> blocked(count);
    std::vector<std::uint32_t> removed; // with their rounds below
    std::vector<std::uint8_t> rounds;
    LinkLists rings, nearest;
    Around around;
    const auto keep = [&](std::uint32_t v, std::uint8_t round) {
        removed.push_back(v);
        rounds.push_back(round);
        rings.add(around.ring);
        nearest.add(around.nearest);
    };

    std::uint8_t round = 0;
    for (; left.size() > 1 && round < MaxLevels; ++round) {
        std::vector<std::uint32_t> chosen = independentSet(graph, left, blocked);
        if (chosen.size() == left.size())
            chosen.pop_back();
        if (chosen.empty())
            break;
        for (const std::uint32_t v : chosen) {
            if (removed.size() % CancelInterval == 0 && progress.isCancelled())
                return fail(ErrorCode::Cancelled);
            graph.lookAround(v, around);
            keep(v, round);
            graph.remove(v);
        }
        std::erase_if(left, [&](std::uint32_t v) { return !graph.isAlive(v); });
        progress.report(double(removed.size()) / double(count));
    }
    // What is left has too many neighbours, or none: one after another.
    for (const std::uint32_t v : left) {
        if (removed.size() % CancelInterval == 0 && progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        around.nearest = graph.links(v);
        if (around.nearest.size() > MaxKnown)
            around.nearest.resize(MaxKnown);
        around.ring = around.nearest;
        keep(v, round);
        graph.remove(v);
    }

    CoarseToFine result;
    result.finest = round;
    std::vector<std::uint32_t> nodes(count);
    for (std::size_t node = 0; node < count; ++node) {
        const std::size_t at = count - 1 - node;
        result.vertices.push_back(removed[at]);
        result.levels.push_back(std::uint8_t(round - rounds[at]));
        nodes[removed[at]] = std::uint32_t(node);
    }
    std::vector<std::uint32_t> scratch;
    for (std::size_t node = 0; node < count; ++node) {
        const std::size_t at = count - 1 - node;
        const Link before{node > 0 ? removed[at + 1] : 0, Apart};
        const bool isAlone = nearest[at].empty() && node > 0;
        addLinks(isAlone ? std::span(&before, 1) : nearest[at], nodes, result.known, result.lengths, scratch);
        addLinks(rings[at], nodes, result.ring, result.ringLengths, scratch);
        scratch.clear();
        for (const std::uint32_t u : adjacent[removed[at]])
            scratch.push_back(nodes[u]);
        result.adjacent.add(scratch);
    }
    return result;
}

CoarseToFine coarseToFineInTime(std::uint32_t frameCount)
{
    // Few, since the farther ones only add noise.
    constexpr std::size_t MaxKnownFrames = 5;
    CoarseToFine result;
    std::vector<std::uint32_t> nodes(frameCount);
    std::uint32_t stride = 1;
    while (stride < frameCount)
        stride *= 2;
    std::vector<std::uint32_t> levelStart; // nodes below are of coarser levels
    for (std::uint8_t level = 0; stride > 0; ++level, stride /= 2) {
        levelStart.push_back(std::uint32_t(result.size()));
        for (std::uint32_t frame = level == 0 ? 0 : stride; frame < frameCount;
             frame += level == 0 ? frameCount : 2 * stride) {
            nodes[frame] = std::uint32_t(result.size());
            result.vertices.push_back(frame);
            result.levels.push_back(level);
        }
        result.finest = level;
    }
    std::vector<Link> known;
    std::vector<std::uint32_t> scratch;
    for (std::size_t node = 0; node < result.size(); ++node) {
        const std::int64_t frame = result.vertices[node];
        // All known frames are multiples of twice this: go outwards, the earlier of two first.
        std::int64_t step = 1;
        while (frame % (2 * step) == 0 && frame > 0)
            step *= 2;
        known.clear();
        for (std::int64_t away = step; frame > 0 && known.size() < MaxKnownFrames; away += 2 * step) {
            if (frame - away < 0 && frame + away >= std::int64_t(frameCount))
                break;
            for (const std::int64_t other : {frame - away, frame + away})
                if (other >= 0 && other < std::int64_t(frameCount) && known.size() < MaxKnownFrames)
                    known.push_back({std::uint32_t(other), std::uint32_t(away) * UnitLength});
        }
        addLinks(known, nodes, result.known, result.lengths, scratch);
        addLinks({}, nodes, result.ring, result.ringLengths, scratch);
        scratch.clear();
        if (frame > 0)
            scratch.push_back(nodes[std::size_t(frame - 1)]);
        if (frame + 1 < std::int64_t(frameCount))
            scratch.push_back(nodes[std::size_t(frame + 1)]);
        result.adjacent.add(scratch);
    }
    return result;
}

} // namespace model::codec
