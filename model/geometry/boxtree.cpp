// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/geometry/boxtree.h"

#include <algorithm>
#include <numeric>

namespace model {

namespace {

float along(Vec3f p, int axis)
{
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

int longestAxis(Vec3f size)
{
    if (size.x >= size.y && size.x >= size.z)
        return 0;
    return size.y >= size.z ? 1 : 2;
}

struct Builder
{
    std::span<const Vec3f> centres;
    std::uint32_t leafSize;
    const Progress &progress;
    BoxTree tree;

    void add(std::uint32_t begin, std::uint32_t end)
    {
        const std::size_t index = tree.nodes.size();
        tree.nodes.push_back({begin, end, 0});
        if (end - begin <= leafSize || progress.isCancelled())
            return;
        Box3f box;
        for (std::uint32_t i = begin; i < end; ++i)
            box.add(centres[tree.order[i]]);
        const int axis = longestAxis(box.size());
        const std::uint32_t middle = begin + (end - begin) / 2;
        const auto first = tree.order.begin();
        // Equal places in the order of their indices: the same tree with every standard library.
        std::nth_element(first + begin, first + middle, first + end, [&](std::uint32_t a, std::uint32_t b) {
            const float left = along(centres[a], axis), right = along(centres[b], axis);
            return left < right || (left == right && a < b);
        });
        add(begin, middle);
        tree.nodes[index].right = std::uint32_t(tree.nodes.size());
        add(middle, end);
    }
};

} // namespace

BoxTree makeBoxTree(std::span<const Vec3f> centres, std::uint32_t leafSize, const Progress &progress)
{
    if (centres.empty())
        return {};
    Builder builder{centres, std::max(leafSize, 1u), progress, {}};
    builder.tree.order.resize(centres.size());
    std::iota(builder.tree.order.begin(), builder.tree.order.end(), 0u);
    builder.add(0, std::uint32_t(centres.size()));
    return std::move(builder.tree);
}

} // namespace model
