// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/analysis/parts.h"

namespace model {

/// One orientable manifold component on its own, all its faces wound alike, every boundary loop closed by a lid of one
/// face. Half-edge h starts at start[h], runs along face[h] on its left and ends where next[h] starts.
struct ClosedSurface
{
    std::vector<std::uint32_t> inputVertex;                 ///< #V
    std::vector<std::uint32_t> start, next, opposite, face; ///< #H
    std::vector<float> length;                              ///< #H
    std::uint32_t faceCount = 0;                            ///< with lids

    std::uint32_t vertexCount() const { return std::uint32_t(inputVertex.size()); }
    std::uint32_t halfEdgeCount() const { return std::uint32_t(start.size()); }
    std::uint32_t end(std::uint32_t h) const { return start[opposite[h]]; }
    /// The half-edge that starts at the same vertex, after h clockwise.
    std::uint32_t clockwise(std::uint32_t h) const { return next[opposite[h]]; }
    std::uint32_t genus() const { return (2 + halfEdgeCount() / 2 - vertexCount() - faceCount) / 2; }
};

/// Cuts components out of a mesh, one after another, in memory that is used again.
class SurfaceCutter
{
public:
    SurfaceCutter(const FaceLinks &links, const MeshParts &parts);

    /// Precondition: the component is an orientable manifold.
    ClosedSurface cut(std::uint32_t component, std::span<const Vec3f> positions);

private:
    const FaceLinks &mLinks;
    const MeshParts &mParts;
    std::vector<std::uint32_t> mFacesByComponent, mBegins; ///< #F; #components + 1
    std::vector<std::uint32_t> mHalfEdge;                  ///< #C
    std::vector<std::uint32_t> mVertex;                    ///< #V
};

} // namespace model
