// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/animationcodec.h"
#include "model/codec/container/container.h"

#include <array>
#include <memory>
#include <optional>

namespace model::codec {

class ReelDecoder;

/// Opens an `.anim` file while its bytes come, in pieces of any size. Of a `reel` file the beginning can be shown: once
/// connectivity and shape are there, an animation that moves as a whole, then with one basis trajectory after another.
/// Files of other codecs show when they are complete.
///
/// Each byte is decoded once: all pieces together take the work of decodeAnimation(), at any size of the pieces, and
/// what is shown depends on the bytes alone, not on how they were cut. No threads of its own, no files.
class ProgressiveReader
{
public:
    explicit ProgressiveReader(const DecodeLimits &limits = DecodeLimits());
    ~ProgressiveReader();

    /// Takes the next bytes of the file and decodes what they complete. After an error there is nothing more to show,
    /// and the same error comes again; what was handed out goes on to work. \error as decodeAnimation(), but Truncated,
    /// as soon as the bytes tell. The trajectories of `reel` have one
    ///        checksum, at their end: damage shows only there, or as CorruptStream before. Too little memory is an
    ///        error once no further byte can raise the limit.
    Result<void> append(std::span<const std::uint8_t> piece, const Progress &progress = Progress());

    std::uint64_t bytesRead() const { return mBytesRead; }
    /// Bytes that the file has at least, as far as its chunks tell; those of a `reel` file once its bands have begun.
    std::uint64_t leastBytes() const { return mComplete ? mBytesRead : mFile.leastBytes(); }
    /// Bytes from which on there is something to show: exact once they are there, at least so many before.
    std::uint64_t playableFrom() const;
    /// Null until it is known.
    const Header *header() const { return mFile.header(); }
    /// Whether animation() has something to show.
    bool isPlayable() const;
    /// Basis trajectories that are decoded, and how many the file has; 0 while that is not known, and for codecs that
    /// are not `reel`.
    std::uint32_t bandCount() const;
    std::uint32_t bandsInFile() const;
    /// The file has ended, and every byte of it was good.
    bool isComplete() const { return mComplete && !mError; }

    /// What is there, null while nothing can be shown. One that is incomplete is the animation of a shorter file, which
    /// its encoded() gives: saving it keeps what is seen. The complete one is what decodeAnimation() gives.
    /// Cost: copies the coefficients when there are new ones, else none.
    std::shared_ptr<const DecodedAnimation> animation();

private:
    /// The chunks of a `reel` file.
    enum Part { Parameters, Triangles, Order, ClusterLabels, Shape, Bands, PartCount };

    Result<void> read(std::span<const std::uint8_t> piece, const Progress &progress);
    Result<void> sortChunks();
    Result<void> readReel(const Progress &progress);
    Result<void> readConnectivity(const Progress &progress);
    Result<std::shared_ptr<const DecodedAnimation>> complete(const Progress &progress);
    Bytes fileSoFar() const;
    bool isReel() const;
    bool has(Part part) const { return mParts[part].has_value(); }
    Chunk chunk(Part part) const { return mFile.chunk(*mParts[part]); }

    const DecodeLimits mLimits;
    std::uint64_t mBytesRead = 0;
    ContainerReader mFile;
    std::size_t mSorted = 0; ///< chunks that mParts knows of
    std::array<std::optional<std::size_t>, PartCount> mParts;
    std::unique_ptr<ReelDecoder> mReel;
    bool mHasConnectivity = false;
    bool mHasClusters = false;
    bool mWaitsForEnd = false; ///< the connectivity takes more memory than its bytes allow
    std::shared_ptr<const DecodedAnimation> mShown;
    bool mShownIsWhole = false; ///< has all bands
    std::shared_ptr<const DecodedAnimation> mComplete;
    std::optional<Error> mError;
};

} // namespace model::codec
