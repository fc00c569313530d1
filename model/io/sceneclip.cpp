// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/sceneclip.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <assimp/anim.h>

namespace model::io {

namespace {

constexpr double DefaultFrameRate = 25;
constexpr double DefaultTicksPerSecond = 25; // assimp's own word for "not said"

/// Calls visit(keys, count) with the keys of everything that moves.
template <class Visit>
void forEachKeys(const std::vector<const aiAnimation *> &animations, const Visit &visit)
{
    for (const aiAnimation *animation : animations) {
        for (unsigned i = 0; i < animation->mNumChannels; ++i) {
            const aiNodeAnim &channel = *animation->mChannels[i];
            visit(channel.mPositionKeys, channel.mNumPositionKeys);
            visit(channel.mRotationKeys, channel.mNumRotationKeys);
            visit(channel.mScalingKeys, channel.mNumScalingKeys);
        }
        for (unsigned i = 0; i < animation->mNumMorphMeshChannels; ++i)
            visit(animation->mMorphMeshChannels[i]->mKeys, animation->mMorphMeshChannels[i]->mNumKeys);
    }
}

} // namespace

SceneClip::SceneClip(std::vector<const aiAnimation *> animations)
    : mAnimations(std::move(animations))
    , mTicksPerSecond(!mAnimations.empty() && mAnimations.front()->mTicksPerSecond > 0
                          ? mAnimations.front()->mTicksPerSecond
                          : DefaultTicksPerSecond)
{
    for (const aiAnimation *animation : mAnimations)
        mEnd = std::max(mEnd, animation->mDuration);
    mBegin = mEnd;
    forEachKeys(mAnimations, [this](const auto *keys, unsigned count) {
        if (count > 1) // a single key holds for all of the time
            mBegin = std::min(mBegin, std::max(0.0, keys[0].mTime));
    });
}

double SceneClip::keyRate() const
{
    constexpr double MinRate = 1, MaxRate = 240;
    std::vector<double> times;
    forEachKeys(mAnimations, [&times](const auto *keys, unsigned count) {
        if (count > times.size()) {
            times.clear();
            std::transform(keys, keys + count, std::back_inserter(times), [](const auto &key) { return key.mTime; });
        }
    });
    if (times.size() < 2)
        return DefaultFrameRate;
    std::vector<double> gaps;
    for (std::size_t i = 1; i < times.size(); ++i)
        gaps.push_back(times[i] - times[i - 1]);
    std::nth_element(gaps.begin(), gaps.begin() + std::ptrdiff_t(gaps.size() / 2), gaps.end());
    const double rate = mTicksPerSecond / gaps[gaps.size() / 2];
    if (!(rate >= MinRate && rate <= MaxRate))
        return DefaultFrameRate;
    // Key times are 32-bit floats of seconds: a rate that close to a whole one is meant to be whole.
    constexpr double Precision = 1e-3;
    return std::abs(rate - std::round(rate)) < Precision * rate ? std::round(rate) : rate;
}

double SceneClip::frameCount(double rate) const
{
    constexpr double Slack = 1e-3; // of a frame
    return mEnd > mBegin ? std::floor((mEnd - mBegin) / mTicksPerSecond * rate + Slack) + 1 : 1;
}

double SceneClip::timeOf(double frame, double rate) const
{
    return mBegin + frame / rate * mTicksPerSecond;
}

} // namespace model::io
