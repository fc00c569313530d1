// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/animationcodec.h"
#include "model/io/savefile.h"

#include <QString>

namespace model::io {

/// Opens an `.anim` file. \error as codec::decodeAnimation, and NotFound, CannotOpen, CannotRead
Result<std::shared_ptr<const codec::DecodedAnimation>> openAnim(const QString &path,
                                                                const Progress &progress = Progress());

/// A whole file. \error NotFound, CannotOpen, CannotRead, LimitExceeded, OutOfMemory, Cancelled
Result<Bytes> readBytes(const QString &path, const Progress &progress = Progress());

/// The `.anim` bytes of an edited animation: an opened one of which only name or rate changed keeps its stream bit for
/// bit; everything else is encoded.
/// Errors as codec::encodeAnimation.
Result<codec::EncodedAnimation> encodeEdited(const FrameSource &frames, const CompressionSettings &settings,
                                             const Progress &progress = Progress());

} // namespace model::io
