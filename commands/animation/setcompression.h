// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/animation/changes.h"

namespace commands {

/// Sets how the animation will be compressed when it is saved.
class SetCompression final : public ChangeCompression
{
public:
    /// \param settings  each within its range
    SetCompression(model::AnimationDocument &document, const model::CompressionSettings &settings,
                   GestureId gesture = NoGesture);
};

} // namespace commands
