// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/reel/clusters.h"
#include "model/codec/reel/reelstream.h"

namespace model::codec {

// The order in which `SHAP` and `BAND` are coded, once for both sides. FORMAT.md 13.6, 13.7.

struct ReelNodes
{
    const CoarseToFine &vertices;
    const CoarseToFine &frames;
};

/// The rest shape, then the mean vertices. FORMAT.md 13.6.
/// \param shapeResiduals, meanResiduals  as ShapeCoder and BandCoder ask for them
/// \param means   #F x 3, in the animation's unit
/// \param goOn    false: stop
/// \returns       false if it was stopped
template <class ShapeResiduals, class MeanResiduals, class GoOn>
bool codeShape(ShapeResiduals &&shapeResiduals, MeanResiduals &&meanResiduals, const ReelNodes &nodes,
               const ReelParameters &p, std::vector<Point> &places, std::vector<double> &means, GoOn &&goOn)
{
    ShapeCoder shape(nodes.vertices, levelRatio(p.shapeRatio));
    if (!shape.codeAll(shapeResiduals, goOn))
        return false;
    places = shape.places();

    BandModel learned;
    BandCoder bands(nodes.frames, krigingWeights(nodes.frames, framePlaces(nodes.frames)),
                    {3, levelRatio(p.basisRatio), TimeRidge}, learned);
    means.resize(3 * nodes.frames.size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!goOn())
            return false;
        bands.nextBand(meanResiduals);
        for (std::size_t node = 0; node < nodes.frames.size(); ++node)
            means[3 * nodes.frames.vertices[node] + axis] =
                double(p.origin[axis]) + bands.value(node, axis) * meanStep(p);
    }
    return goOn();
}

/// What comes before the bands of a trajectory.
struct TrajectoryStart
{
    std::uint32_t cluster = 0;
    std::int32_t stepExponent = 0;
};
template <class Coder>
TrajectoryStart codeStart(Coder &coder, ClusterLabelCoder &labels, StepCoder &steps, const TrajectoryStart &start = {})
{
    const std::uint32_t cluster = labels.code(coder, start.cluster);
    return {cluster, steps.code(coder, start.stepExponent)};
}

/// The vertices of each cluster as nodes of their own.
class ReelParts
{
public:
    /// Keeps a view of `nodes`.
    ReelParts(const CoarseToFine &nodes, const Clusters &clusters)
        : mAll(nodes)
        , mMembers(nodesOf(clusters, componentsOf(nodes)))
    {
        for (std::size_t part = 0; mMembers.size() > 1 && part < mMembers.size(); ++part)
            mNodes.push_back(restrictedTo(nodes, mMembers[part]));
    }

    std::size_t count() const { return mMembers.size(); }
    /// Where its nodes are among all.
    const std::vector<std::uint32_t> &members(std::size_t part) const { return mMembers[part]; }
    const CoarseToFine &nodes(std::size_t part) const { return mNodes.empty() ? mAll : mNodes[part]; }
    std::vector<Point> placesOf(std::size_t part, const std::vector<Point> &places) const
    {
        std::vector<Point> own;
        for (const std::uint32_t node : mMembers[part])
            own.push_back(places[node]);
        return own;
    }

private:
    const CoarseToFine &mAll;
    std::vector<std::vector<std::uint32_t>> mMembers;
    std::vector<CoarseToFine> mNodes; ///< of several parts
};

/// Trajectory after trajectory, each followed by the coefficients of its cluster's vertices: whatever comes later only
/// adds detail. Stops in the middle when it is out of bytes, and goes on there. FORMAT.md 13.7.
class TrajectoryWalk
{
public:
    /// Keeps views of `nodes`.
    TrajectoryWalk(const ReelNodes &nodes, const Clusters &clusters, const ReelParameters &p,
                   const std::vector<Point> &places)
        : mParts(nodes.vertices, clusters)
        , mBasis(nodes.frames, krigingWeights(nodes.frames, framePlaces(nodes.frames)),
                 {std::size_t(3) * p.basisSize, levelRatio(p.basisRatio), TimeRidge}, mBasisModel)
        , mLabelCoder(std::uint32_t(mParts.count()))
        , mCoefficientStep(p.step)
    {
        mCoefficients.reserve(mParts.count());
        for (std::size_t part = 0; part < mParts.count(); ++part)
            mCoefficients.emplace_back(
                mParts.nodes(part), krigingWeights(mParts.nodes(part), mParts.placesOf(part, places)),
                BandSettings{p.basisSize, levelRatio(p.coefficientRatio), MeshRidge}, mCoefficientModel);
    }
    TrajectoryWalk(const TrajectoryWalk &) = delete;
    TrajectoryWalk &operator=(const TrajectoryWalk &) = delete;

    /// Codes the next trajectory with its coefficients. Precondition: done() is below the basis size, not isBad()
    /// \param source  `TrajectoryStart start(ClusterLabelCoder &, StepCoder &, std::uint32_t k)` codes how trajectory k
    ///                begins; `basis()` and `coefficients()` are the residuals, as BandCoder asks for them;
    ///                `hasRunOut()` is asked after each
    /// \returns       false if the source has run out; call again with more. Or if it is bad
    template <class Source>
    bool next(Source &source)
    {
        if (mTrajectories.size() == mDone) {
            const TrajectoryStart start = source.start(mLabelCoder, mStepCoder, mDone);
            if (source.hasRunOut())
                return false;
            mIsBad = start.cluster >= mParts.count();
            if (mIsBad)
                return false;
            mTrajectories.push_back(
                {start.cluster, mCoefficients[start.cluster].band(), stepOfExponent(start.stepExponent)});
        }
        while (mBasis.band() < 3 * (std::size_t(mDone) + 1))
            if (!mBasis.nextBand(source.basis()))
                return false;
        if (!mCoefficients[mTrajectories.back().part].nextBand(source.coefficients()))
            return false;
        ++mDone;
        return true;
    }

    /// A trajectory was of a cluster that there is not.
    bool isBad() const { return mIsBad; }
    /// Trajectories that are coded whole.
    std::uint32_t done() const { return mDone; }
    // Of these, in the animation's unit.
    /// \param node  of the frames
    double basisValue(std::uint32_t k, std::size_t node, std::size_t axis) const
    {
        return mBasis.value(node, 3 * std::size_t(k) + axis) * mTrajectories[k].step;
    }
    /// The nodes of all vertices that have a coefficient.
    const std::vector<std::uint32_t> &members(std::uint32_t k) const { return mParts.members(mTrajectories[k].part); }
    /// \param i  of the members
    double coefficient(std::uint32_t k, std::size_t i) const
    {
        const Trajectory &t = mTrajectories[k];
        return mCoefficients[t.part].value(i, t.band) * mCoefficientStep;
    }

private:
    struct Trajectory
    {
        std::uint32_t part;
        std::size_t band; ///< of its part
        double step;
    };

    BandModel mBasisModel, mCoefficientModel;
    ReelParts mParts;
    BandCoder mBasis;
    std::vector<BandCoder> mCoefficients; ///< of the parts
    ClusterLabelCoder mLabelCoder;
    StepCoder mStepCoder;
    std::vector<Trajectory> mTrajectories;
    double mCoefficientStep;
    std::uint32_t mDone = 0;
    bool mIsBad = false;
};

} // namespace model::codec
