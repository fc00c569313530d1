// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/codec/connectivity/connectivitystage.h"
#include "model/codec/connectivity/placemodel.h"
#include "model/codec/connectivity/queuedcoder.h"
#include "model/codec/connectivity/turnmodel.h"

#include <optional>
#include <type_traits>

namespace model::codec {

inline constexpr std::uint32_t NoEdge = ~std::uint32_t(0);

/// One directed edge of a loop between the triangles that are known, on its right, and those that are not.
struct LoopEdge
{
    std::uint32_t previous = NoEdge, next = NoEdge;
    std::uint32_t vertex = NoVertex; ///< where it starts; NoVertex once it is closed
    Corner corner = NoCorner;        ///< opposite to it in its known triangle; none at a hole
};

/// The walk of EdgeBreaker over a manifold with border. Encoder and decoder run the same code and build the same mesh;
/// `Source` answers, on the encoder's side, what comes next. FORMAT.md 12.
template <class Coder, class Source>
class EdgeBreaker
{
public:
    /// \param vertexCount  about: room for so many is made at once; a mesh that was cut has more
    /// \param memoryLimit  bytes for those that are more, for open edges and for what waits
    EdgeBreaker(Coder &coder, Source &source, std::uint32_t triangleCount, std::uint32_t vertexCount,
                std::uint64_t memoryLimit)
        : mCoder(coder)
        , mSource(source)
        , mTriangleCount(triangleCount)
        , mVertexRoom(vertexCount)
        , mMemoryLimit(memoryLimit)
        , mStepsLeft(FirstSteps + StepsPerTriangle * std::int64_t(triangleCount))
    {
        mVertices.resize(3 * std::size_t(mTriangleCount));
        mOpposites.resize(3 * std::size_t(mTriangleCount), NoCorner);
        mNeighbours.reserve(vertexCount);
        mDegrees.reserve(vertexCount);
    }

    /// \returns false if the stream is corrupt or the work was cancelled
    bool run(const Progress &progress)
    {
        mHolesLeft = std::uint64_t(mHoleCountModel.codeCount(mCoder, mSource.holeCount()));
        if (mHolesLeft > mTriangleCount * std::uint64_t(3) / 2) // each has two edges at least
            return false;
        mHasFlips = mCoder.direct(1, mSource.hasFlips());
        if (mHasFlips)
            mFlipped.reserve(mTriangleCount);
        while (doneCount() < mTriangleCount) {
            if (!component(progress))
                return false;
        }
        return mHolesLeft == 0;
    }

    /// What was built.
    std::vector<std::uint32_t> mVertices;
    std::vector<Corner> mOpposites;
    std::vector<bool> mFlipped;
    std::vector<VertexNeighbours> mNeighbours;
    bool memoryLimitReached() const { return mMemoryLimitReached; }

private:
    static constexpr std::uint32_t CancelInterval = 4096; // triangles
    /// What a hole counts for at its vertices: a vertex inside has six triangles, one on a straight border three.
    static constexpr std::uint8_t HoleDegree = 3;
    /// How far along a loop a known vertex is looked for before it is named by its number, and how many such steps are
    /// taken altogether: bounds the work that a short file can ask for.
    static constexpr std::int64_t MaxSteps = 1000;
    static constexpr std::int64_t FirstSteps = 65536;
    static constexpr std::int64_t StepsPerTriangle = 16;

    std::uint32_t doneCount() const { return mDone; }

    std::uint32_t newVertex(const VertexNeighbours &neighbours)
    {
        mNeighbours.push_back(neighbours);
        mDegrees.push_back(0);
        return std::uint32_t(mNeighbours.size() - 1);
    }

    std::uint32_t newEdge(std::uint32_t vertex, Corner corner)
    {
        std::uint32_t edge = mFreeEdge;
        if (edge == NoEdge) {
            edge = std::uint32_t(mEdges.size());
            mEdges.push_back({});
        } else {
            mFreeEdge = mEdges[edge].next;
        }
        mEdges[edge].vertex = vertex;
        mEdges[edge].corner = corner;
        ++mOpenCount;
        return edge;
    }

