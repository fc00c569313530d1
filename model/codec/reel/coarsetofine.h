// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/mesh/trianglemesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace model::codec {

/// Lists of numbers, one list for each node, in one piece of memory.
class NodeLists
{
public:
    std::span<const std::uint32_t> operator[](std::size_t node) const
    {
        return {mValues.data() + mStarts[node], mValues.data() + mStarts[node + 1]};
    }
    std::size_t size() const { return mStarts.size() - 1; }
    void reserve(std::size_t lists, std::size_t values)
    {
        mStarts.reserve(lists + 1);
        mValues.reserve(values);
    }
    void add(std::span<const std::uint32_t> list)
    {
        mValues.insert(mValues.end(), list.begin(), list.end());
        mStarts.push_back(mValues.size());
    }

private:
    std::vector<std::uint32_t> mValues;
    std::vector<std::size_t> mStarts{0};
};

/// A link of the mesh before anything was removed is this long.
inline constexpr std::uint32_t UnitLength = 16;
/// Most nodes that one is predicted from. Part of the format.
inline constexpr std::size_t MaxKnown = 12;

/// An order of the vertices of a mesh, or of the frames of an animation, in which each can be interpolated from others
/// all around it: coarse to fine. Nodes are numbered in that order. Made of integers only, so that every decoder makes
/// the same one. FORMAT.md 13.2.
struct CoarseToFine
{
    std::vector<std::uint32_t> vertices; ///< #N; the vertex (or frame) that a node is
    std::vector<std::uint8_t> levels;    ///< #N; 0 is the coarsest
    std::uint8_t finest = 0;             ///< the largest of them
    NodeLists known;                     ///< at most MaxKnown nodes before the node, the nearest first
    NodeLists lengths;                   ///< how far away they are, in UnitLength
    /// The neighbours of the node at the time when nothing finer than it is known; all before it. The first of `ring`
    /// need not be the nearest. Empty for frames.
    NodeLists ring;
    NodeLists ringLengths;
    NodeLists adjacent; ///< the neighbours in the mesh (or in time), before and after the node

    std::size_t size() const { return vertices.size(); }
};

/// Removes, again and again, a set of vertices no two of which are neighbours, those with the fewest neighbours first;
/// the order is the reverse. \error Cancelled
Result<CoarseToFine> coarseToFine(const Connectivity &connectivity, const Progress &progress);

/// Frames in the order 0, 64, 128, ..., 32, 96, ..., each between the known ones.
CoarseToFine coarseToFineInTime(std::uint32_t frameCount);

} // namespace model::codec
