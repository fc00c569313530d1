// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace model {

/// A largest set of pairs of the nodes of a graph, no node in two of them. Among nodes that are free, a node takes the
/// first of its neighbours; that is changed only where more pairs can be made so.
/// \param neighbours  of each node, in the order of preference; mutual
/// \returns           the partner of each node, NoPartner where there is none
/// Source: J. Edmonds: Paths, Trees, and Flowers, 1965. Time: O(V^3) at worst.
std::vector<std::uint32_t> maximumMatching(const std::vector<std::vector<std::uint32_t>> &neighbours);

inline constexpr std::uint32_t NoPartner = ~std::uint32_t(0);

} // namespace model
