// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/compressionsettings.h"
#include "model/codec/connectivity/connectivitystage.h"
#include "model/codec/reel/bandcoder.h"
#include "model/codec/reel/clusters.h"
#include "model/codec/reel/reelstream.h"
#include "model/codec/reel/trajectories.h"

#include <memory>
#include <vector>

namespace model::codec {

/// What the encoder of `reel` decided for some settings: everything that the streams hold.
struct ReelChoice
{
    ReelParameters parameters;
    std::vector<std::int32_t> shape; ///< #N x 3 residuals
    std::vector<std::int32_t> means; ///< 3 x #F residuals, in the order of the frames' nodes
    Clusters clusters;
    std::vector<std::uint32_t> labels;       ///< #K: the cluster of each trajectory
    std::vector<std::int32_t> stepExponents; ///< #K
    std::vector<std::int32_t> basis;         ///< #K x 3 x #F residuals
    std::vector<std::int32_t> coefficients;  ///< the residuals of each trajectory's cluster, one after another
    double squaredError = 0;                 ///< of all vertices in all frames, as a decoder will have them
    double bits = 0;                         ///< of trajectories and coefficients, nearly
};

/// Chooses residuals so that a bit buys as little error as possible, for any number of settings over one animation.
class ReelEncoder
{
public:
    /// \param frames        outlives the encoder
    /// \param connectivity  of the coded mesh
    /// \error Cancelled
    static Result<ReelEncoder> prepare(const FrameStack &frames, EncodedConnectivity connectivity,
                                       const Progress &progress);
    ReelEncoder(ReelEncoder &&) noexcept;
    ~ReelEncoder(); // where Eigen allocates as the analysis does

    /// \error LimitExceeded  a value too large for its step
    /// \error Cancelled
    Result<ReelChoice> choose(const ReelSettings &settings, const Progress &progress);

    const EncodedConnectivity &connectivity() const { return mConnectivity; }
    const CoarseToFine &vertexNodes() const { return mWhole.nodes; }
    const CoarseToFine &frameNodes() const { return mFrameNodes; }
    /// Sum of the squares of S minus its row means.
    double energy() const { return mWhole.trajectories.energy(); }

private:
    /// The vertices of a cluster with trajectories of their own.
    struct Part
    {
        std::vector<std::uint32_t> members; ///< their nodes in the animation
        std::vector<std::uint32_t> columns; ///< of `frames`
        CoarseToFine nodes;
        std::unique_ptr<FrameStack> frames; ///< none: all of the animation's
        Trajectories trajectories;
    };

    ReelEncoder(const FrameStack &frames, Trajectories trajectories, EncodedConnectivity connectivity,
                CoarseToFine vertexNodes);

    std::uint32_t inputVertex(std::size_t node) const { return mConnectivity.permutation[mWhole.nodes.vertices[node]]; }
    const Trajectories &trajectories() const { return mWhole.trajectories; }
    double meanMotion() const;
    double stepOf(const ReelSettings &settings) const;
    Result<Clusters> findClusters(const ReelChoice &whole, const Progress &progress) const;
    Result<void> split(const Clusters &clusters, const Progress &progress);
    Result<ReelChoice> chooseFor(std::span<Part *const> parts, const Clusters &clusters, const ReelSettings &settings,
                                 const Progress &progress);
    bool chooseShape(ReelChoice &choice, Eigen::MatrixXd &decoded, std::vector<Point> &places,
                     const Progress &progress) const;
    /// \param left  #3F: to be added to the means
    bool chooseMeans(ReelChoice &choice, const Eigen::VectorXd &left) const;
    /// \param wanted  #3F x #K. \returns  bits; a negative number: a value is too large
    double chooseBasis(ReelChoice &choice, const Eigen::MatrixXd &wanted, Eigen::MatrixXd &decoded,
                       const Progress &progress) const;
    /// \param wanted  of each part its trajectories x its columns. \returns  as chooseBasis()
    double chooseCoefficients(ReelChoice &choice, std::span<Part *const> parts, std::span<const Eigen::MatrixXd> wanted,
                              const std::vector<Point> &places, std::vector<Eigen::MatrixXd> &decoded,
                              const Progress &progress) const;

    const FrameStack *mFrames;
    EncodedConnectivity mConnectivity;
    CoarseToFine mFrameNodes;
    Part mWhole;
    std::vector<std::uint32_t> mComponents; ///< of the nodes
    std::vector<Part> mParts;               ///< of mPartLabels
    std::vector<std::uint32_t> mPartLabels;
};

} // namespace model::codec
