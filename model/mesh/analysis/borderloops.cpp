// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/analysis/borderloops.h"

#include <algorithm>
#include <map>

namespace model {

namespace {

/// A border side and the end at which the loop goes on.
struct Ahead
{
    std::uint32_t side;
    bool atEnd; ///< of the side; else at its start
};

class LoopFinder
{
public:
    explicit LoopFinder(const FaceLinks &links)
        : mLinks(links)
        , mFaces(links.faces())
    {}

    std::vector<BorderLoop> find()
    {
        std::vector<bool> seen(mFaces.cornerCount());
        std::vector<BorderLoop> loops;
        for (std::uint32_t start = 0; start < mFaces.cornerCount(); ++start) {
            if (!mLinks.isBorder(start) || seen[start])
                continue;
            std::vector<Ahead> chain;
            bool isClosed = false;
            for (Ahead at{start, true};;) {
                seen[at.side] = true;
                chain.push_back(at);
                if (!advance(at))
                    break;
                if (at.side == start) {
                    isClosed = true;
                    break;
                }
            }
            if (!isClosed) { // what lies before it
                std::reverse(chain.begin(), chain.end());
                for (Ahead &at : chain)
                    at.atEnd = !at.atEnd;
                for (Ahead at{start, false}; advance(at);) {
                    seen[at.side] = true;
                    chain.push_back(at);
                }
            }
            loops.push_back(loopOf(chain, isClosed));
        }
        joinChains(loops);
        return loops;
    }

private:
    std::uint32_t target(Ahead at) const { return at.atEnd ? mFaces.sideEnd(at.side) : mFaces.vertex(at.side); }
    std::uint32_t source(Ahead at) const { return at.atEnd ? mFaces.vertex(at.side) : mFaces.sideEnd(at.side); }

    /// \returns false at a crowded edge
    bool advance(Ahead &at) const
    {
        const std::uint32_t vertex = target(at);
        FaceLinks::Step step{at.side, mFaces.previous(at.side)};
        if (at.atEnd) {
            const std::uint32_t corner = mFaces.next(at.side);
            step = {corner, corner};
        }
        while (mLinks.isLinked(step.side))
            step = mLinks.aroundVertex(step);
        if (!mLinks.isBorder(step.side))
            return false;
        at = {step.side, mFaces.vertex(step.side) == vertex};
        return true;
    }

    BorderLoop loopOf(const std::vector<Ahead> &chain, bool isClosed) const
    {
        BorderLoop loop;
        loop.isClosed = isClosed;
        for (const Ahead &at : chain) {
            loop.sides.push_back(at.side);
            loop.vertices.push_back(source(at));
        }
        if (!isClosed)
            loop.vertices.push_back(target(chain.back()));
        return loop;
    }

    /// Open chains that end at the same vertices are one.
    static void joinChains(std::vector<BorderLoop> &loops)
    {
        std::map<std::uint32_t, std::size_t> loopAt; // by vertex where one of its chains ends
        std::vector<std::size_t> into(loops.size());
        const auto final = [&](std::size_t i) {
            while (into[i] != i)
                i = into[i];
            return i;
        };
        for (std::size_t i = 0; i < loops.size(); ++i) {
            into[i] = i;
            if (loops[i].isClosed)
                continue;
            for (const std::uint32_t end : {loops[i].vertices.front(), loops[i].vertices.back()}) {
                const std::size_t a = final(loopAt.emplace(end, i).first->second), b = final(i);
                into[std::max(a, b)] = std::min(a, b);
            }
        }
        for (std::size_t i = 0; i < loops.size(); ++i) {
            const std::size_t to = final(i);
            if (to == i)
                continue;
            loops[to].sides.insert(loops[to].sides.end(), loops[i].sides.begin(), loops[i].sides.end());
            loops[to].vertices.insert(loops[to].vertices.end(), loops[i].vertices.begin(), loops[i].vertices.end());
            loops[i].sides.clear();
        }
        std::erase_if(loops, [](const BorderLoop &loop) { return loop.sides.empty(); });
    }

    const FaceLinks &mLinks;
    const Faces &mFaces;
};

} // namespace

std::vector<BorderLoop> findBorderLoops(const FaceLinks &links)
{
    return LoopFinder(links).find();
}

} // namespace model
