// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/animation/setcompression.h"

#include <QCoreApplication>

namespace commands {

SetCompression::SetCompression(model::AnimationDocument &document, const model::CompressionSettings &settings,
                               GestureId gesture)
    : ChangeCompression(document, QCoreApplication::translate("Undo", "Change Compression"), settings,
                        MergeId::SetCompression, gesture)
{}

} // namespace commands
