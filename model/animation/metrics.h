// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/base/error.h"
#include "model/base/progress.h"

#include <span>
#include <vector>

namespace model {

/// The error of one frame; lengths in the animation's units.
struct FrameError
{
    double kgErrorPercent = 0;
    double rmse = 0;
    double maxVertexError = 0;
    std::uint32_t worstVertex = 0; ///< index in the reference
};

/// What was lost between a reference animation and a test animation.
struct ComparisonResult
{
    /// 100 * ||v - w|| / ||v - m||, Frobenius norms over all frames, m the reference's mean over the vertices of each
    /// frame (not over time), 1 where the denominator is 0. Source: Karni and Gotsman 2004, as its authors compute it.
    double kgErrorPercent = 0;
    /// Root of the mean squared vertex distance over all vertices and frames.
    double rmse = 0;
    /// 20 log10(D / RMSE), D the diagonal of the reference's box over all frames; infinite for equal animations.
    double psnrDb = 0;
    double maxVertexError = 0;
    std::uint32_t worstFrame = 0;
    std::uint32_t worstVertex = 0; ///< index in the reference
    double diagonal = 0;           ///< D above
    std::vector<FrameError> frames;
};

/// Compares frame by frame, in double, on several threads; the result does not depend on their number.
///
/// \param permutation  for each vertex of `test` the vertex of `reference` that it is; empty: the same order
/// \error MeshesDiffer    frame or vertex counts differ
/// \error BadPermutation  not a permutation of the vertices
/// \error Cancelled
Result<ComparisonResult> compareAnimations(const FrameSource &reference, const FrameSource &test,
                                           std::span<const std::uint32_t> permutation = {},
                                           const Progress &progress = Progress());

} // namespace model
