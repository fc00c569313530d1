// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/animation/reverseanimation.h"

#include <QCoreApplication>

namespace commands {

ReverseAnimation::ReverseAnimation(model::AnimationDocument &document)
    : ChangeTiming(document, QCoreApplication::translate("Undo", "Reverse Animation"),
                   {document.timing().map.reversed(), document.timing().frameRate})
{}

} // namespace commands
