// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/ids.h"

#include <cstdint>
#include <vector>

namespace model::io {

/// How the triangle beyond an edge of the front is found. FORMAT.md, 5.2.
enum class TileOp : std::uint8_t {
    New,    ///< its apex is the next vertex of the tile
    Left,   ///< it ends the edge before this one: that edge's start is its apex
    Right,  ///< it ends the edge after this one
    Close,  ///< it ends both
    Border, ///< there is none in this tile
    Outer,  ///< its apex is the next vertex of another tile
    Vertex, ///< its apex is a vertex that was met before; which one is in the stream of references
    Join,   ///< it was found over another edge of the front, which is in the stream of references
    Last = Join,
};

/// The edges between the triangles of a tile that are known and those that are not, as loops: the same steps in the
/// encoder and the decoder. `Tag` is what each keeps for an edge.
template <class Tag>
class TileFront
{
public:
    static constexpr std::uint32_t None = ~std::uint32_t(0);

    enum class State : std::uint8_t { Open, Border, Done };
    struct Edge
    {
        Tag tag; ///< of the known triangle's corner off the edge
        std::uint32_t before, after;
        State state;
    };

    std::uint32_t size() const { return std::uint32_t(mEdges.size()); }
    const Edge &operator[](std::uint32_t e) const { return mEdges[e]; }
    bool isOpen(std::uint32_t e) const { return mEdges[e].state == State::Open; }

    /// The next edge to find a triangle for, oldest first; None: there is none.
    std::uint32_t take()
    {
        while (mTaken < mEdges.size() && !isOpen(mTaken))
            ++mTaken;
        return mTaken < mEdges.size() ? mTaken++ : None;
    }

    /// A triangle of its own: its three edges, by their tags, in the order of the loop; `starts` are where they begin.
    void start(const Tag tags[3], const std::uint32_t starts[3])
    {
        const std::uint32_t e = size();
        for (std::uint32_t i = 0; i < 3; ++i)
            add(tags[i], starts[i]);
        for (std::uint32_t i = 0; i < 3; ++i)
            connect(e + i, e + (i + 1) % 3);
    }

    /// Over the edge `e` from a to b lies a triangle with apex x: `first` is its edge from a to x, `second` that from
    /// x to b. A vertex met before may be on the front already: then the loop goes on there.
    void open(std::uint32_t e, const Tag &first, std::uint32_t a, const Tag &second, std::uint32_t x)
    {
        const std::uint32_t before = mEdges[e].before, after = mEdges[e].after;
        const std::uint32_t other = x < mStarting.size() ? mStarting[x] : None;
        mEdges[e].state = State::Done;
        const std::uint32_t f = add(first, a), s = add(second, x);
        connect(before, f);
        connect(s, after);
        // After the links to the neighbours: one of those may be the edge at x.
        if (other != None && other != e && mEdges[other].state != State::Done) {
            const std::uint32_t beforeOther = mEdges[other].before;
            connect(f, other);
            connect(beforeOther, s);
        } else {
            connect(f, s);
        }
    }
    void endLeft(std::uint32_t e, const Tag &second, std::uint32_t x)
    {
        const std::uint32_t left = mEdges[e].before, before = mEdges[left].before, after = mEdges[e].after;
        mEdges[e].state = mEdges[left].state = State::Done;
        const std::uint32_t s = add(second, x);
        connect(before == e ? s : before, s);
        connect(s, after == left ? s : after);
    }
    void endRight(std::uint32_t e, const Tag &first, std::uint32_t a)
    {
        const std::uint32_t right = mEdges[e].after, before = mEdges[e].before, after = mEdges[right].after;
        mEdges[e].state = mEdges[right].state = State::Done;
        const std::uint32_t f = add(first, a);
        connect(before == right ? f : before, f);
        connect(f, after == e ? f : after);
    }
    void close(std::uint32_t e)
    {
        const std::uint32_t left = mEdges[e].before, right = mEdges[e].after;
        mEdges[e].state = mEdges[left].state = mEdges[right].state = State::Done;
        connect(mEdges[left].before, mEdges[right].after);
    }
    void end(std::uint32_t e) { mEdges[e].state = State::Border; }
    void join(std::uint32_t e, std::uint32_t f)
    {
        const std::uint32_t beforeE = mEdges[e].before, afterE = mEdges[e].after;
        const std::uint32_t beforeF = mEdges[f].before, afterF = mEdges[f].after;
        mEdges[e].state = mEdges[f].state = State::Done;
        connect(beforeE, afterF);
        connect(beforeF, afterE);
    }

private:
    std::uint32_t add(const Tag &tag, std::uint32_t start)
    {
        const std::uint32_t e = size();
        mEdges.push_back({tag, e, e, State::Open});
        if (start >= mStarting.size())
            mStarting.resize(start + std::size_t(64), None);
        mStarting[start] = e;
        return e;
    }
    void connect(std::uint32_t before, std::uint32_t after)
    {
        mEdges[before].after = after;
        mEdges[after].before = before;
    }

    std::vector<Edge> mEdges;
    std::vector<std::uint32_t> mStarting; ///< of each local vertex, the edge that began there last
    std::uint32_t mTaken = 0;
};

} // namespace model::io
