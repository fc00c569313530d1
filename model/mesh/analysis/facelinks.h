// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/faces.h"
#include "model/mesh/vertexedges.h"

namespace model {

// What a side has across its edge instead of another side.
inline constexpr std::uint32_t BorderSide = ~std::uint32_t(0); ///< nothing: the edge has this side alone
inline constexpr std::uint32_t CrowdedSide = BorderSide - 1;   ///< two sides or more: see FaceLinks::crowded()
inline constexpr std::uint32_t PointSide = CrowdedSide - 1;    ///< it starts where it ends and has no edge
inline constexpr std::uint32_t LastLinkedSide = PointSide - 1; ///< everything up to here is a side

/// How the faces of a mesh meet at its edges, whatever is wrong with it. Nothing is repaired: where two faces run along
/// an edge in the same direction they are linked all the same.
class FaceLinks
{
public:
    /// Time and memory: linear, but for vertices of very many faces, whose edges are sorted. Keeps a reference.
    explicit FaceLinks(const Faces &faces);

    const Faces &faces() const { return mFaces; }

    /// The other of the two sides of an edge; or BorderSide, CrowdedSide, PointSide.
    std::uint32_t across(std::uint32_t side) const { return mAcross[side]; }
    bool isLinked(std::uint32_t side) const { return mAcross[side] <= LastLinkedSide; }
    bool isBorder(std::uint32_t side) const { return mAcross[side] == BorderSide; }
    /// Both sides of the edge run the same way: their faces are wound against each other.
    /// Precondition: isLinked(side).
    bool isTwisted(std::uint32_t side) const { return mFaces.vertex(side) == mFaces.vertex(mAcross[side]); }
    Edge edge(std::uint32_t side) const;

    /// The edges of three sides or more, sorted, and their sides in ascending order.
    struct CrowdedEdge
    {
        Edge edge;
        std::vector<std::uint32_t> sides;
    };
    const std::vector<CrowdedEdge> &crowded() const { return mCrowded; }

    std::uint32_t edgeCount() const { return mEdgeCount; }

    /// A corner and the one of its two sides over which a walk around its vertex goes on.
    struct Step
    {
        std::uint32_t corner, side;
    };
    /// The next corner around the vertex. Precondition: isLinked(at.side).
    Step aroundVertex(Step at) const
    {
        const std::uint32_t vertex = mFaces.vertex(at.corner), other = mAcross[at.side];
        if (mFaces.vertex(other) == vertex)
            return {other, mFaces.previous(other)};
        const std::uint32_t corner = mFaces.next(other);
        return {corner, corner};
    }

private:
    const Faces &mFaces;
    std::vector<std::uint32_t> mAcross;
    std::vector<CrowdedEdge> mCrowded;
    std::uint32_t mEdgeCount = 0;
};

} // namespace model
