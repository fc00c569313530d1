// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/sequence.h"
#include "model/base/error.h"
#include "model/base/progress.h"

#include <QString>
#include <QStringList>

namespace model::io {

/// "frame 2" before "frame 10": runs of digits compare as numbers, letters without regard to case; then, so that the
/// order is total, as texts.
bool isNaturallyLess(const QString &a, const QString &b);

/// Reads mesh files as the frames of one animation, in parallel, one file per thread in memory.
/// \param files  at least one, all of one kind
/// \error the one of the first frame at fault, whatever the threads do: as FirstFrame and FileBuffer, naming the file;
///        Cancelled, LimitExceeded, OutOfMemory
Result<std::shared_ptr<const Sequence>> readFrames(const QStringList &files, double frameRate, std::string name,
                                                   const Progress &progress);

} // namespace model::io
