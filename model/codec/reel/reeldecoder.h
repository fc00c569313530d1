// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/basis/productanimation.h"
#include "model/codec/connectivity/connectivitystage.h"
#include "model/codec/reel/reelwalk.h"

#include <optional>
#include <vector>

namespace model::codec {

/// Opens a `reel` file chunk by chunk, and the bands as their bytes come. With connectivity and shape it is an
/// animation that moves as a whole; each trajectory that is decoded adds a detail. FORMAT.md 13.
class ReelDecoder
{
public:
    explicit ReelDecoder(Header header);
    ReelDecoder(const ReelDecoder &) = delete;
    ReelDecoder &operator=(const ReelDecoder &) = delete;

    // Each once and in this order, but that readOrder() may come at any time after the connectivity, or never.
    /// \error BadValue, Truncated, TrailingBytes
    Result<void> readParameters(const Chunk &chunk);
    /// \error CorruptStream, LimitExceeded (nothing is changed by it), Cancelled
    Result<void> readConnectivity(const Chunk &chunk, std::uint64_t memoryLimit, const Progress &progress);
    /// \error CorruptStream
    Result<void> readOrder(const Chunk &chunk);
    /// Before the shape, or never. \param next  the chunk of the shape, if it is there already
    /// \error CorruptStream
    Result<void> readClusters(const Chunk &chunk, const std::optional<Chunk> &next = {});
    /// \error CorruptStream, Cancelled
    Result<void> readShape(const Chunk &chunk, const Progress &progress);

    /// Decodes all trajectories that `payload` surely holds. Called again with more of the same bytes, it goes on where
    /// it stopped.
    /// \param offset   of the payload in the file
    /// \param isWhole  nothing will follow
    /// \error CorruptStream, Cancelled
    Result<void> readBands(std::span<const std::uint8_t> payload, std::uint64_t offset, bool isWhole,
                           const Progress &progress);

    const ReelParameters &parameters() const { return mParameters; }
    bool hasShape() const { return mWalk.has_value(); }
    bool hasOrder() const { return mOrder.has_value(); }
    /// Trajectories that are decoded.
    std::uint32_t bandCount() const { return mWalk ? mWalk->done() : 0; }
    /// Bytes that opening takes at most, the file not counted. After the parameters.
    std::uint64_t neededBytes() const;

    /// What is decoded, after the shape. \param container  of `file`, which holds just that
    std::shared_ptr<const DecodedAnimation> animation(Bytes file, const Container &container) const;
    // The payloads of `REEL` and `BAND` of a file that ends after the trajectories decoded so far.
    Bytes parametersSoFar() const;
    /// \param payload  as readBands() had it
    Bytes bandsSoFar(std::span<const std::uint8_t> payload) const;

private:
    // What positions can come to, by shape and means and by each trajectory; false if that may overflow a float.
    bool startBounds();
    bool addLastToBounds();
    std::vector<std::uint64_t> prefixBytes(const Container &container) const;

    const Header mHeader;
    ReelParameters mParameters;
    Connectivity mConnectivity;
    std::vector<VertexNeighbours> mNeighbours;
    std::optional<CoarseToFine> mVertices;
    CoarseToFine mFrames;
    std::optional<std::vector<std::uint32_t>> mOrder; ///< #V: where each coded vertex is shown
    Clusters mClusters;
    std::vector<Point> mPlaces;  ///< #N x 3, in steps
    std::vector<double> mMeans;  ///< #F x 3
    std::vector<double> mBounds; ///< #F x 3; the magnitudes that make up a coordinate, summed
    std::optional<TrajectoryWalk> mWalk;
    std::optional<RangeDecoder> mBands;
    std::optional<RangeDecoder> mAtLastEnd; ///< as it was after the latest whole trajectory
    /// For each whole trajectory how much of the payload must be there for it, bytes; at the end of a stream up to
    /// ImpliedBytes more than there are.
    std::vector<std::uint64_t> mBandEnds;
};

Bytes reelParametersPayload(const ReelParameters &parameters, const Header &header);

} // namespace model::codec
