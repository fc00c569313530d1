// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/animation/changes.h"

namespace commands {

/// Another frame rate at the same speed: the number of frames changes, see model::TimeMap::resampled().
class ResampleAnimation final : public ChangeTiming
{
public:
    /// \param rate  frames per second, above zero, such that TimeMap::resampledFrameCount() is at most
    ///              TimeMap::MaxFrameCount
    ResampleAnimation(model::AnimationDocument &document, double rate);
};

} // namespace commands
