// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/base/error.h"
#include "model/base/progress.h"

#include <span>
#include <vector>

namespace model {

/// The two parts of the error of one frame: means over the vertices.
struct FrameSted
{
    double spatial = 0;
    double temporal = 0; ///< of the step to this frame; 0 for the first
};

/// The spatio-temporal edge difference: what of the difference people see. Shapes that move along with the surface
/// count for nothing, uneven stretching and trembling do. Scale-free.
///
/// v is the reference, w the test, V vertices, F frames; e = (a, b) are the edges of the reference, each once.
///
///   spatial, for each frame f:  l_e = |v_b - v_a|, l'_e the same of w, d_e = (l_e - l'_e) / l_e (0 if l_e = 0)
///     N(i)  = the edges at vertex i and at each of its neighbours
///     mu_i  = sum d_e l_e / sum l_e,  dev_i = sqrt(sum l_e (d_e - mu_i)^2 / sum l_e)  over N(i); 0 if the sum is 0
///     S     = 1/(V F) * sum dev
///   temporal, D the largest distance of two vertices in the reference's first frame, t = 0.0003:
///     s_if  = sqrt(|v_i,f-1 - v_if|^2 / D^2 + t^2), s' the same of w, f = 1..F-1; D counts as 1 if it is 0
///     a_if  = mean of s_ig over g = max(1, f-4) .. min(F-1, f+5)
///     T     = 1/(V (F-1)) * sum |s' - s| / a; 0 for a single frame
///   STED = sqrt(S^2 + c^2 T^2), c = 9.144e-5
///
/// With the authors' c the temporal part hardly shows in the sum: look at both.
/// Source: L. Vasa, V. Skala, A perception correlated comparison method for dynamic meshes, 2011, with the constants
/// and the window of the authors' program.
struct StedResult
{
    double sted = 0;
    double spatial = 0;
    double temporal = 0;
    std::vector<FrameSted> frames;
};

/// In double, on several threads, holding a few frames at a time; the result does not depend on the number of either.
/// Cost: O(F * sum |N(i)|), about 30 edges a vertex of an even mesh.
///
/// \param permutation  as for compareAnimations(), whose errors these are
/// \error MeshesDiffer, BadPermutation, Cancelled
Result<StedResult> spatioTemporalDifference(const FrameSource &reference, const FrameSource &test,
                                            std::span<const std::uint32_t> permutation = {},
                                            const Progress &progress = Progress());

} // namespace model
