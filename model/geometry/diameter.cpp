// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/geometry/diameter.h"

#include "model/geometry/boxtree.h"
#include "model/geometry/vec3d.h"

#include <algorithm>

namespace model {

namespace {

constexpr std::uint32_t LeafSize = 32;
constexpr int Sweeps = 4; ///< to the farthest point and on from there; more rarely find a longer distance

/// No two points of the boxes are farther apart. Rounds as squaredDistance() does, hence never below one of those.
double farthest(const Box3f &a, const Box3f &b)
{
    const Vec3d up = Vec3d(a.max) - Vec3d(b.min), down = Vec3d(b.max) - Vec3d(a.min);
    const Vec3d reach{std::max(up.x, down.x), std::max(up.y, down.y), std::max(up.z, down.z)};
    return dot(reach, reach);
}

double sweep(std::span<const Vec3f> points)
{
    double best = 0;
    Vec3f from = points.front();
    for (int i = 0; i < Sweeps; ++i) {
        Vec3f next = from;
        double reach = 0;
        for (const Vec3f &p : points)
            if (const double here = squaredDistance(p, from); here > reach) {
                reach = here;
                next = p;
            }
        best = std::max(best, reach);
        from = next;
    }
    return best;
}

} // namespace

double diameter(std::span<const Vec3f> points, const Progress &progress)
{
    if (points.empty())
        return 0;
    double best = sweep(points);
    const BoxTree tree = makeBoxTree(points, LeafSize, progress);
    const std::vector<Box3f> boxes = fitBoxes(tree, [&](std::uint32_t i) { return Box3f{points[i], points[i]}; });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs{{0, 0}};
    while (!pairs.empty() && !progress.isCancelled()) {
        const auto [a, b] = pairs.back();
        pairs.pop_back();
        if (farthest(boxes[a], boxes[b]) <= best)
            continue;
        const BoxTree::Node &first = tree.nodes[a], &second = tree.nodes[b];
        if (first.isLeaf() && second.isLeaf()) {
            for (std::uint32_t i = first.begin; i < first.end; ++i)
                for (std::uint32_t j = second.begin; j < second.end; ++j)
                    best = std::max(best, squaredDistance(points[tree.order[i]], points[tree.order[j]]));
        } else if (a == b) {
            pairs.insert(pairs.end(), {{a + 1, a + 1}, {first.right, first.right}, {a + 1, first.right}});
        } else if (second.isLeaf() || (!first.isLeaf() && first.size() >= second.size())) {
            pairs.insert(pairs.end(), {{a + 1, b}, {first.right, b}});
        } else {
            pairs.insert(pairs.end(), {{a, b + 1}, {a, second.right}});
        }
    }
    return std::sqrt(best);
}

} // namespace model
