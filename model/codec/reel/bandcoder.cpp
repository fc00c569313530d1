// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/reel/bandcoder.h"

namespace model::codec {

namespace {

// Weights are learned after so many bands, then each time half as many have been added: more often gains 0.5 %.
constexpr std::size_t FirstLesson = 3;
constexpr std::size_t nextLesson(std::size_t band)
{
    return band + std::max<std::size_t>(2, band / 2);
}
// No level is finer than this part of the finest level's step.
constexpr double LeastLevelStep = 0.05;

} // namespace

std::vector<double> levelSteps(std::size_t finest, double ratio)
{
    std::vector<double> steps(finest + 1, 1);
    for (std::size_t level = finest; level-- > 0;)
        steps[level] = std::max(LeastLevelStep, steps[level + 1] * ratio);
    return steps;
}

BandModel::BandModel()
    : ResidualModel({SizeClasses * SizeClasses, SizeClasses * LevelContexts, BandContexts * SizeClasses,
                     SizeClasses * SizeClasses, SizeClasses * SizeClasses, SizeClasses * SizeClasses})
{}

BandCoder::BandCoder(const CoarseToFine &nodes, std::vector<Weights> prior, const BandSettings &settings, Model &model)
    : mNodes(nodes)
    , mSettings(settings)
    , mLevelSteps(levelSteps(nodes.finest, settings.levelRatio))
    , mPrior(std::move(prior))
    , mWeights(mPrior)
    , mValues(nodes.size() * settings.bands)
    , mModel(model)
    , mNextLesson(FirstLesson)
    , mMagnitudes(nodes.size())
    , mLast(nodes.size())
    , mSecondLast(nodes.size())
    , mActivity(nodes.size())
    , mNearby(nodes.size())
{}

void BandCoder::learn()
{
    learnWeights(mNodes, mPrior, mValues, mSettings.bands, mBand, mSettings.ridge, mWeights);
    mNextLesson = nextLesson(mBand);
}

void BandCoder::endBand()
{
    mSecondLast.swap(mLast);
    mLast = mMagnitudes;
    for (std::size_t i = 0; i < mNodes.size(); ++i) {
        const std::uint32_t now = mMagnitudes[i] * Unit;
        mActivity[i] = mBand == 0 ? now : (5 * mActivity[i] + 3 * now) / 8;
    }
    for (std::size_t i = 0; i < mNodes.size(); ++i) {
        std::uint32_t sum = 0;
        const auto adjacent = mNodes.adjacent[i].first(std::min(mNodes.adjacent[i].size(), MaxAdjacent));
        for (const std::uint32_t other : adjacent)
            sum += mActivity[other];
        mNearby[i] = adjacent.empty() ? 0 : sum / std::uint32_t(adjacent.size());
    }
    ++mBand;
    mNode = 0;
}

std::uint64_t BandCoder::neededBytes(std::uint64_t nodes, std::uint64_t bands)
{
    return nodes *
               (bands * sizeof(double) + 2 * sizeof(Weights) + 3 * sizeof(std::uint16_t) + 2 * sizeof(std::uint32_t)) +
           sizeof(BandCoder);
}

} // namespace model::codec
