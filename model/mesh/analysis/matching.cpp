// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: J. Edmonds: Paths, Trees, and Flowers, 1965; H. Gabow: An Efficient Implementation of Edmonds' Algorithm
// for Maximum Matching on Graphs, 1976 (blossoms are shrunk by naming their base)
#include "model/mesh/analysis/matching.h"

#include <deque>
#include <numeric>

namespace model {

namespace {

class Matching
{
public:
    explicit Matching(const std::vector<std::vector<std::uint32_t>> &neighbours)
        : mNeighbours(neighbours)
        , mPartner(neighbours.size(), NoPartner)
    {}

    std::vector<std::uint32_t> run()
    {
        for (std::uint32_t v = 0; v < mPartner.size(); ++v)
            for (const std::uint32_t to : mNeighbours[v])
                if (mPartner[v] == NoPartner && mPartner[to] == NoPartner && to != v) {
                    mPartner[v] = to;
                    mPartner[to] = v;
                }
        for (std::uint32_t v = 0; v < mPartner.size(); ++v)
            if (mPartner[v] == NoPartner)
                augment(findPath(v));
        return mPartner;
    }

private:
    static constexpr std::uint32_t None = NoPartner;

    /// Exchanges the pairs along an alternating path.
    void augment(std::uint32_t end)
    {
        while (end != None) {
            const std::uint32_t previous = mParent[end], next = mPartner[previous];
            mPartner[end] = previous;
            mPartner[previous] = end;
            end = next;
        }
    }

    std::uint32_t commonBase(std::uint32_t a, std::uint32_t b) const
    {
        std::vector<bool> isOnWay(mPartner.size());
        for (;;) {
            a = mBase[a];
            isOnWay[a] = true;
            if (mPartner[a] == None)
                break;
            a = mParent[mPartner[a]];
        }
        for (;;) {
            b = mBase[b];
            if (isOnWay[b])
                return b;
            b = mParent[mPartner[b]];
        }
    }

    void markPath(std::uint32_t v, std::uint32_t base, std::uint32_t child, std::vector<bool> &isInBlossom)
    {
        while (mBase[v] != base) {
            isInBlossom[mBase[v]] = isInBlossom[mBase[mPartner[v]]] = true;
            mParent[v] = child;
            child = mPartner[v];
            v = mParent[mPartner[v]];
        }
    }

    /// \returns the end of an alternating path from `root` to a free node, None if there is none
    std::uint32_t findPath(std::uint32_t root)
    {
        const std::size_t count = mPartner.size();
        mParent.assign(count, None);
        mBase.resize(count);
        std::iota(mBase.begin(), mBase.end(), 0u);
        std::vector<bool> isReached(count);
        std::deque<std::uint32_t> queue{root};
        isReached[root] = true;
        while (!queue.empty()) {
            const std::uint32_t v = queue.front();
            queue.pop_front();
            for (const std::uint32_t to : mNeighbours[v]) {
                if (mBase[v] == mBase[to] || mPartner[v] == to)
                    continue;
                if (to == root || (mPartner[to] != None && mParent[mPartner[to]] != None)) {
                    const std::uint32_t base = commonBase(v, to);
                    std::vector<bool> isInBlossom(count);
                    markPath(v, base, to, isInBlossom);
                    markPath(to, base, v, isInBlossom);
                    for (std::uint32_t i = 0; i < count; ++i)
                        if (isInBlossom[mBase[i]]) {
                            mBase[i] = base;
                            if (!isReached[i]) {
                                isReached[i] = true;
                                queue.push_back(i);
                            }
                        }
                } else if (mParent[to] == None) {
                    mParent[to] = v;
                    if (mPartner[to] == None)
                        return to;
                    isReached[mPartner[to]] = true;
                    queue.push_back(mPartner[to]);
                }
            }
        }
        return None;
    }

    const std::vector<std::vector<std::uint32_t>> &mNeighbours;
    std::vector<std::uint32_t> mPartner, mParent, mBase;
};

} // namespace

std::vector<std::uint32_t> maximumMatching(const std::vector<std::vector<std::uint32_t>> &neighbours)
{
    return Matching(neighbours).run();
}

} // namespace model
