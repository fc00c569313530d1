// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/animation/changes.h"

namespace commands {

/// The same frames, played faster or slower.
class SetFrameRate final : public ChangeTiming
{
public:
    /// \param rate  frames per second, above zero
    SetFrameRate(model::AnimationDocument &document, double rate, GestureId gesture = NoGesture);
};

} // namespace commands
