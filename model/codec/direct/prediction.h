// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/compressionsettings.h"
#include "model/base/progress.h"
#include "model/codec/direct/meshwalk.h"

#include <algorithm>

namespace model::codec {

/// A quantised position: cells along x, y, z.
using Cell = std::array<std::int32_t, 3>;

/// The frames that a frame is predicted from, newest first; empty where there is none. All #V.
struct FrameHistory
{
    std::span<const Cell> last, second, third;
};

/// Most features of the predictor N. FORMAT.md 11.4.
inline constexpr std::size_t MaxFeatures = 6;
inline constexpr std::int64_t FeatureUnit = 16;  ///< features are in 1/16 of a cell
inline constexpr std::int64_t WeightUnit = 256;  ///< weights are in 1/256
inline constexpr std::int32_t MaxWeight = 32767; ///< largest magnitude

/// What each feature counts for, along x, y and z.
using FeatureWeights = std::array<std::array<std::int32_t, MaxFeatures>, 3>;
using Features = std::array<std::array<std::int32_t, MaxFeatures>, 3>;

/// How many features N has with this history.
inline std::size_t featureCount(const FrameHistory &history)
{
    return history.third.data() ? 6 : history.second.data() ? 4 : 2;
}

/// Sums of a few values as means in units of 1/16, without a division: the same integers on every machine.
class MeanSixteenths
{
public:
    explicit MeanSixteenths(std::size_t count)
        : mFactor(count ? 65536 / std::int64_t(count) : 0)
    {}
    std::int32_t operator()(std::int64_t sum) const { return std::int32_t((sum * mFactor) >> 12); }

private:
    std::int64_t mFactor;
};

/// The features of the vertex at `place`: how its surroundings move in this frame, and how it and they moved before.
/// \param now  this frame; looks only at vertices before `place` in the walk
void takeFeatures(const MeshWalk &walk, std::size_t place, const FrameHistory &history, std::span<const Cell> now,
                  Features &features);

/// The position that the predictor N expects.
inline std::int32_t weighted(const std::array<std::int32_t, MaxFeatures> &features,
                             const std::array<std::int32_t, MaxFeatures> &weights, std::size_t count)
{
    std::int64_t sum = FeatureUnit * WeightUnit / 2;
    for (std::size_t i = 0; i < count; ++i)
        sum += std::int64_t(features[i]) * weights[i];
    return std::int32_t(std::clamp<std::int64_t>(sum >> 12, -(1 << 25), 1 << 25));
}

/// What A, B, C and none expect, FORMAT.md 11.3; of the first frame, and with none, the vertex before in the walk.
inline Cell fixedPrediction(Predictor predictor, const MeshWalk &walk, std::size_t place, const FrameHistory &history,
                            std::span<const Cell> now)
{
    const std::uint32_t v = walk.vertex(place);
    if (!history.last.data() || predictor == Predictor::None)
        return place > 0 ? now[walk.vertex(place - 1)] : Cell{};
    Cell cell = history.last[v];
    const bool isSteady = predictor == Predictor::Steady || predictor == Predictor::Accelerating;
    if (!isSteady || !history.second.data())
        return cell;
    const bool isAccelerating = predictor == Predictor::Accelerating && history.third.data();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int32_t speed = history.last[v][axis] - history.second[v][axis];
        cell[axis] += speed;
        if (isAccelerating)
            cell[axis] += speed - (history.second[v][axis] - history.third[v][axis]);
    }
    return cell;
}

/// The weights that would predict a frame best, for the encoder. Floating point: they are written to the file. Any once
/// the work is cancelled.
FeatureWeights fittedWeights(const MeshWalk &walk, const FrameHistory &history, std::span<const Cell> now,
                             const Progress &progress);

} // namespace model::codec
