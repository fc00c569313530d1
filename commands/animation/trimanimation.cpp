// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/animation/trimanimation.h"

#include <QCoreApplication>

namespace commands {

namespace {

// With a sum as the number, lupdate 6.4 never ends.
QString trimText(int frames)
{
    return QCoreApplication::translate("Undo", "Trim to %n Frame(s)", nullptr, frames);
}

} // namespace

TrimAnimation::TrimAnimation(model::AnimationDocument &document, std::uint32_t first, std::uint32_t last)
    : ChangeTiming(document, trimText(int(last - first + 1)),
                   {document.timing().map.trimmed(first, last), document.timing().frameRate})
{}

} // namespace commands
