// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/connectivity/edgebreaker.h"
#include "model/mesh/manifoldcut.h"

#include <memory>

namespace model::codec {

/// Hears what the encoder's walk meets, triangle by triangle. Triangles are those of the input.
class WalkObserver
{
public:
    virtual ~WalkObserver() = default;
    virtual void startComponent() = 0;
    /// Not called for the first triangle of a component without a border: it has no symbol.
    virtual void triangle(std::uint32_t triangle, Clers symbol) = 0;
    /// The last triangle, an S, joins two loops of open edges: it closes a handle.
    virtual void handle(std::uint32_t triangle) = 0;
    /// A boundary loop.
    /// \param triangle  whose new vertex lies on it; NoTriangle where a component starts with it
    virtual void hole(std::uint32_t triangle, std::uint32_t length) = 0;

    static constexpr std::uint32_t NoTriangle = ~std::uint32_t(0);
};

/// As encodeConnectivity(); the observer, where not null, hears of the walk, which may take longer then.
Result<EncodedConnectivity> encodeConnectivityWatched(const Connectivity &connectivity, const Progress &progress,
                                                      WalkObserver *observer);

/// The encoder's side of EdgeBreaker: walks the mesh along with it and tells what it meets.
class MeshSource
{
public:
    /// \param cut  its corner table is not kept
    explicit MeshSource(ManifoldCut cut, WalkObserver *observer = nullptr);

    bool isObserved() const { return mObserver != nullptr; }
    void observe(Clers symbol) { mObserver->triangle(mTip / 3, symbol); }
    void observeHandle() { mObserver->handle(mTip / 3); }
    void observeHole(std::uint32_t length, bool atTip)
    {
        mObserver->hole(atTip ? mTip / 3 : WalkObserver::NoTriangle, length);
    }

    std::int64_t holeCount() const { return mHoleCount; }
    bool hasFlips() const { return !mCut.flipped.empty(); }

    void startComponent();
    bool startsAtHole() const { return mBorder != NoCorner; }
    std::int64_t holeLength() const;
    void visitBorder() { name(vertex(CornerTable::next(mBorder))); }
    void holeEdge(std::uint32_t edge)
    {
        const Corner next = across(mBorder);
        place(edge, mBorder);
        mBorder = next;
    }
    void firstTriangle();
    void firstEdges(std::uint32_t ba, std::uint32_t ac, std::uint32_t cb);

    Clers symbolAt(std::uint32_t gate, std::uint32_t before, std::uint32_t after);
    bool isFlipped() const { return mCut.isFlipped(mTip / 3); }
    void visitTip() { name(vertex(mTip)); }
    bool touchesHole()
    {
        mBorder = mBorders.empty() ? NoCorner : mBorders[vertex(mTip)];
        return mBorder != NoCorner;
    }
    void opened(std::uint32_t leftEdge, std::uint32_t gate)
    {
        reachedLeft(leftEdge);
        reachedRight(gate);
    }
    void reachedLeft(std::uint32_t edge) { place(edge, across(CornerTable::previous(mTip))); }
    void reachedRight(std::uint32_t edge) { place(edge, across(CornerTable::next(mTip))); }
    void closed(std::uint32_t edge) { mFaced[edge] = NoCorner; }
    /// An edge that starts at the vertex of an S in the gap where the triangle comes to lie, or one that ends there.
    std::uint32_t targetEdge();
    bool targetIsEnd() const { return mTargetIsEnd; }

    /// The cut, without its corner table.
    const ManifoldCut &cut() const { return mCut; }
    /// The cut mesh's vertex of each coded one.
    std::vector<std::uint32_t> takeOrder() { return std::move(mOrder); }

private:
    /// A triangle and its neighbours: what a step needs lies in one cache line, as most of its time is spent waiting
    /// for memory.
    struct alignas(32) Face
    {
        std::array<std::uint32_t, 3> vertices;
        /// For each corner the opposite one; at a border the next border edge's; while the edge is part of a loop its
        /// number there.
        std::array<std::uint32_t, 3> across;
        std::uint8_t borders, open; ///< for which corners: bits
        bool isDone;
    };

    std::uint32_t vertex(Corner c) const { return mFaces[c / 3].vertices[c % 3]; }
    std::uint32_t across(Corner c) const { return mFaces[c / 3].across[c % 3]; }
    void findBorders(const CornerTable &mesh);
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
        Face &face = mFaces[corner / 3];
        face.across[corner % 3] = edge;
        face.open |= std::uint8_t(1u << corner % 3);
    }
    bool isOpen(Corner corner) const { return mFaces[corner / 3].open >> corner % 3 & 1; }

    ManifoldCut mCut;
    WalkObserver *const mObserver;
    std::uint32_t mTriangleCount;
    std::unique_ptr<Face[]> mFaces; ///< #T
    std::vector<bool> mIsKnown;     ///< #V
    std::vector<Corner> mFaced;     ///< for each edge of a loop the corner that faces it
    std::vector<Corner> mBorders;   ///< for each vertex the corner that faces the border edge from it; may be empty
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
    static constexpr bool isObserved() { return false; }
    static constexpr void observe(Clers) {}
    static constexpr void observeHandle() {}
    static constexpr void observeHole(std::uint32_t, bool) {}
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
