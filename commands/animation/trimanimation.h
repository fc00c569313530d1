// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/animation/changes.h"

namespace commands {

/// Keeps the frames first..last (both included) of the animation as it is now.
class TrimAnimation final : public ChangeTiming
{
public:
    /// Precondition: first <= last < document.frameCount().
    TrimAnimation(model::AnimationDocument &document, std::uint32_t first, std::uint32_t last);
};

} // namespace commands
