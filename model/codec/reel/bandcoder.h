// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/reel/interpolation.h"
#include "model/codec/reel/residualmodel.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace model::codec {

/// How the bands over one set of nodes are coded; the same on both sides.
struct BandSettings
{
    std::size_t bands = 0;
    /// Step of a level relative to that of the next finer one; the finest has the band's own step.
    double levelRatio = 1;
    /// As learnWeights().
    double ridge = 1;
};

/// Steps of the levels in units of the finest one's, which is 1.
std::vector<double> levelSteps(std::size_t finest, double ratio);

/// What is learned of residuals while bands are coded; several coders may share one.
class BandModel : public ResidualModel<6, 20>
{
public:
    static constexpr std::size_t Sets = 20;
    static constexpr std::uint32_t LevelContexts = SizeClasses;
    static constexpr std::uint32_t BandContexts = 64;

    BandModel();
};

/// Codes values on nodes, band after band: each is interpolated from the known nodes, with weights that are learned
/// from the bands before, and the rest is coded in contexts that say how large it will be. The values are in units of
/// their band's step. FORMAT.md 13.4.
///
/// `Residual` answers for each node: `std::int32_t operator()(Model &, const Model::Contexts &, std::size_t set,
/// std::uint32_t node, double predicted, double step)` codes the node's residual, in steps of its level. So one walk
/// serves encoder, decoder and trial. One that has `bool hasRunOut()` may be without an answer for now.
class BandCoder
{
public:
    using Model = BandModel;

    /// Keeps views of `nodes` and `model`. \param prior  weights to start with
    BandCoder(const CoarseToFine &nodes, std::vector<Weights> prior, const BandSettings &settings, Model &model);

    /// \returns false if the residuals ran out in the middle of the band: the next call goes on there
    template <class Residual>
    bool nextBand(Residual &&residual)
    {
        if (mBand == mNextLesson)
            learn();
        for (std::size_t i = mNode; i < mNodes.size(); ++i) {
            const auto known = mNodes.known[i];
            double predicted = 0;
            for (std::size_t j = 0; j < known.size(); ++j)
                predicted += mWeights[i][j] * mValues[known[j] * mSettings.bands + mBand];
            const double step = mLevelSteps[mNodes.levels[i]];
            std::size_t set = 0;
            const Model::Contexts contexts = contextsOf(i, known, set);
            const std::int32_t q = residual(mModel, contexts, set, std::uint32_t(i), predicted, step);
            if constexpr (requires { residual.hasRunOut(); })
                if (residual.hasRunOut()) {
                    mNode = i;
                    return false;
                }
            mValues[i * mSettings.bands + mBand] = predicted + q * step;
            const std::uint32_t magnitude = std::min(std::uint32_t(std::abs(q)), MagnitudeLimit);
            mMagnitudes[i] = std::uint16_t(magnitude);
            mRunning += (std::int32_t(magnitude * 256) - mRunning) >> 6;
        }
        endBand();
        return true;
    }

    std::size_t band() const { return mBand; }
    /// In steps; of a band that was coded.
    double value(std::size_t node, std::size_t band) const { return mValues[node * mSettings.bands + band]; }
    static std::uint64_t neededBytes(std::uint64_t nodes, std::uint64_t bands);

private:
    static constexpr std::uint32_t MagnitudeLimit = 4000;
    static constexpr std::size_t MaxAdjacent = 32;
    // A sixteenth of a step is the unit of all that is expected.
    static constexpr std::uint32_t Unit = 16;

    void learn();
    void endBand();

    Model::Contexts contextsOf(std::size_t i, std::span<const std::uint32_t> known, std::size_t &set) const
    {
        // The nearest say most.
        static constexpr std::array<std::uint32_t, 8> Shares{4, 4, 3, 3, 2, 2, 2, 2};
        std::uint32_t sum = 0, shares = 0;
        for (std::size_t j = 0; j < std::min(known.size(), Shares.size()); ++j) {
            sum += Shares[j] * mMagnitudes[known[j]];
            shares += Shares[j];
        }
        const std::uint32_t around = shares ? sum * Unit / shares : Unit + Unit / 2;
        const std::uint32_t before = mActivity[i];
        const std::uint32_t nearby = mNearby[i];
        const std::uint32_t all = std::uint32_t(mRunning);
        const std::uint32_t expected = (35 * around + 25 * before + 25 * nearby + 15 * std::min(all, 1000u)) / 100;
        const std::uint32_t last = mBand > 0 ? mLast[i] : 1;
        const std::uint32_t secondLast = mBand > 1 ? mSecondLast[i] : last;

        set = std::min<std::size_t>(sizeClass(std::min(expected, 1000u)), Model::Sets - 1);
        const std::uint32_t aroundClass = cappedClass(around), beforeClass = cappedClass(before);
        return {aroundClass * SizeClasses + beforeClass,
                sizeClass(std::min(2 * expected, 3000u)) * Model::LevelContexts +
                    std::min<std::uint32_t>(mNodes.levels[i], Model::LevelContexts - 1),
                std::min(std::uint32_t(mBand), Model::BandContexts - 1) * SizeClasses + cappedClass(expected),
                beforeClass * SizeClasses + cappedClass(nearby),
                std::min(last, 5u) * 4 + std::min(secondLast, 3u) + 24 * aroundClass,
                aroundClass * SizeClasses + cappedClass(all / 2)};
    }

    const CoarseToFine &mNodes;
    const BandSettings mSettings;
    const std::vector<double> mLevelSteps;
    const std::vector<Weights> mPrior;
    std::vector<Weights> mWeights;
    std::vector<double> mValues; ///< #N x bands
    Model &mModel;
    std::size_t mBand = 0;
    std::size_t mNode = 0; ///< of this band, where to go on
    std::size_t mNextLesson;
    // Magnitudes of residuals, in steps of their levels.
    std::vector<std::uint16_t> mMagnitudes; ///< #N; in this band
    std::vector<std::uint16_t> mLast, mSecondLast;
    std::vector<std::uint32_t> mActivity; ///< #N; mean over the bands before, the latest most; in 1 / Unit
    std::vector<std::uint32_t> mNearby;   ///< #N; the same of the nodes around
    std::int32_t mRunning = 64;           ///< mean of the latest nodes in 1/256, shown as it is
};

} // namespace model::codec
