// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/animation/changes.h"

namespace commands {

/// The last frame becomes the first.
class ReverseAnimation final : public ChangeTiming
{
public:
    explicit ReverseAnimation(model::AnimationDocument &document);
};

} // namespace commands
