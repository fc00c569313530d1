// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/animation/setcompression.h"

#include <QCoreApplication>
#include <QLocale>

namespace commands {

namespace {

QString textFor(const model::CompressionSettings &present, const model::CompressionSettings &wanted)
{
    model::CompressionSettings basisAlone = present;
    basisAlone.basisSize = wanted.basisSize;
    if (wanted == basisAlone)
        return QCoreApplication::translate("Undo", "Set Basis Size to %1").arg(QLocale().toString(wanted.basisSize));
    model::CompressionSettings resolutionAlone = present;
    resolutionAlone.resolution = wanted.resolution;
    if (wanted == resolutionAlone)
        return QCoreApplication::translate("Undo", "Set Resolution to %1").arg(QLocale().toString(wanted.resolution));
    return QCoreApplication::translate("Undo", "Change Compression");
}

} // namespace

SetCompression::SetCompression(model::AnimationDocument &document, const model::CompressionSettings &settings,
                               GestureId gesture)
    : ChangeCompression(document, textFor(document.compression(), settings), settings, MergeId::SetCompression, gesture)
{}

} // namespace commands
