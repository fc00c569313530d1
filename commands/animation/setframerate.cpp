// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/animation/setframerate.h"

#include <QCoreApplication>
#include <QLocale>

namespace commands {

SetFrameRate::SetFrameRate(model::AnimationDocument &document, double rate, GestureId gesture)
    : ChangeTiming(document, QCoreApplication::translate("Undo", "Play at %1 fps").arg(QLocale().toString(rate)),
                   {document.timing().map, rate}, MergeId::SetFrameRate, gesture)
{}

} // namespace commands
