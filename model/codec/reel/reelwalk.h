// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

    BandCoder bands(nodes.frames, krigingWeights(nodes.frames, framePlaces(nodes.frames)),
                    {3, levelRatio(p.basisRatio), TimeRidge});
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

/// Trajectory after trajectory, each followed by the coefficients of all vertices: whatever comes later only adds
/// detail. Stops in the middle when it is out of bytes, and goes on there. FORMAT.md 13.7.
class TrajectoryWalk
{
public:
    /// Keeps views of `nodes`.
    TrajectoryWalk(const ReelNodes &nodes, const ReelParameters &p, const std::vector<Point> &places)
        : mBasis(nodes.frames, krigingWeights(nodes.frames, framePlaces(nodes.frames)),
                 {std::size_t(3) * p.basisSize, levelRatio(p.basisRatio), TimeRidge})
        , mCoefficients(nodes.vertices, krigingWeights(nodes.vertices, places),
                        {p.basisSize, levelRatio(p.coefficientRatio), MeshRidge})
        , mCoefficientStep(p.step)
    {}

    /// Codes the next trajectory with its coefficients. Precondition: done() is below the basis size
    /// \param source  `std::int32_t step(StepCoder &, std::uint32_t k)` codes the exponent of trajectory k; `basis()`
    /// and
    ///                `coefficients()` are the residuals, as BandCoder asks for them; `hasRunOut()` is asked after each
    /// \returns       false if the source has run out; call again with more
    template <class Source>
    bool next(Source &source)
    {
        if (mSteps.size() == mDone) {
            const std::int32_t exponent = source.step(mStepCoder, mDone);
            if (source.hasRunOut())
                return false;
            mSteps.push_back(stepOfExponent(exponent));
        }
        while (mBasis.band() < 3 * (std::size_t(mDone) + 1))
            if (!mBasis.nextBand(source.basis()))
                return false;
        if (!mCoefficients.nextBand(source.coefficients()))
            return false;
        ++mDone;
        return true;
    }

    /// Trajectories that are coded whole.
    std::uint32_t done() const { return mDone; }
    // Of these, in the animation's unit; nodes are those of frames and of vertices.
    double basisValue(std::uint32_t k, std::size_t node, std::size_t axis) const
    {
        return mBasis.value(node, 3 * std::size_t(k) + axis) * mSteps[k];
    }
    double coefficient(std::uint32_t k, std::size_t node) const
    {
        return mCoefficients.value(node, k) * mCoefficientStep;
    }

private:
    BandCoder mBasis;
    BandCoder mCoefficients;
    double mCoefficientStep;
    StepCoder mStepCoder;
    std::vector<double> mSteps;
    std::uint32_t mDone = 0;
};

} // namespace model::codec
