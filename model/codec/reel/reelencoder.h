// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/compressionsettings.h"
#include "model/codec/connectivity/connectivitystage.h"
#include "model/codec/reel/bandcoder.h"
#include "model/codec/reel/reelstream.h"
#include "model/codec/reel/trajectories.h"

#include <vector>

namespace model::codec {

/// What the encoder of `reel` decided for some settings: everything that the streams hold.
struct ReelChoice
{
    ReelParameters parameters;
    std::vector<std::int32_t> shape;         ///< #N x 3 residuals
    std::vector<std::int32_t> means;         ///< 3 x #F residuals, in the order of the frames' nodes
    std::vector<std::int32_t> stepExponents; ///< #K
    std::vector<std::int32_t> basis;         ///< #K x 3 x #F residuals
    std::vector<std::int32_t> coefficients;  ///< #K x #N residuals
    double squaredError = 0;                 ///< of all vertices in all frames, as a decoder will have them
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
    const CoarseToFine &vertexNodes() const { return mVertexNodes; }
    const CoarseToFine &frameNodes() const { return mFrameNodes; }
    /// Sum of the squares of S minus its row means.
    double energy() const { return mTrajectories.energy(); }

private:
    ReelEncoder(Trajectories trajectories, EncodedConnectivity connectivity, CoarseToFine vertexNodes,
                std::uint32_t frameCount);

    std::uint32_t inputVertex(std::size_t node) const { return mConnectivity.permutation[mVertexNodes.vertices[node]]; }
    double meanMotion() const;
    Result<std::size_t> basisSizeFor(const ReelSettings &settings, double step, const Progress &progress);
    bool chooseShape(ReelChoice &choice, Eigen::MatrixXd &decoded, std::vector<Point> &places,
                     const Progress &progress) const;
    /// \param left  #3F: to be added to the means
    bool chooseMeans(ReelChoice &choice, const Eigen::VectorXd &left) const;
    bool chooseBasis(ReelChoice &choice, const Eigen::MatrixXd &wanted, Eigen::MatrixXd &decoded) const;
    bool chooseCoefficients(ReelChoice &choice, const Eigen::MatrixXd &wanted, std::vector<Weights> weights,
                            Eigen::MatrixXd &decoded, const Progress &progress) const;

    Trajectories mTrajectories;
    EncodedConnectivity mConnectivity;
    CoarseToFine mVertexNodes;
    CoarseToFine mFrameNodes;
};

} // namespace model::codec
