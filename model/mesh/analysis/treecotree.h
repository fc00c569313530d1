// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/mesh/analysis/closedsurface.h"

namespace model {

/// A closed way along edges: a vertex comes once, and the last is joined to the first.
struct EdgeLoop
{
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> halfEdges; ///< the i-th joins vertex i and the next one, in either direction
    double length = 0;
};

/// The tree of shortest ways from a root over the edges, and of the other edges the tree over the faces that leaves the
/// shortest loops. 2 genus edges are in neither: each makes a loop with the ways from its ends, up to where they meet.
/// These loops are simple, and together they are a basis of the surface's loops up to homology.
class TreeCotree
{
public:
    /// What the algorithm asks for, again and again, of one surface.
    struct Graph
    {
        struct Arc
        {
            std::uint32_t halfEdge, end;
            float length;
        };
        explicit Graph(const ClosedSurface &surface);

        const ClosedSurface &surface;
        std::vector<std::uint32_t> begins; ///< #V + 1
        std::vector<Arc> arcs;             ///< those from each vertex
    };

    /// Time: O(n log n). After a cancel through `progress` it is of no use.
    TreeCotree(const Graph &graph, std::uint32_t root, const Progress &progress);

    /// #leftover loops, the i-th over leftover()[i].
    std::vector<EdgeLoop> loops() const;
    /// One half-edge of each, ascending.
    const std::vector<std::uint32_t> &leftover() const { return mLeftover; }
    bool isInTree(std::uint32_t halfEdge) const;
    bool isInCotree(std::uint32_t halfEdge) const { return mIsInCotree[halfEdge]; } ///< either half-edge of the edge

private:
    void growTree(std::uint32_t root);
    void growCotree();
    EdgeLoop loopOver(std::uint32_t halfEdge) const;

    const Graph &mGraph;
    std::vector<float> mDistance;      ///< #V, from the root
    std::vector<std::uint32_t> mFrom;  ///< #V, the half-edge that reaches it; none for the root
    std::vector<std::uint32_t> mDepth; ///< #V, edges from the root
    std::vector<bool> mIsInCotree;     ///< #H
    std::vector<std::uint32_t> mLeftover;
};

} // namespace model
