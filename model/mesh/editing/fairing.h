// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/editing/editedmesh.h"

namespace model {

/// Weights that put free vertices where a thin plate held at the others would have them: they minimise the sum of the
/// squared differences of every free vertex, and of every one beside it, from the mean of its neighbours. The minimum
/// is linear in the positions of the others and does not depend on them, so one set of weights serves all frames.
/// \param neighbours  of each vertex; mutual
/// \param free        ascending
/// \returns           for each free vertex its shares of others, weights adding up to 1; empty where `free` is not
///                    connected to any other vertex
/// Cost: a sparse factorisation, and a solution for each vertex that holds.
/// Source: M. Botsch, L. Kobbelt: An Intuitive Framework for Real-Time Freeform Modeling, 2004, with uniform weights.
std::vector<std::vector<VertexSources::Share>> fairingWeights(const std::vector<std::vector<std::uint32_t>> &neighbours,
                                                              const std::vector<std::uint32_t> &free);

} // namespace model
