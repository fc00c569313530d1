// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"
#include "model/base/progress.h"
#include "model/codec/direct/prediction.h"

#include <memory>

namespace model::codec {

/// What the frames of a file have in common. FORMAT.md 11.1.
struct FrameShape
{
    std::uint32_t resolution = 1; ///< every coordinate is below it
    Predictor predictor = Predictor::None;
    Entropy entropy = Entropy::Range;
};

/// A group of frames as one stream; without loss. The first one is predicted from `reference`, or from nothing if that
/// is empty, the others from those before it in the group.
/// \param frames  each #V; all coordinates below the resolution
/// \returns       nothing if the work was cancelled
Bytes encodeFrames(const FrameShape &shape, const MeshWalk &walk, std::span<const Cell> reference,
                   std::span<const std::span<const Cell>> frames, const Progress &progress);

/// Mirrors encodeFrames, a frame at a time. Takes any bytes.
class FrameDecoder
{
public:
    /// All arguments must outlive this.
    FrameDecoder(const FrameShape &shape, const MeshWalk &walk, std::span<const Cell> reference,
                 std::span<const std::uint8_t> stream);
    ~FrameDecoder();

    /// Decodes the next frame from those before it, newest first, of this group.
    /// \param now  #V; after an error partly filled, every coordinate below the resolution all the same
    /// \returns    false if the stream is corrupt
    bool next(std::span<const Cell> last, std::span<const Cell> second, std::span<const Cell> third,
              std::span<Cell> now);
    /// True if the stream ends with the frame that was decoded last.
    bool isAtEnd();

    /// Bytes that one of them holds, for V vertices.
    static std::uint64_t neededBytes(Entropy entropy, std::uint64_t vertices);

private:
    class Impl;
    std::unique_ptr<Impl> mImpl;
};

} // namespace model::codec