    void closeEdge(std::uint32_t edge)
    {
        mSource.closed(edge);
        mEdges[edge].vertex = NoVertex;
        mEdges[edge].next = mFreeEdge;
        mFreeEdge = edge;
        --mOpenCount;
    }

    void join(std::uint32_t before, std::uint32_t after)
    {
        mEdges[before].next = after;
        mEdges[after].previous = before;
    }

    bool isInLoop(std::uint32_t start, std::uint32_t wanted) const
    {
        std::uint32_t at = start;
        while (at != wanted && mEdges[at].next != start)
            at = mEdges[at].next;
        return at == wanted;
    }

    std::uint32_t end(std::uint32_t edge) const { return mEdges[mEdges[edge].next].vertex; }

    void glue(Corner a, Corner b)
    {
        mOpposites[a] = b;
        if (b != NoCorner)
            mOpposites[b] = a;
    }

    void count(std::uint32_t vertex, unsigned triangles = 1)
    {
        mDegrees[vertex] = std::uint8_t(std::min(mDegrees[vertex] + triangles, 255u));
    }

    /// \param behind, atRight, atLeft  the corners that lie opposite to its own across its edges, in their order
    Corner newTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, Corner behind, Corner atRight = NoCorner,
                       Corner atLeft = NoCorner)
    {
        const Corner corner = 3 * mDone++;
        mVertices[corner] = a;
        mVertices[corner + 1] = b;
        mVertices[corner + 2] = c;
        glue(corner, behind);
        glue(corner + 1, atRight);
        glue(corner + 2, atLeft);
        count(a);
        count(b);
        count(c);
        if (mHasFlips)
            mFlipped.push_back(
                mTurns.code(mCoder, {turnOf(behind), turnOf(atRight), turnOf(atLeft)}, mSource.isFlipped()));
        return corner;
    }

    unsigned turnOf(Corner corner) const { return corner == NoCorner ? TurnModel::Unknown : mFlipped[corner / 3]; }

    /// The loop of a hole, its new vertices included. \returns its first edge, NoEdge if it is corrupt
    /// \param from  the vertex that it starts at, known already; or NoVertex
    std::uint32_t newHole(std::uint32_t from, std::uint32_t before)
    {
        const std::int64_t length = mHoleLengthModel.codeCount(mCoder, mSource.holeLength());
        if (mSource.isObserved())
            mSource.observeHole(std::uint32_t(length), from != NoVertex);
        if (mHolesLeft == 0 || length < 2 || !mayOpen(std::uint64_t(length)))
            return NoEdge;
        --mHolesLeft;
        std::uint32_t first = NoEdge, last = NoEdge;
        // The vertices before the new one on the line along the border that predicts it.
        std::uint32_t v1 = before, v2 = from;
        for (std::int64_t i = 0; i < length; ++i) {
            std::uint32_t vertex = from;
            if (i > 0 || from == NoVertex) {
                vertex = newVertex(v2 == NoVertex   ? VertexNeighbours{}
                                   : v1 == NoVertex ? VertexNeighbours{v2, v2, v2}
                                                    : VertexNeighbours{v2, v2, v1});
                mSource.visitBorder();
                v1 = v2;
                v2 = vertex;
            }
            count(vertex, HoleDegree);
            const std::uint32_t edge = newEdge(vertex, NoCorner);
            mSource.holeEdge(edge);
            if (i == 0)
                first = edge;
            else
                join(last, edge);
            last = edge;
        }
        join(last, first);
        return first;
    }

    /// That a new vertex lies on a hole, of 65536: holes left by vertices left, which are half as many as triangles.
    std::uint32_t touchProbability() const
    {
        const std::uint64_t left = std::uint64_t(mTriangleCount - doneCount()) + 1;
        return std::uint32_t(std::clamp<std::uint64_t>((mHolesLeft << 17) / left, 24, 1u << 15));
    }

