// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/animationcodec.h"
#include "model/io/savefile.h"

#include <QString>

namespace model::io {

/// Opens an `.anim` file. \error as codec::decodeAnimation, and NotFound, CannotOpen, CannotRead
Result<std::shared_ptr<const codec::DecodedAnimation>> openAnim(const QString &path,
                                                                const Progress &progress = Progress());

/// What the beginning of an `.anim` file shows.
struct AnimPrefix
{
    std::shared_ptr<const codec::DecodedAnimation> animation;
    std::uint32_t bandsInFile = 0; ///< of `reel`: trajectories of the whole file; the animation has the first of them
    std::uint64_t bytes = 0;       ///< that were read
    std::uint64_t fileBytes = 0;   ///< that the whole file has: those there, or more by what it says of itself
};

/// Opens what the first `byteCount` bytes of an `.anim` file hold, or all that are there.
/// \error as openAnim; of what is not whole, only a `reel` file with connectivity and shape can be opened. Truncated:
///        how many bytes are needed (at least, if the file ends before), how many of them are there
Result<AnimPrefix> openAnimPrefix(const QString &path, std::uint64_t byteCount, const Progress &progress = Progress());

/// A whole file. \error NotFound, CannotOpen, CannotRead, LimitExceeded, OutOfMemory, Cancelled
Result<Bytes> readBytes(const QString &path, const Progress &progress = Progress());

/// The `.anim` bytes of an edited animation: an opened one of which only name or rate changed keeps its stream bit for
/// bit; everything else is encoded.
/// Errors as codec::encodeAnimation.
Result<codec::EncodedAnimation> encodeEdited(const FrameSource &frames, const CompressionSettings &settings,
                                             const Progress &progress = Progress());

} // namespace model::io
