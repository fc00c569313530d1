// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/framestack.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace model::codec {

/// What the encoder of `reel` knows about an animation, before any step is chosen: the mean vertex of each frame, the
/// rest shape (each vertex's mean over the frames, relative to the mean vertices), and the principal trajectories of
/// what moves. Computed once for many trials.
class Trajectories
{
public:
    /// \param frames  outlives the result
    /// \param means   of all vertices, where `frames` has only some of them: #3F. \error Cancelled
    static Result<Trajectories> of(const FrameStack &frames, std::vector<double> means, const Progress &progress);

    const std::vector<double> &means() const { return mMeans; } ///< #3F
    /// Rest shape times sqrt(F), so that it weighs as the coefficients of an orthonormal basis do: 3 x #V.
    const Eigen::MatrixXd &shape() const { return mShape; }
    /// Sum of the squares of S minus its row means.
    double energy() const { return mEnergy; }

    /// Principal trajectories, orthonormal, strongest first: #3F x at least `count`, unless there are no more.
    /// \error Cancelled
    Result<void> find(std::size_t count, const Progress &progress);
    const Eigen::MatrixXd &basis() const { return mBasis; }
    /// Root mean square over the vertices of each one's coefficients.
    const std::vector<double> &strengths() const { return mStrengths; }
    bool hasAll() const { return mHasAll; }

    /// basis^T (S - means - shape): what `basis` has of the motion about a rest shape; as #K x #V.
    /// \param shape  as shape(), the decoder's. \error Cancelled
    Result<Eigen::MatrixXd> project(const Eigen::MatrixXd &basis, const Eigen::MatrixXd &shape,
                                    const Progress &progress) const;
    /// (S - means - shape) coefficients^T: #3F x #K. \param coefficients  #K x #V. \error Cancelled
    Result<Eigen::MatrixXd> correlate(const Eigen::MatrixXd &coefficients, const Eigen::MatrixXd &shape,
                                      const Progress &progress) const;
    /// Sum of the squares of S - means - shape.
    double energyAbout(const Eigen::MatrixXd &shape) const;

private:
    explicit Trajectories(const FrameStack &frames)
        : mFrames(&frames)
    {}
    Result<void> findGram(const Progress &progress);
    /// The strongest trajectories of an animation whose Gram matrix is too large.
    Result<Eigen::MatrixXd> findByBlocks(std::size_t count, const Progress &progress) const;

    const FrameStack *mFrames;
    std::vector<double> mMeans;
    Eigen::MatrixXd mShape;
    double mEnergy = 0;
    Eigen::MatrixXd mGram; ///< of the smaller side, about the rest shape; empty if both are large
    bool mByVertices = false;
    Eigen::MatrixXd mBasis;
    std::vector<double> mStrengths;
    bool mHasAll = false;
};

} // namespace model::codec
