// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: C. Ericson, Real-Time Collision Detection, 2005, 5.1.5 (the regions around a triangle).
// Differs: the distance to the plane is taken from the normal, and triangles that are nearly without area are their
// three edges.
#include "model/mesh/surfacedistance.h"

#include <algorithm>
#include <limits>

namespace model {

namespace {

constexpr std::uint32_t LeafSize = 4;
constexpr std::size_t DeepestTree = 40;
/// Squared area below which a triangle is its edges, as a share of the squared product of two edges: coordinates are
/// floats, so that differences and areas in double have some 7 digits left here.
constexpr double ThinTriangle = 1e-18;

double squaredDistanceToSegment(Vec3d p, Vec3d a, Vec3d b)
{
    const Vec3d ab = b - a, ap = p - a;
    const double t = dot(ap, ab), length = dot(ab, ab);
    if (t <= 0 || !(length > 0))
        return dot(ap, ap);
    if (t >= length)
        return squaredDistance(p, b);
    const Vec3d off = ap - ab * (t / length);
    return dot(off, off);
}

double squaredDistanceToBox(Vec3d p, const Box3f &box)
{
    const auto outside = [](double x, double low, double high) { return std::max({low - x, x - high, 0.0}); };
    const Vec3d off{outside(p.x, box.min.x, box.max.x), outside(p.y, box.min.y, box.max.y),
                    outside(p.z, box.min.z, box.max.z)};
    return dot(off, off);
}

} // namespace

double squaredDistanceToTriangle(Vec3d point, const std::array<Vec3d, 3> &corners)
{
    const auto &[a, b, c] = corners;
    const Vec3d ab = b - a, ac = c - a, ap = point - a;
    const Vec3d normal = cross(ab, ac);
    const double area = dot(normal, normal);
    const bool isThin = !(area > ThinTriangle * dot(ab, ab) * dot(ac, ac));
    if (!isThin) {
        // Barycentric coordinates of the foot point, times the area.
        const double w = dot(cross(ab, ap), normal), v = dot(cross(ap, ac), normal), u = area - v - w;
        if (u >= 0 && v >= 0 && w >= 0) {
            const double height = dot(ap, normal);
            return height * height / area;
        }
    }
    return std::min({squaredDistanceToSegment(point, a, b), squaredDistanceToSegment(point, b, c),
                     squaredDistanceToSegment(point, c, a)});
}

SurfaceTree::SurfaceTree(const Connectivity &connectivity, std::span<const Vec3f> positions, const Progress &progress)
    : mTriangles(connectivity.triangles)
{
    std::vector<bool> isUsed(connectivity.vertexCount);
    for (const Triangle &triangle : mTriangles)
        for (const std::uint32_t vertex : triangle)
            isUsed[vertex] = true;
    for (std::uint32_t vertex = 0; vertex < connectivity.vertexCount; ++vertex)
        if (!isUsed[vertex])
            mTriangles.push_back({vertex, vertex, vertex});
    std::vector<Vec3f> centres(mTriangles.size());
    for (std::size_t i = 0; i < centres.size(); ++i) {
        const auto &[a, b, c] = mTriangles[i];
        centres[i] = (positions[a] + positions[b] + positions[c]) * (1.0f / 3);
    }
    mTree = makeBoxTree(centres, LeafSize, progress);
}

SurfaceDistance::SurfaceDistance(const SurfaceTree &surface, std::span<const Vec3f> positions)
    : mSurface(surface)
    , mPositions(positions)
    , mBoxes(fitBoxes(surface.tree(), [&](std::uint32_t i) {
        Box3f box;
        for (const std::uint32_t vertex : surface.triangles()[i])
            box.add(positions[vertex]);
        return box;
    }))
{}

double SurfaceDistance::squaredToTriangle(Vec3d point, std::uint32_t triangle) const
{
    const auto &[a, b, c] = mSurface.triangles()[triangle];
    return squaredDistanceToTriangle(point, {mPositions[a], mPositions[b], mPositions[c]});
}

double SurfaceDistance::squared(Vec3d point, std::uint32_t &triangle, double enough) const
{
    double best = triangle == NoTriangle ? std::numeric_limits<double>::infinity() : squaredToTriangle(point, triangle);
    if (mBoxes.empty() || best <= enough)
        return best;
    struct Task
    {
        std::uint32_t node;
        double nearest; ///< squared; nothing in it is nearer
    };
    std::array<Task, DeepestTree> tasks;
    std::size_t waiting = 0;
    tasks[waiting++] = {0, squaredDistanceToBox(point, mBoxes[0])};
    const std::vector<BoxTree::Node> &nodes = mSurface.tree().nodes;
    while (waiting > 0) {
        const Task task = tasks[--waiting];
        if (task.nearest >= best)
            continue;
        const BoxTree::Node &node = nodes[task.node];
        if (node.isLeaf()) {
            for (std::uint32_t at = node.begin; at < node.end; ++at) {
                const std::uint32_t candidate = mSurface.tree().order[at];
                const double here = squaredToTriangle(point, candidate);
                if (here < best) {
                    best = here;
                    triangle = candidate;
                }
            }
            if (best <= enough)
                return best;
            continue;
        }
        Task near{task.node + 1, squaredDistanceToBox(point, mBoxes[task.node + 1])};
        Task far{node.right, squaredDistanceToBox(point, mBoxes[node.right])};
        if (far.nearest < near.nearest)
            std::swap(near, far);
        tasks[waiting++] = far;
        tasks[waiting++] = near;
    }
    return best;
}

} // namespace model
