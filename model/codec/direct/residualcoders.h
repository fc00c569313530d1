// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/direct/prediction.h"
#include "model/codec/entropy/integercoder.h"

namespace model::codec {

// The two ways to pack the residuals of `direct`, each in both directions. They share one interface, so that a frame is
// coded by one template: what is handed over is the value to encode, which a decoder ignores, and the value that is
// encoded or decoded comes back.
//     void startFrame(bool isFirst);                                  the first of its group
//     int32 weight(size_t axis, size_t feature, int32 value);
//     int32 residual(place, axis, int32 value);                       in the order of the walk, x y z of each vertex
//     bool endFrame();                                                false: the stream is corrupt

/// By the adaptive range coder; how large a residual will be is told by those of the neighbours, of the same vertex in
/// the frame before, and of the axes already coded. FORMAT.md 11.5.
template <class Coder>
class RangeResiduals
{
public:
    template <class... Args>
    explicit RangeResiduals(const MeshWalk &walk, Args &&...args)
        : mCoder(std::forward<Args>(args)...)
        , mWalk(walk)
        , mNow(walk.vertexCount())
        , mLast(walk.vertexCount())
    {}

    void startFrame(bool isFirst)
    {
        mIsFirst = isFirst;
        std::swap(mNow, mLast);
    }

    std::int32_t weight(std::size_t axis, std::size_t feature, std::int32_t value)
    {
        std::int32_t &known = mWeights[axis][feature];
        const std::int64_t residual = codeInteger(mCoder, mWeightModels, WeightContext, 0, std::int64_t(value) - known);
        // A decoder may find anything here.
        known = std::int32_t(std::clamp<std::int64_t>(known + residual, -MaxWeight, MaxWeight));
        return known;
    }

    std::int32_t residual(std::size_t place, std::size_t axis, std::int32_t value)
    {
        const std::uint32_t v = mWalk.vertex(place);
        if (axis == 0)
            lookAround(place);
        const std::uint64_t around = mAround[axis];
        const std::uint64_t before = mIsFirst ? around : 4 * magnitude(mLast[v][axis]);
        const std::uint64_t beside = axis == 0   ? around
                                     : axis == 1 ? 4 * magnitude(mNow[v][0])
                                                 : 2 * (magnitude(mNow[v][0]) + magnitude(mNow[v][1]));
        const std::uint64_t expected = (2 * around + before + beside) / 4;
        const std::int64_t coded =
            codeInteger(mCoder, mModels[mIsFirst][axis], sizeContext(expected), signContext(mSigns[axis]), value);
        mNow[v][axis] = std::int32_t(std::clamp<std::int64_t>(coded, -MostResidual, MostResidual));
        return mNow[v][axis];
    }

    bool endFrame() { return !mCoder.isBad(); }
    Coder &coder() { return mCoder; }

private:
    static constexpr std::int32_t MostResidual = 1 << 24;
    // As for a size of about 32: weights of one frame differ little from those before.
    static constexpr unsigned WeightContext = 10;

    static std::uint64_t magnitude(std::int32_t value)
    {
        return std::uint64_t(value < 0 ? -std::int64_t(value) : value);
    }

    /// Mean magnitude of the neighbours' residuals, in quarters, and the sum of the residuals.
    void lookAround(std::size_t place)
    {
        const auto known = mWalk.known(place);
        const MeanSixteenths mean(known.size());
        std::array<std::int64_t, 3> sizes{};
        mSigns = {};
        for (const std::uint32_t other : known)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                sizes[axis] += std::int64_t(magnitude(mNow[other][axis]));
                mSigns[axis] += mNow[other][axis];
            }
        for (std::size_t axis = 0; axis < 3; ++axis)
            mAround[axis] = std::uint64_t(mean(sizes[axis])) / 4;
    }

    Coder mCoder;
    const MeshWalk &mWalk;
    std::vector<Cell> mNow;  ///< residuals of this frame
    std::vector<Cell> mLast; ///< of the frame before
    bool mIsFirst = true;
    std::array<std::uint64_t, 3> mAround{};
    std::array<std::int64_t, 3> mSigns{};
    FeatureWeights mWeights{};
    IntegerModels<5> mWeightModels;
    std::array<std::array<IntegerModels<5>, 3>, 2> mModels;
};

} // namespace model::codec
