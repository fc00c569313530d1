// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/framestack.h"

#include <Eigen/Core>

#include <span>

namespace model::codec {

/// Above this a Gram matrix (8 n^2 bytes, n^2 V operations) is not written down: each step of the eigensolver then
/// goes through the animation itself.
inline constexpr std::size_t MaxGramRows = 3000;

/// S S^T if S (3F x V, minus `means`) has at most as many rows as columns, else S^T S. \error Cancelled
Result<Eigen::MatrixXd> gramMatrix(const FrameStack &frames, std::span<const double> means, const Progress &progress);

/// out = S S^T in, without S S^T. Ends early, with anything in `out`, once the work is cancelled.
void applyGram(const FrameStack &frames, std::span<const double> means, const Eigen::VectorXd &in, Eigen::VectorXd &out,
               const Progress &progress);

} // namespace model::codec
