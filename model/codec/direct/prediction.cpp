// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/direct/prediction.h"

#include <cmath>

namespace model::codec {

namespace {

// The second fit weighs a vertex by 1 / (1 + error): what counts is the size of residuals, not that of their squares.
constexpr int Fits = 2;
// Of the diagonal, so that features that depend on one another do no harm.
constexpr double Ridge = 1e-6;
constexpr std::size_t CancelInterval = 4096; // vertices

using Row = std::array<double, MaxFeatures>;

/// Normal equations of a least-squares fit.
struct NormalEquations
{
    std::array<Row, MaxFeatures> matrix{};
    Row right{};

    void add(const std::array<std::int32_t, MaxFeatures> &features, std::size_t count, double target, double weight)
    {
        for (std::size_t i = 0; i < count; ++i) {
            const double f = weight * features[i];
            for (std::size_t j = 0; j <= i; ++j)
                matrix[i][j] += f * features[j];
            right[i] += f * target;
        }
    }

    /// By Cholesky's decomposition; features without any effect get 0.
    Row solve(std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i)
            matrix[i][i] += Ridge * matrix[i][i] + 1e-3;
        for (std::size_t j = 0; j < count; ++j)
            for (std::size_t i = j; i < count; ++i) {
                double sum = matrix[i][j];
                for (std::size_t k = 0; k < j; ++k)
                    sum -= matrix[i][k] * matrix[j][k];
                matrix[i][j] = i == j ? std::sqrt(std::max(sum, 1e-9)) : sum / matrix[j][j];
            }
        Row x = right;
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < i; ++k)
                x[i] -= matrix[i][k] * x[k];
            x[i] /= matrix[i][i];
        }
        for (std::size_t i = count; i-- > 0;) {
            for (std::size_t k = i + 1; k < count; ++k)
                x[i] -= matrix[k][i] * x[k];
            x[i] /= matrix[i][i];
        }
        return x;
    }
};

double sumOf(const std::array<std::int32_t, MaxFeatures> &features, const Row &weights, std::size_t count)
{
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i)
        sum += weights[i] * features[i];
    return sum;
}

} // namespace

void takeFeatures(const MeshWalk &walk, std::size_t place, const FrameHistory &history, std::span<const Cell> now,
                  Features &features)
{
    const std::uint32_t v = walk.vertex(place);
    const std::size_t count = featureCount(history);
    const Cell *last = history.last.data();
    const auto moved = [&](std::uint32_t vertex, std::size_t axis) {
        return now[vertex][axis] - (last ? last[vertex][axis] : 0);
    };

    const auto known = walk.known(place);
    const MeanSixteenths mean(known.size());
    std::array<std::int64_t, 3> sums{}, before{}, earlier{};
    for (const std::uint32_t other : known)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            sums[axis] += moved(other, axis);
            if (count > 2)
                before[axis] += last[other][axis] - history.second[other][axis];
            if (count > 4)
                earlier[axis] += history.second[other][axis] - history.third[other][axis];
        }
    const auto parallelograms = walk.parallelograms(place);
    const MeanSixteenths parallelogramMean(parallelograms.size());
    std::array<std::int64_t, 3> completed{};
    for (const auto &p : parallelograms)
        for (std::size_t axis = 0; axis < 3; ++axis)
            completed[axis] += moved(p.a, axis) + moved(p.b, axis) - moved(p.opposite, axis);

    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto &f = features[axis];
        f[0] = mean(sums[axis]);
        f[1] = parallelograms.empty() ? f[0] : parallelogramMean(completed[axis]);
        if (count > 2) {
            f[2] = std::int32_t(FeatureUnit) * (last[v][axis] - history.second[v][axis]);
            f[3] = mean(before[axis]);
        }
        if (count > 4) {
            f[4] = std::int32_t(FeatureUnit) * (history.second[v][axis] - history.third[v][axis]);
            f[5] = mean(earlier[axis]);
        }
    }
}

FeatureWeights fittedWeights(const MeshWalk &walk, const FrameHistory &history, std::span<const Cell> now,
                             const Progress &progress)
{
    const std::size_t count = featureCount(history);
    std::vector<Features> features(now.size());
    for (std::size_t place = 0; place < now.size(); ++place) {
        if (place % CancelInterval == 0 && progress.isCancelled())
            return {};
        takeFeatures(walk, place, history, now, features[place]);
    }

    FeatureWeights result{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Row weights{};
        for (int fit = 0; fit < Fits; ++fit) {
            NormalEquations equations;
            for (std::size_t place = 0; place < now.size(); ++place) {
                if (place % CancelInterval == 0 && progress.isCancelled())
                    return {};
                const std::uint32_t v = walk.vertex(place);
                const double target =
                    double(FeatureUnit) * (now[v][axis] - (history.last.data() ? history.last[v][axis] : 0));
                const auto &f = features[place][axis];
                const double error = std::fabs(target - sumOf(f, weights, count)) / double(FeatureUnit);
                equations.add(f, count, target, fit == 0 ? 1 : 1 / (1 + error));
            }
            weights = equations.solve(count);
        }
        for (std::size_t i = 0; i < count; ++i)
            result[axis][i] = std::int32_t(
                std::clamp(std::round(weights[i] * double(WeightUnit)), -double(MaxWeight), double(MaxWeight)));
    }
    return result;
}

} // namespace model::codec
