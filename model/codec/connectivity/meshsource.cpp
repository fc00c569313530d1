// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/connectivity/meshsource.h"

#include "model/base/parallel.h"

#include <atomic>

namespace model::codec {

MeshSource::MeshSource(ManifoldCut cut, WalkObserver *observer)
    : mCut(std::move(cut))
    , mObserver(observer)
    , mTriangleCount(mCut.corners.triangleCount())
    , mFaces(std::make_unique_for_overwrite<Face[]>(mTriangleCount))
    , mIsKnown(mCut.corners.vertexCount())
{
    const CornerTable mesh = std::move(mCut.corners);
    constexpr std::size_t Grain = 1 << 15; // triangles
    std::atomic<bool> hasBorders = false;
    parallelRanges(mTriangleCount, Grain, [&](std::size_t begin, std::size_t end) {
        std::uint8_t any = 0;
        for (std::size_t t = begin; t < end; ++t) {
            Face &face = mFaces[t];
            face = {};
            for (unsigned i = 0; i < 3; ++i) {
                face.vertices[i] = mesh.vertex(Corner(3 * t + i));
                face.across[i] = mesh.opposite(Corner(3 * t + i));
                face.borders |= std::uint8_t((face.across[i] == NoCorner) << i);
            }
            any |= face.borders;
        }
        if (any)
            hasBorders = true;
    });
    if (hasBorders)
        findBorders(mesh);
    mOrder.reserve(mesh.vertexCount());
}

void MeshSource::findBorders(const CornerTable &mesh)
{
    mBorders.resize(mesh.vertexCount(), NoCorner);
    for (Corner c = 0; c < mesh.cornerCount(); ++c) {
        if (mesh.opposite(c) != NoCorner || across(c) != NoCorner)
            continue;
        ++mHoleCount;
        for (Corner at = c; across(at) == NoCorner; at = across(at)) {
            mFaces[at / 3].across[at % 3] = nextBorder(mesh, at);
            mBorders[vertex(CornerTable::next(at))] = at;
        }
    }
}

void MeshSource::startComponent()
{
    if (mObserver)
        mObserver->startComponent();
    // Parts with a border start with one of their holes; when none of them is left, those without.
    for (; mNextBorder < 3 * mTriangleCount; ++mNextBorder) {
        const Face &face = mFaces[mNextBorder / 3];
        if (face.borders >> mNextBorder % 3 & 1 && !face.isDone) {
            mBorder = mNextBorder;
            return;
        }
    }
    mBorder = NoCorner;
    while (mFaces[mNextTriangle].isDone)
        ++mNextTriangle;
}

std::int64_t MeshSource::holeLength() const
{
    std::int64_t length = 0;
    Corner at = mBorder;
    do {
        ++length;
        at = across(at);
    } while (at != mBorder);
    return length;
}

void MeshSource::firstTriangle()
{
    mTip = 3 * mNextTriangle;
    Face &face = mFaces[mNextTriangle];
    face.isDone = true;
    for (const std::uint32_t vertex : face.vertices)
        name(vertex);
}

void MeshSource::firstEdges(std::uint32_t ba, std::uint32_t ac, std::uint32_t cb)
{
    place(ba, across(mTip + 2));
    place(ac, across(mTip + 1));
    place(cb, across(mTip));
}

Clers MeshSource::symbolAt(std::uint32_t gate, std::uint32_t before, std::uint32_t after)
{
    mTip = mFaced[gate];
    Face &face = mFaces[mTip / 3];
    face.isDone = true;
    if (!mIsKnown[face.vertices[mTip % 3]])
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
        leftwards = CornerTable::next(across(leftwards));
        mTargetIsEnd = false;
        if (isOpen(leftwards))
            return across(leftwards);
        rightwards = CornerTable::previous(across(rightwards));
        mTargetIsEnd = true;
        if (isOpen(rightwards))
            return across(rightwards);
    }
}

} // namespace model::codec
