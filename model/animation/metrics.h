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
    double daError = 0;
    double rmse = 0;
    double maxVertexError = 0;
    std::uint32_t worstVertex = 0; ///< index in the reference
};

/// What was lost between a reference animation and a test animation, vertex by vertex. Notation: v the reference, w the
/// test, V vertices, F frames, D the diagonal of the reference's box over all frames. What the eye makes of it is
/// measured in sted.h, the distance of the surfaces in hausdorff.h.
struct ComparisonResult
{
    /// 100 * ||v - w|| / ||v - m||, Frobenius norms over all frames, m the reference's mean over the vertices of each
    /// frame (not over time), 1 where the denominator is 0. Source: Karni and Gotsman 2004, as its authors compute it.
    double kgErrorPercent = 0;
    /// 1/(F V D) * sum |v - w|: the mean vertex distance as a share of D, 1 where D is 0; a ratio, not per cent.
    /// Source: Jang and others 2004 (the distortion of their trajectories, as the papers on dynamic meshes after them
    /// compute it). Differs: D is that of all frames, not of each.
    double daError = 0;
    /// sqrt(1/(F V) * sum |v - w|^2), in the animation's units, as maxVertexError.
    double rmse = 0;
    /// 20 log10(D / RMSE); infinite for equal animations.
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
