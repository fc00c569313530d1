// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/animationcodec.h"

#include <QString>

class QSaveFile;

namespace model::io {

/// Opens an `.anim` file. \error as codec::decodeAnimation, and NotFound, CannotOpen, CannotRead
Result<std::shared_ptr<const codec::DecodedAnimation>> openAnim(const QString &path,
                                                                const Progress &progress = Progress());

/// Writes bytes through QSaveFile: all or nothing, an existing file stays until all bytes are on disk.
/// \error CannotOpen, CannotWrite
Result<void> saveBytes(const QString &path, std::span<const std::uint8_t> bytes);

/// Opens a file that saving will replace. Folders, devices and pipes are refused: a QSaveFile would put an ordinary
/// file in the place of a device. \error CannotOpen
Result<void> openForSaving(QSaveFile &file);

/// A whole file. \error NotFound, CannotOpen, CannotRead, LimitExceeded
Result<Bytes> readBytes(const QString &path);

/// The `.anim` bytes of an edited animation: an opened one of which only name or rate changed keeps its stream bit for
/// bit; everything else is encoded.
/// Errors as codec::encodeAnimation.
Result<codec::EncodedAnimation> encodeEdited(const FrameSource &frames, const CompressionSettings &settings,
                                             const Progress &progress = Progress());

} // namespace model::io