    bool mayOpen(std::uint64_t more)
    {
        const std::uint64_t open = mOpenCount + more;
        // Each open edge needs a side of a triangle that is still to come.
        if (open > 3 * std::uint64_t(mTriangleCount - doneCount()))
            return false;
        // A vector that grows holds up to three times its values. Each new edge may have a new vertex.
        constexpr std::uint64_t Growing = 3, VertexBytes = sizeof(VertexNeighbours) + sizeof(std::uint8_t);
        const std::uint64_t vertices = mNeighbours.size() + more;
        const std::uint64_t bytes =
            Growing * ((mEdges.size() + more) * sizeof(LoopEdge) + (mStack.size() + 1) * sizeof(Waiting) +
                       (vertices > mVertexRoom ? vertices * VertexBytes : 0));
        mMemoryLimitReached = bytes > mMemoryLimit;
        return !mMemoryLimitReached;
    }

    bool component(const Progress &progress)
    {
        if (!mayOpen(3))
            return false;
        mSource.startComponent();
        const bool atHole = mHolesLeft > 0 && codeCounted(mCoder, mStartModel, mSource.startsAtHole());
        std::uint32_t gate = atHole ? newHole(NoVertex, NoVertex) : firstTriangle();
        if (gate == NoEdge)
            return false;
        mStack.clear();
        while (gate != NoEdge) {
            if (doneCount() % CancelInterval == 0) {
                if (progress.isCancelled() || mCoder.isBad())
                    return false;
                progress.report(double(doneCount()) / mTriangleCount);
            }
            if (!mayOpen(0))
                return false;
            if (!step(gate))
                return false;
            while (gate == NoEdge && !mStack.empty()) {
                // Closed in the meantime where a handle joined two loops.
                const LoopEdge &edge = mEdges[mStack.back().edge];
                if (edge.vertex != NoVertex && edge.corner == mStack.back().corner)
                    gate = mStack.back().edge;
                mStack.pop_back();
            }
        }
        return true;
    }

    std::uint32_t firstTriangle()
    {
        const std::uint32_t a = newVertex({});
        const std::uint32_t b = newVertex({a, a, a});
        const std::uint32_t c = newVertex({b, b, a});
        mSource.firstTriangle();
        const Corner corner = newTriangle(a, b, c, NoCorner);
        const std::uint32_t ba = newEdge(b, corner + 2), ac = newEdge(a, corner + 1), cb = newEdge(c, corner);
        mSource.firstEdges(ba, ac, cb);
        join(ba, ac);
        join(ac, cb);
        join(cb, ba);
        return ba;
    }

    GateView view(std::uint32_t gate) const
    {
        const LoopEdge &g = mEdges[gate];
        const LoopEdge &next = mEdges[g.next], &second = mEdges[next.next], &third = mEdges[second.next];
        const LoopEdge &previous = mEdges[g.previous];
        GateView view;
        view.left = mDegrees[g.vertex];
        view.right = mDegrees[next.vertex];
        view.after = mDegrees[second.vertex];
        view.beyond = mDegrees[third.vertex];
        view.before = mDegrees[previous.vertex];
        view.behind = g.corner == NoCorner ? 0 : mDegrees[mVertices[g.corner]];
        view.loop = g.next == g.previous ? 2 : next.next == g.previous ? 3 : 4;
        const auto bit = [](const LoopEdge &edge, unsigned place) {
            return std::uint8_t((edge.corner == NoCorner) << place);
        };
        view.holeEdges = bit(previous, 0) | bit(g, 1) | bit(next, 2) | bit(second, 3) | bit(third, 4);
        return view;
    }

