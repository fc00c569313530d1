// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/compressionsettings.h"
#include "model/animation/framesource.h"
#include "model/base/bytes.h"
#include "model/base/error.h"
#include "model/base/progress.h"

#include <span>
#include <string>
#include <vector>

namespace model::codec {

/// An opened `.anim`. Keeps basis and coefficients, never all frames; positions() computes one frame.
class DecodedAnimation : public FrameSource
{
public:
    virtual const CompressionSettings &settings() const = 0;
    /// The program that wrote the file, e.g. "Sandreel 0.1.0".
    virtual const std::string &creator() const = 0;
    /// Basis trajectories kept, at most as many as were asked for; 0 for a codec without a basis.
    virtual std::uint32_t basisSize() const = 0;
    /// Size of the whole file, bytes.
    virtual std::uint64_t encodedBytes() const = 0;
    /// The chunks as they came, so that renaming and saving loses nothing.
    virtual const Bytes &encoded() const = 0;
    /// How many bytes of the file, from its start, a ProgressiveReader needs to show it with 0, 1, ... basisSize()
    /// basis trajectories; empty for a codec of which only the whole file shows anything.
    virtual std::span<const std::uint64_t> prefixBytes() const { return {}; }
    /// Decodes all that opening has left for later. Where that fails, positions() shows the last frame that could be
    /// decoded instead. \error CorruptStream, Cancelled
    virtual Result<void> check(const Progress &) const { return {}; }
};

/// Size of one chunk of an `.anim`, for `info`.
struct ChunkInfo
{
    std::string tag;
    std::uint64_t bytes = 0; ///< with its frame (tag, length, CRC)
};

/// What the encoder made.
struct EncodedAnimation
{
    Bytes bytes; ///< the whole `.anim` file
    /// For each vertex of the decoded animation the vertex of the input that it is.
    std::vector<std::uint32_t> permutation;
};

/// The codecs that this program has, those of the newest files first. What is offered to a user is taken from here.
std::span<const CodecId> availableCodecs();

/// Whether an animation has the sizes that the format takes. \error NoVertices, NoFrames, LimitExceeded
Result<void> checkSource(const FrameSource &source);

/// Encodes an animation as an `.anim` file. Same input, same bytes, with any number of threads.
/// \error BadSetting     a setting outside its range
/// \error UnknownCodec   a codec that is not one of availableCodecs()
/// \error NonFinite      a position that is not finite
/// \error LimitExceeded  a value too large to be quantised at this resolution
/// \error Cancelled
Result<EncodedAnimation> encodeAnimation(const FrameSource &source, const CompressionSettings &settings,
                                         const Progress &progress = Progress());

/// What decoding may use. The default is safe for files from anywhere.
struct DecodeLimits
{
    /// Most memory of the opened animation, bytes; 0: 64 MiB and 64 bytes for each byte of the file.
    std::uint64_t memoryBytes = 0;

    /// For files that somebody chose to open, and for those that were just written: half of this machine's memory,
    /// where that is more. A good file may be small beside what it holds.
    static DecodeLimits ofThisMachine(std::uint64_t fileSize);

    std::uint64_t bytesFor(std::uint64_t fileSize) const
    {
        return memoryBytes ? memoryBytes : (std::uint64_t(64) << 20) + 64 * fileSize;
    }
};

/// Decodes an `.anim` file from memory. Takes untrusted bytes.
/// \error BadMagic, UnsupportedVersion, Truncated, ChecksumMismatch, MissingChunk, DuplicateChunk, BadValue,
///        UnknownCodec, CorruptStream, TrailingBytes, LimitExceeded, Cancelled; each with its byte offset
Result<std::shared_ptr<const DecodedAnimation>> decodeAnimation(Bytes file, const Progress &progress = Progress(),
                                                                const DecodeLimits &limits = DecodeLimits());

/// The file with another name and frame rate, everything else as it is, bit for bit.
/// Precondition: `file` was made by encodeAnimation or accepted by decodeAnimation.
Result<Bytes> withNameAndRate(const Bytes &file, const std::string &name, double frameRate);

/// The chunks of a file in their order. Errors as decodeAnimation for the container's part.
Result<std::vector<ChunkInfo>> listChunks(std::span<const std::uint8_t> file);

} // namespace model::codec
