// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/connectivity/edgebreaker.h"
#include "model/mesh/manifoldcut.h"

namespace model::codec {

/// The encoder's side of EdgeBreaker: walks the mesh along with it and tells what it meets.
class MeshSource
{
public:
    explicit MeshSource(const ManifoldCut &cut);

    std::int64_t holeCount() const { return mHoleCount; }
    bool hasFlips() const { return !mCut.flipped.empty(); }

    void startComponent();
    bool startsAtHole() const { return mBorder != NoCorner; }
    std::int64_t holeLength() const;
    void visitBorder() { name(mMesh.vertex(CornerTable::next(mBorder))); }
    void holeEdge(std::uint32_t edge)
    {
        place(edge, mBorder);
        mBorder = nextBorder(mMesh, mBorder);
    }
    void firstTriangle();
    void firstEdges(std::uint32_t ba, std::uint32_t ac, std::uint32_t cb);

    Clers symbolAt(std::uint32_t gate, std::uint32_t before, std::uint32_t after);
    bool isFlipped() const { return mCut.isFlipped(mTip / 3); }
    void visitTip() { name(mMesh.vertex(mTip)); }
    bool touchesHole()
    {
        mBorder = mBorders.empty() ? NoCorner : mBorders[mMesh.vertex(mTip)];
        return mBorder != NoCorner;
    }
    void opened(std::uint32_t leftEdge, std::uint32_t gate)
    {
        reachedLeft(leftEdge);
        reachedRight(gate);
    }
    void reachedLeft(std::uint32_t edge) { place(edge, mMesh.left(mTip)); }
    void reachedRight(std::uint32_t edge) { place(edge, mMesh.right(mTip)); }
    void closed(std::uint32_t edge) { mFaced[edge] = NoCorner; }
    /// An edge that starts at the vertex of an S in the gap where the triangle comes to lie, or one that ends there.
    std::uint32_t targetEdge();
    bool targetIsEnd() const { return mTargetIsEnd; }

    /// The cut mesh's vertex of each coded one.
    std::vector<std::uint32_t> takeOrder() { return std::move(mOrder); }

private:
    void name(std::uint32_t vertex)
    {
        mIsKnown[vertex] = true;
        mOrder.push_back(vertex);
    }
    /// The loop's edge lies before the triangle of `corner`, which faces it.
    void place(std::uint32_t edge, Corner corner)
    {
        if (edge >= mFaced.size())
            mFaced.resize(std::size_t(edge) + 1, NoCorner);
        mFaced[edge] = corner;
        mEdges[corner] = edge;
    }
    /// The open edge that `corner` faces, or NoEdge.
    std::uint32_t openEdge(Corner corner) const
    {
        const std::uint32_t edge = mEdges[corner];
        return edge != NoEdge && mFaced[edge] == corner ? edge : NoEdge;
    }

    const ManifoldCut &mCut;
    const CornerTable &mMesh;
    std::vector<bool> mIsKnown;        ///< #V
    std::vector<bool> mIsDone;         ///< #T
    std::vector<std::uint32_t> mEdges; ///< for each corner the loop's edge that it faces, or did
    std::vector<Corner> mFaced;        ///< for each edge of a loop the corner that faces it
    std::vector<Corner> mBorders;      ///< for each vertex the corner that faces the border edge from it; may be empty
    std::vector<std::uint32_t> mOrder;
    std::int64_t mHoleCount = 0;
    Corner mNextBorder = 0;          ///< where to look for the next part with a border
    std::uint32_t mNextTriangle = 0; ///< and without
    Corner mBorder = NoCorner;
    Corner mTip = NoCorner;
    bool mTargetIsEnd = false;
};

/// The decoder's side: knows nothing.
struct NoSource
{
    static constexpr std::int64_t holeCount() { return 0; }
    static constexpr bool hasFlips() { return false; }
    static constexpr void startComponent() {}
    static constexpr bool startsAtHole() { return false; }
    static constexpr std::int64_t holeLength() { return 0; }
    static constexpr void visitBorder() {}
    static constexpr void holeEdge(std::uint32_t) {}
    static constexpr void firstTriangle() {}
    static constexpr void firstEdges(std::uint32_t, std::uint32_t, std::uint32_t) {}
    static constexpr Clers symbolAt(std::uint32_t, std::uint32_t, std::uint32_t) { return Clers::C; }
    static constexpr bool isFlipped() { return false; }
    static constexpr void visitTip() {}
    static constexpr bool touchesHole() { return false; }
    static constexpr void opened(std::uint32_t, std::uint32_t) {}
    static constexpr void reachedLeft(std::uint32_t) {}
    static constexpr void reachedRight(std::uint32_t) {}
    static constexpr void closed(std::uint32_t) {}
    static constexpr std::uint32_t targetEdge() { return NoEdge; }
    static constexpr bool targetIsEnd() { return false; }
};

} // namespace model::codec