    /// One triangle. `gate` becomes the next gate, NoEdge where the loop is closed. \returns false if it is corrupt
    bool step(std::uint32_t &gate)
    {
        const std::uint32_t before = mEdges[gate].previous, after = mEdges[gate].next;
        const std::uint32_t left = mEdges[gate].vertex, right = mEdges[after].vertex;
        const Corner behind = mEdges[gate].corner;
        const Clers symbol = codeSymbol(mCoder, mSymbols, view(gate), mSource.symbolAt(gate, before, after));
        if (mSource.isObserved())
            mSource.observe(symbol);
        switch (symbol) {
        case Clers::C: {
            if (!mayOpen(1))
                return false;
            const std::uint32_t vertex =
                newVertex(behind == NoCorner ? VertexNeighbours{left, left, left}
                                             : VertexNeighbours{left, right, mVertices[behind]});
            mSource.visitTip();
            const std::uint32_t leftEdge = add(vertex, left, right, gate);
            join(before, leftEdge);
            if (mHolesLeft > 0 && mCoder.decision(touchProbability(), mSource.touchesHole())) {
                const std::uint32_t hole = newHole(vertex, left);
                if (hole == NoEdge)
                    return false;
                const std::uint32_t last = mEdges[hole].previous;
                join(leftEdge, hole);
                join(last, gate);
            } else {
                join(leftEdge, gate);
            }
            join(gate, after);
            return true;
        }
        case Clers::S: {
            if (!mayOpen(1))
                return false;
            const std::uint32_t target = codeTarget(gate);
            if (target == NoEdge)
                return false;
            const std::uint32_t vertex = mEdges[target].vertex;
            if (vertex == left || vertex == right)
                return false;
            if (mSource.isObserved() && !isInLoop(gate, target))
                mSource.observeHandle();
            const std::uint32_t leftEdge = add(vertex, left, right, gate);
            const std::uint32_t beforeTarget = mEdges[target].previous;
            // `before` and `target` may be the same edge, `beforeTarget` and `after` too.
            join(before, leftEdge);
            join(leftEdge, target);
            join(beforeTarget, gate);
            join(gate, after);
            mStack.push_back({leftEdge, mEdges[leftEdge].corner});
            return true;
        }
        case Clers::R: {
            const std::uint32_t vertex = end(after);
            if (vertex == left)
                return false;
            const Corner corner = newTriangle(vertex, left, right, behind, mEdges[after].corner);
            mSource.reachedLeft(gate);
            const std::uint32_t beyond = mEdges[after].next;
            closeEdge(after);
            mEdges[gate].corner = corner + 2;
            join(gate, beyond);
            return true;
        }
        case Clers::L: {
            const std::uint32_t vertex = mEdges[before].vertex;
            if (vertex == right)
                return false;
            const Corner corner = newTriangle(vertex, left, right, behind, NoCorner, mEdges[before].corner);
            mSource.reachedRight(gate);
            const std::uint32_t beyond = mEdges[before].previous;
            closeEdge(before);
            mEdges[gate].vertex = vertex;
            mEdges[gate].corner = corner + 1;
            join(beyond, gate);
            return true;
        }
        case Clers::E: {
            newTriangle(mEdges[before].vertex, left, right, behind, mEdges[after].corner, mEdges[before].corner);
            closeEdge(before);
            closeEdge(after);
            closeEdge(gate);
            gate = NoEdge;
            return true;
        }
        }
        return false;
    }

    /// A triangle with both its other edges open: the gate becomes the right one. \returns the left one
    std::uint32_t add(std::uint32_t vertex, std::uint32_t left, std::uint32_t right, std::uint32_t gate)
    {
        const Corner corner = newTriangle(vertex, left, right, mEdges[gate].corner);
        const std::uint32_t leftEdge = newEdge(left, corner + 2);
        mSource.opened(leftEdge, gate);
        mEdges[gate].vertex = vertex;
        mEdges[gate].corner = corner + 1;
        return leftEdge;
    }

    /// The edge that starts at the vertex of an S: one of those near the gate, or how many edges after or before it, or
    /// its number.
    std::uint32_t codeTarget(std::uint32_t gate)
    {
        std::uint32_t wanted = mSource.targetEdge();
        if (wanted != NoEdge && mSource.targetIsEnd()) // the encoder
            wanted = mEdges[wanted].next;
        const std::uint32_t near = codeNearTarget(gate, wanted);
        return near != NoEdge ? near : codeFarTarget(gate, wanted);
    }

