// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/animation/changes.h"

namespace commands {

/// Gives the animation another name.
class RenameAnimation final : public ChangeName
{
public:
    /// \param name  UTF-8; may be empty
    RenameAnimation(model::AnimationDocument &document, std::string name);
};

} // namespace commands
