// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/animation/resampleanimation.h"

#include <QCoreApplication>
#include <QLocale>

namespace commands {

ResampleAnimation::ResampleAnimation(model::AnimationDocument &document, double rate)
    : ChangeTiming(document, QCoreApplication::translate("Undo", "Resample to %1 fps").arg(QLocale().toString(rate)),
                   {document.timing().map.resampled(document.timing().frameRate, rate), rate})
{}

} // namespace commands
