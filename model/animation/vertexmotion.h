// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framepair.h"
#include "model/base/progress.h"

namespace model {

// Numbers of each vertex over a whole animation, to be shown as colours.

/// How far each vertex goes from the first frame to the last, along its way. #V. \error Cancelled
Result<std::vector<float>> trajectoryLengths(const FrameSource &source, const Progress &progress = Progress());

/// The root mean square over all frames of each vertex's distance from where it should be. #V, in the order of the
/// reference. \error Cancelled
Result<std::vector<float>> vertexErrors(const FramePair &pair, const Progress &progress = Progress());

} // namespace model
