// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/animation/normaliseanimation.h"

#include <QCoreApplication>

namespace commands {

NormaliseAnimation::NormaliseAnimation(model::AnimationDocument &document, const model::Similarity &placement)
    : ChangePlacement(document,
                      placement.isIdentity() ? QCoreApplication::translate("Undo", "Remove Normalisation")
                                             : QCoreApplication::translate("Undo", "Normalise Animation"),
                      placement)
{}

} // namespace commands
