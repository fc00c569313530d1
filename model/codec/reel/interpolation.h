// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/reel/coarsetofine.h"

#include <array>
#include <span>
#include <vector>

namespace model::codec {

// How a node is interpolated from the nodes that are known before it. Floating point, but nothing beyond + - * / and
// square roots in a fixed order, so that every processor that rounds as IEEE 754 says computes the same; and nothing
// here decides which bits are read. FORMAT.md 13.5.

/// Weights of the known nodes of a node; those beyond their number are 0.
using Weights = std::array<double, MaxKnown>;

/// Weights from the shape alone: kriging, that is the best linear prediction of a smooth random field that is affine at
/// large. They add up to about 1.
/// \param places  #N x 3: where the nodes are
std::vector<Weights> krigingWeights(const CoarseToFine &nodes, std::span<const std::array<double, 3>> places);

/// Weights that would have predicted the bands so far: the least squares of sum_j w_j c_j - c over the bands, with a
/// ridge that holds them at `prior` and their sum at 1.
/// \param values   #N x `stride`: the first `bands` of each row are decoded
/// \param ridge    how much a deviation of 1 from the prior counts, in squared steps for each band
/// \param weights  #N: where the result goes
void learnWeights(const CoarseToFine &nodes, std::span<const Weights> prior, std::span<const double> values,
                  std::size_t stride, std::size_t bands, double ridge, std::vector<Weights> &weights);

} // namespace model::codec