    /// Outwards from the gate on both sides, until they meet. \returns NoEdge if it is none of those
    std::uint32_t codeNearTarget(std::uint32_t gate, std::uint32_t wanted)
    {
        const std::uint32_t after = mEdges[gate].next;
        // The last ones that were asked for, and the places that they have.
        std::uint32_t forward = mEdges[after].next, backward = mEdges[gate].previous;
        for (const std::int8_t place : PlaceModel::Order) {
            const std::uint8_t left = countBetween(forward, backward);
            if (left == 0)
                break;
            const std::uint32_t edge = place > 0 ? mEdges[forward].next : mEdges[backward].previous;
            (place > 0 ? forward : backward) = edge;
            const LoopEdge &at = mEdges[edge];
            const LoopEdge &previous = mEdges[at.previous];
            const std::uint8_t ends[2]{mDegrees[previous.vertex], mDegrees[end(edge)]};
            PlaceView view;
            view.degree = mDegrees[at.vertex];
            view.nearer = ends[place < 0];
            view.farther = ends[place > 0];
            view.gateEnd = mDegrees[mEdges[place > 0 ? after : gate].vertex];
            view.holeEdges = std::uint8_t((at.corner == NoCorner) + 2 * (previous.corner == NoCorner));
            view.left = left;
            if (mPlaces.code(mCoder, place, view, edge == wanted))
                return edge;
        }
        return NoEdge;
    }

    /// Edges from one to the other, both not counted; no more than 3. 0 if they are one.
    std::uint8_t countBetween(std::uint32_t from, std::uint32_t to) const
    {
        if (from == to)
            return 0;
        std::uint8_t count = 0;
        for (std::uint32_t at = mEdges[from].next; at != to && count < 3; at = mEdges[at].next)
            ++count;
        return count;
    }

    std::uint32_t codeFarTarget(std::uint32_t gate, std::uint32_t wanted)
    {
        const std::int64_t limit = std::min(MaxSteps, mStepsLeft);
        std::int64_t steps = 0;
        if (wanted != NoEdge) { // the encoder
            std::uint32_t forward = mEdges[mEdges[gate].next].next, backward = mEdges[gate].previous;
            for (std::int64_t i = 1; i <= limit && steps == 0; ++i) {
                steps = forward == wanted ? i : backward == wanted ? -i : 0;
                forward = mEdges[forward].next;
                backward = mEdges[backward].previous;
            }
        }
        steps = mStepModel.codeSigned(mCoder, steps);
        if (steps > limit || steps < -limit)
            return NoEdge;
        if (steps == 0)
            return codeEdge(wanted);
        mStepsLeft -= steps < 0 ? -steps : steps;
        std::uint32_t edge = steps > 0 ? mEdges[gate].next : gate;
        for (; steps > 0; --steps)
            edge = mEdges[edge].next;
        for (; steps < 0; ++steps)
            edge = mEdges[edge].previous;
        return edge;
    }

    std::uint32_t codeEdge(std::uint32_t wanted)
    {
        unsigned left = unsigned(std::bit_width(mEdges.size() - 1));
        std::uint32_t edge = 0;
        while (left > 0) {
            const unsigned bits = std::min(left, MaxDirectBits);
            left -= bits;
            edge = edge << bits | mCoder.direct(bits, wanted >> left & ((1u << bits) - 1));
        }
        return edge < mEdges.size() && mEdges[edge].vertex != NoVertex ? edge : NoEdge;
    }

    /// The left part of an S, to be walked after the right one.
    struct Waiting
    {
        std::uint32_t edge;
        Corner corner; ///< that it had: names it, as an edge that was closed may be used for another
    };

    Coder &mCoder;
    Source &mSource;
    const std::uint32_t mTriangleCount;
    const std::uint32_t mVertexRoom;
    const std::uint64_t mMemoryLimit;
    std::int64_t mStepsLeft;
    std::vector<std::uint8_t> mDegrees; ///< triangles so far at each vertex
    std::vector<LoopEdge> mEdges;
    std::vector<Waiting> mStack;
    std::uint32_t mFreeEdge = NoEdge;
    std::uint32_t mDone = 0; ///< triangles
    std::uint64_t mOpenCount = 0;
    std::uint64_t mHolesLeft = 0;
    bool mHasFlips = false;
    bool mMemoryLimitReached = false;

    SymbolModel mSymbols;
    PlaceModel mPlaces;
    CountedInteger mHoleCountModel, mHoleLengthModel, mStepModel;
    CountedBit mStartModel;
    TurnModel mTurns;
};

} // namespace model::codec
