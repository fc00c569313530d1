// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/animation/renameanimation.h"

#include <QCoreApplication>

namespace commands {

RenameAnimation::RenameAnimation(model::AnimationDocument &document, std::string name)
    : ChangeName(document, QCoreApplication::translate("Undo", "Rename Animation"), std::move(name))
{}

} // namespace commands
