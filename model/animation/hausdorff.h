// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/base/error.h"
#include "model/base/progress.h"

#include <span>
#include <vector>

namespace model {

/// The distance of the surfaces of one frame, in the animation's units.
struct FrameHausdorff
{
    double fromReference = 0; ///< the farthest that a sample of the reference is from the test's surface
    double fromTest = 0;      ///< the same the other way

    double distance() const { return fromReference > fromTest ? fromReference : fromTest; }
};

/// How far the surfaces are from each other, whichever vertices they have: max over the points p of one surface of the
/// distance from p to the other surface, in both directions, over samples. Never above the largest vertex error.
struct HausdorffResult
{
    double distance = 0; ///< the larger of the two below
    double fromReference = 0;
    double fromTest = 0;
    std::uint32_t worstFrame = 0;
    std::vector<FrameHausdorff> frames;
};

/// Samples of a surface per triangle, on average: in proportion to the area, whatever the triangles' sizes. That of
/// METRO. On top come all vertices, and samples of the edges as dense as those of the area.
constexpr double DefaultSurfaceSamples = 10;
constexpr double MaxSurfaceSamples = 10000;

/// In double, on several threads, a frame at a time each. Samples are placed by a rule, not at random: the same result
/// each time. A vertex without triangles is a part of the surface.
///
/// Samples that cannot raise the maximum are not looked into: a triangle moves no farther than its worst corner. Thus
/// the cost hardly depends on the density, and grows with the differences that are not movements along the surface.
///
/// \param permutation         as for compareAnimations(), whose errors these are
/// \param samplesPerTriangle  0..MaxSurfaceSamples; 0 leaves vertices only
/// \error MeshesDiffer, BadPermutation, Cancelled
/// Source: P. Cignoni, C. Rocchini, R. Scopigno, Metro: measuring error on simplified surfaces, 1998. Differs: samples
/// by rule; only the maximum, no mean over the surface.
Result<HausdorffResult> hausdorffDistance(const FrameSource &reference, const FrameSource &test,
                                          std::span<const std::uint32_t> permutation = {},
                                          double samplesPerTriangle = DefaultSurfaceSamples,
                                          const Progress &progress = Progress());

} // namespace model
