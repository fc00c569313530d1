// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/connectivity/meshsource.h"

namespace model::codec {

MeshSource::MeshSource(const ManifoldCut &cut)
    : mCut(cut)
    , mMesh(cut.corners)
    , mIsKnown(mMesh.vertexCount())
    , mIsDone(mMesh.triangleCount())
    , mEdges(mMesh.cornerCount(), NoEdge)
{
    std::vector<bool> walked;
    for (Corner c = 0; c < mMesh.cornerCount(); ++c) {
        if (mMesh.opposite(c) != NoCorner)
            continue;
        if (walked.empty()) {
            walked.resize(mMesh.cornerCount());
            mBorders.resize(mMesh.vertexCount(), NoCorner);
        }
        if (walked[c])
            continue;
        ++mHoleCount;
        for (Corner at = c; !walked[at]; at = nextBorder(mMesh, at)) {
            walked[at] = true;
            mBorders[mMesh.vertex(CornerTable::next(at))] = at;
        }
    }
    mOrder.reserve(mMesh.vertexCount());
}

void MeshSource::startComponent()
{
    // Parts with a border start with one of their holes; when none of them is left, those without.
    for (; mNextBorder < mMesh.cornerCount(); ++mNextBorder)
        if (mMesh.opposite(mNextBorder) == NoCorner && !mIsDone[mNextBorder / 3]) {
            mBorder = mNextBorder;
            return;
        }
    mBorder = NoCorner;
    while (mIsDone[mNextTriangle])
        ++mNextTriangle;
}

std::int64_t MeshSource::holeLength() const
{
    std::int64_t length = 0;
    Corner at = mBorder;
    do {
        ++length;
        at = nextBorder(mMesh, at);
    } while (at != mBorder);
    return length;
}

void MeshSource::firstTriangle()
{
    mTip = 3 * mNextTriangle;
    mIsDone[mNextTriangle] = true;
    name(mMesh.vertex(mTip));
    name(mMesh.vertex(mTip + 1));
    name(mMesh.vertex(mTip + 2));
}

void MeshSource::firstEdges(std::uint32_t ba, std::uint32_t ac, std::uint32_t cb)
{
    place(ba, mMesh.opposite(mTip + 2));
    place(ac, mMesh.opposite(mTip + 1));
    place(cb, mMesh.opposite(mTip));
}

Clers MeshSource::symbolAt(std::uint32_t gate, std::uint32_t before, std::uint32_t after)
{
    mTip = mFaced[gate];
    mIsDone[mTip / 3] = true;
    if (!mIsKnown[mMesh.vertex(mTip)])
        return Clers::C;
    const bool right = mFaced[after] == CornerTable::next(mTip);
    const bool left = mFaced[before] == CornerTable::previous(mTip);
    return right ? left ? Clers::E : Clers::R : left ? Clers::L : Clers::S;
}

std::uint32_t MeshSource::targetEdge()
{
    // Around the vertex, from triangle to triangle, both ways at once until an edge of a loop: the shorter way decides
    // how long it takes.
    Corner leftwards = CornerTable::previous(mTip);
    Corner rightwards = CornerTable::next(mTip);
    for (;;) {
        leftwards = CornerTable::next(mMesh.opposite(leftwards));
        mTargetIsEnd = false;
        if (const std::uint32_t edge = openEdge(leftwards); edge != NoEdge)
            return edge;
        rightwards = CornerTable::previous(mMesh.opposite(rightwards));
        mTargetIsEnd = true;
        if (const std::uint32_t edge = openEdge(rightwards); edge != NoEdge)
            return edge;
    }
}

} // namespace model::codec
