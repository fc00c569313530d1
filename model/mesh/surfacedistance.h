// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/geometry/boxtree.h"
#include "model/geometry/vec3d.h"
#include "model/mesh/trianglemesh.h"

#include <array>
#include <span>
#include <vector>

namespace model {

/// The squared distance of a point to a triangle, also to one without area.
double squaredDistanceToTriangle(Vec3d point, const std::array<Vec3d, 3> &corners);

/// A surface that moves: its triangles, arranged once for all its frames. A vertex without a triangle is a part of the
/// surface too, as a triangle of three equal corners.
class SurfaceTree
{
public:
    /// \param positions  #V, of any frame
    /// After a cancel through `progress` it is of no use.
    SurfaceTree(const Connectivity &connectivity, std::span<const Vec3f> positions,
                const Progress &progress = Progress());

    std::span<const Triangle> triangles() const { return mTriangles; }
    const BoxTree &tree() const { return mTree; }

private:
    std::vector<Triangle> mTriangles; ///< the connectivity's, then one for each lone vertex
    BoxTree mTree;
};

/// A surface in one frame, asked how far points are from it. Refers to the tree and the positions.
class SurfaceDistance
{
public:
    /// \param positions  #V
    SurfaceDistance(const SurfaceTree &surface, std::span<const Vec3f> positions);

    /// The squared distance of `point` to the surface, if that is more than `enough`; else any distance to a point of
    /// the surface that is not more. Infinite without triangles.
    /// \param triangle  where to look first, if it is one; set to the triangle of the distance returned
    double squared(Vec3d point, std::uint32_t &triangle, double enough = 0) const;

    static constexpr std::uint32_t NoTriangle = ~0u;

private:
    double squaredToTriangle(Vec3d point, std::uint32_t triangle) const;

    const SurfaceTree &mSurface;
    std::span<const Vec3f> mPositions;
    std::vector<Box3f> mBoxes;
};

} // namespace model
