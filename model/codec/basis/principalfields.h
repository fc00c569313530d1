// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/base/error.h"
#include "model/base/progress.h"

namespace model::codec {

/// What each of the strongest trajectories does at each vertex, and how much of the animation it is.
struct PrincipalFields
{
    std::vector<std::vector<float>> coefficients; ///< of each trajectory, #V, in the animation's units
    std::vector<double> energyShares;             ///< of each: 0..1 of the squared distances from the row means
};

/// \param count  how many at most; fewer where the animation has no more
/// \error NonFinite, OutOfMemory, Cancelled
Result<PrincipalFields> principalFields(const FrameSource &source, std::size_t count,
                                        const Progress &progress = Progress());

} // namespace model::codec
