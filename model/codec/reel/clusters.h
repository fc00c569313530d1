// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/codec/entropy/rangecoder.h"
#include "model/codec/reel/coarsetofine.h"

#include <Eigen/Core>

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace model::codec {

/// Most clusters of an animation. Part of the format.
inline constexpr std::uint32_t MaxClusters = 64;

/// Parts of a mesh that move each in its own way: a trajectory belongs to one of them, and only its vertices have
/// coefficients on it. Clusters are made of whole connected components. FORMAT.md 13.7.
struct Clusters
{
    std::uint32_t count = 1;
    std::vector<std::uint32_t> labels; ///< #components: the cluster of each; empty: all are in one
    bool operator==(const Clusters &) const = default;
};

/// For each node its connected component. They are numbered by their first nodes.
std::vector<std::uint32_t> componentsOf(const CoarseToFine &nodes);

/// The nodes of each cluster, rising. \param components  as componentsOf()
std::vector<std::vector<std::uint32_t>> nodesOf(const Clusters &clusters, std::span<const std::uint32_t> components);

/// Some of the nodes as an order of their own: its lists are without the other nodes. \param members  rising
CoarseToFine restrictedTo(const CoarseToFine &nodes, std::span<const std::uint32_t> members);

/// Codes numbers of clusters.
class ClusterLabelCoder
{
public:
    explicit ClusterLabelCoder(std::uint32_t count)
        : mBits(unsigned(std::bit_width(count - 1)))
        , mTree(std::size_t(1) << mBits)
    {}
    /// \returns  what a hostile stream says may be `count` or more
    template <class Coder>
    std::uint32_t code(Coder &coder, std::uint32_t label = 0)
    {
        std::uint32_t node = 1;
        for (unsigned i = mBits; i-- > 0;)
            node = 2 * node + coder.bit(mTree[node], (label >> i) & 1);
        return node - (1u << mBits);
    }

private:
    unsigned mBits;
    std::vector<AdaptiveBit> mTree;
};

/// The clusters of so many components, as they are stored. FORMAT.md 13.7.
/// \returns  false if a cluster does not exist
template <class Coder>
bool codeClusters(Coder &coder, Clusters &clusters, std::size_t components)
{
    clusters.count = 1 + coder.direct(6, clusters.count - 1);
    clusters.labels.resize(components);
    ClusterLabelCoder coded(clusters.count);
    for (std::uint32_t &label : clusters.labels) {
        label = coded.code(coder, label);
        if (label >= clusters.count)
            return false;
    }
    return true;
}

/// Groups components greedily, as long as two groups need fewer bits with trajectories in common than with their own.
/// \param coefficients  of the vertices on trajectories of the whole animation: #K x #V
/// \param components    #V: the component of each column
/// \param rows          entries of a trajectory, 3F
/// \param step          of coefficients
/// \returns             clusters that are numbered as their first components come. \error Cancelled
Result<Clusters> clustersOf(const Eigen::MatrixXd &coefficients, std::span<const std::uint32_t> components,
                            std::size_t rows, double step, const Progress &progress);

} // namespace model::codec
