// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/analysis/selfintersections.h"

#include "model/base/parallel.h"
#include "model/geometry/boxtree.h"
#include "model/mesh/analysis/trianglepredicates.h"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace model {

namespace {

bool meet(const Box3f &a, const Box3f &b)
{
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
           b.min.z <= a.max.z;
}

/// Corners at the same place first, in the same order in both. \returns how many
unsigned alignShared(std::array<Vec3f, 3> &a, std::array<Vec3f, 3> &b)
{
    unsigned shared = 0;
    for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = shared; j < 3; ++j)
            if (a[i] == b[j]) {
                std::swap(a[shared], a[i]);
                std::swap(b[shared], b[j]);
                ++shared;
                break;
            }
    return shared;
}

bool intersect(std::array<Vec3f, 3> a, std::array<Vec3f, 3> b)
{
    switch (alignShared(a, b)) {
    case 0:
        return trianglesMeet(a, b);
    case 1: // beyond the common corner they meet if the side opposite to it, of one of them, meets the other
        return segmentMeetsTriangle({a[1], a[2]}, b) || segmentMeetsTriangle({b[1], b[2]}, a);
    case 2:
        return foldsOver(a[0], a[1], a[2], b[2]);
    default:
        return false;
    }
}

} // namespace

Result<std::vector<ProblemIds>> findSelfIntersections(const Faces &faces, std::span<const Vec3f> positions,
                                                      const Progress &progress, std::size_t limit)
{
    std::vector<std::uint32_t> faceOf;
    const Connectivity mesh = fans(faces, &faceOf);
    const auto corners = [&](std::uint32_t t) {
        const Triangle &triangle = mesh.triangles[t];
        return std::array{positions[triangle[0]], positions[triangle[1]], positions[triangle[2]]};
    };
    const auto boxOf = [&](std::uint32_t t) {
        Box3f box;
        for (const Vec3f &corner : corners(t))
            box.add(corner);
        return box;
    };
    const auto count = std::uint32_t(mesh.triangles.size());
    std::vector<std::uint8_t> hasArea(count);
    std::vector<Vec3f> centres(count);
    constexpr std::size_t Grain = 1 << 12; // triangles
    parallelRanges(count, Grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            hasArea[t] = !areCollinear(corners(std::uint32_t(t)));
            centres[t] = boxOf(std::uint32_t(t)).center();
        }
    });
    const BoxTree tree = makeBoxTree(centres, 4, progress.part(0, 0.3));
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    const std::vector<Box3f> boxes = fitBoxes(tree, boxOf);

    std::vector<ProblemIds> pairs;
    std::mutex mutex;
    std::atomic<std::size_t> done = 0, found = 0;
    const auto visit = [&](std::uint32_t t, std::vector<ProblemIds> &here) {
        const Box3f box = boxOf(t);
        std::vector<std::uint32_t> stack{0};
        while (!stack.empty()) {
            const std::uint32_t at = stack.back();
            stack.pop_back();
            const BoxTree::Node &node = tree.nodes[at];
            if (!meet(box, boxes[at]))
                continue;
            if (!node.isLeaf()) {
                stack.push_back(node.right);
                stack.push_back(at + 1);
                continue;
            }
            for (std::uint32_t i = node.begin; i < node.end; ++i) {
                const std::uint32_t other = tree.order[i];
                if (other > t && hasArea[other] && faceOf[other] != faceOf[t] && meet(box, boxOf(other)) &&
                    intersect(corners(t), corners(other)))
                    here.push_back({faceOf[t], faceOf[other]});
            }
        }
    };
    parallelRanges(count, Grain / 4, [&](std::size_t begin, std::size_t end) {
        std::vector<ProblemIds> here;
        // In the order of the tree: neighbours in space ask for the same nodes.
        for (std::size_t i = begin; i < end && !progress.isCancelled() && found < limit; ++i)
            if (hasArea[tree.order[i]])
                visit(tree.order[i], here);
        found += here.size();
        const std::size_t now = done += end - begin;
        progress.report(0.3 + 0.7 * double(now) / count);
        const std::lock_guard lock(mutex);
        pairs.insert(pairs.end(), here.begin(), here.end());
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    for (ProblemIds &pair : pairs)
        std::sort(pair.begin(), pair.end());
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    progress.report(1);
    return pairs;
}

} // namespace model
