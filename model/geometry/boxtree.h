// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/geometry/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace model {

/// A balanced binary tree over items that lie near their centres. It says only which items belong together: boxes are
/// fitted to it apart, so that one tree serves all frames of an animation. Depth: at most 32 below the root.
struct BoxTree
{
    struct Node
    {
        std::uint32_t begin = 0, end = 0; ///< its items, as a range of `order`
        std::uint32_t right = 0;          ///< index of the right child, the left one follows its parent; 0: a leaf
        bool isLeaf() const { return right == 0; }
        std::uint32_t size() const { return end - begin; }
    };
    std::vector<Node> nodes;          ///< the root first, children behind their parents; empty without items
    std::vector<std::uint32_t> order; ///< #items, a permutation
};

/// Splits at the median along the longest side until at most `leafSize` items are left.
/// After a cancel through `progress` the tree is of no use.
BoxTree makeBoxTree(std::span<const Vec3f> centres, std::uint32_t leafSize, const Progress &progress = Progress());

/// The smallest boxes, #nodes, that hold `boxOf(item)` of all items below; O(items).
template <class BoxOf>
std::vector<Box3f> fitBoxes(const BoxTree &tree, BoxOf boxOf)
{
    std::vector<Box3f> boxes(tree.nodes.size());
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        const BoxTree::Node &node = tree.nodes[i];
        if (node.isLeaf()) {
            for (std::uint32_t at = node.begin; at < node.end; ++at)
                boxes[i].add(boxOf(tree.order[at]));
        } else {
            boxes[i] = boxes[i + 1];
            boxes[i].add(boxes[node.right]);
        }
    }
    return boxes;
}

} // namespace model
