// SPDX-License-Identifier: GPL-3.0-or-later
// Based on:
// - G. Matheron: Principles of geostatistics, 1963 (kriging with drift)
// - S. Roweis, L. Saul: Nonlinear dimensionality reduction by locally linear embedding, 2000 (weights from neighbours)
// Differs: the weights of the second start from those of the first.
#include "model/codec/reel/interpolation.h"

#include "model/base/parallel.h"

#include <cmath>

namespace model::codec {

namespace {

// Covariance of two places, relative to the node and in units of the mean distance h of its known nodes:
// Constant + Linear p.q + Smooth / (1 + |p - q|^2 / Reach^2), and Noise where p = q. The first two make affine fields
// come out exactly; the optimum of the others is flat (Reach 2 ... 5 costs 2 %).
constexpr double Constant = 100;
constexpr double Linear = 30;
constexpr double Smooth = 10;
constexpr double Reach = 3;
constexpr double Noise = 0.02;
// Fewer give no shape to go by: then the nearest alone counts.
constexpr std::size_t LeastForKriging = 3;

constexpr std::size_t Grain = 512;

using Place = std::array<double, 3>;

double dot(const Place &a, const Place &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A symmetric positive definite system of at most MaxKnown unknowns. Only the lower triangle is used.
struct SmallSystem
{
    double m[MaxKnown][MaxKnown];
    std::size_t size = 0;

    /// L D L^T in place: D on the diagonal.
    void factorize()
    {
        for (std::size_t j = 0; j < size; ++j) {
            double scaled[MaxKnown];
            for (std::size_t k = 0; k < j; ++k)
                scaled[k] = m[j][k] * m[k][k];
            for (std::size_t k = 0; k < j; ++k)
                m[j][j] -= m[j][k] * scaled[k];
            const double inverse = 1 / m[j][j];
            for (std::size_t i = j + 1; i < size; ++i) {
                double sum = m[i][j];
                for (std::size_t k = 0; k < j; ++k)
                    sum -= m[i][k] * scaled[k];
                m[i][j] = sum * inverse;
            }
        }
    }
    void solve(Weights &x) const
    {
        for (std::size_t i = 1; i < size; ++i)
            for (std::size_t k = 0; k < i; ++k)
                x[i] -= m[i][k] * x[k];
        for (std::size_t i = size; i-- > 0;) {
            x[i] /= m[i][i];
            for (std::size_t k = i + 1; k < size; ++k)
                x[i] -= m[k][i] * x[k];
        }
    }
};

Weights krigingWeightsOf(std::span<const std::uint32_t> known, std::span<const Place> places, const Place &at)
{
    Weights weights{};
    const std::size_t count = known.size();
    if (count < LeastForKriging) {
        if (count > 0)
            weights[0] = 1;
        return weights;
    }
    Place p[MaxKnown];
    double h = 0;
    for (std::size_t j = 0; j < count; ++j) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            p[j][axis] = places[known[j]][axis] - at[axis];
        h += std::sqrt(dot(p[j], p[j]));
    }
    h /= double(count);
    const double scale = h > 0 ? 1 / h : 0;
    for (std::size_t j = 0; j < count; ++j)
        for (double &x : p[j])
            x *= scale;

    const auto covariance = [](const Place &a, const Place &b) {
        const Place d{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
        return Constant + Linear * dot(a, b) + Smooth / (1 + dot(d, d) * (1 / (Reach * Reach)));
    };
    SmallSystem system;
    system.size = count;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j <= i; ++j)
            system.m[i][j] = covariance(p[i], p[j]);
        system.m[i][i] += Noise;
        weights[i] = covariance(p[i], Place{});
    }
    system.factorize();
    system.solve(weights);
    return weights;
}

/// Sums of four products at a time, in a fixed order.
using Four = double __attribute__((vector_size(4 * sizeof(double))));
constexpr std::size_t KnownQuads = MaxKnown / 4;

double product(const Four *a, const Four *b, std::size_t quads)
{
    Four total{};
    for (std::size_t q = 0; q < quads; ++q)
        total += a[q] * b[q];
    return (total[0] + total[1]) + (total[2] + total[3]);
}

/// The least squares of learnWeights() for one node. With D the differences of the known nodes' values from its own
/// (with weights that add up to 1 the error is their weighted sum), e the error of the prior and r the ridge:
/// w = prior + x - y sum(x) / sum(y), where (D^T D + r) x = -D^T e and (D^T D + r) y = 1.
class Lesson
{
public:
    Lesson(std::span<const std::uint32_t> known, const Weights &prior, const double *values, std::size_t stride,
           std::size_t node, std::size_t bands, double ridge)
        : mKnown(known)
        , mPrior(prior)
        , mValues(values)
        , mStride(stride)
        , mOwn(values + node * stride)
        , mBands(bands)
        , mRidge(ridge * double(bands))
    {
        for (std::size_t j = 0; j < known.size(); ++j)
            mPriorSum += prior[j];
    }

    Weights learn(std::vector<Four> &scratch)
    {
        Weights x{}, y{};
        if (mBands < mKnown.size())
            solveByBands(x, y, scratch);
        else
            solveByNodes(x, y, scratch);
        double xSum = 0, ySum = 0;
        for (std::size_t j = 0; j < mKnown.size(); ++j) {
            xSum += x[j];
            ySum += y[j];
        }
        Weights weights{};
        for (std::size_t j = 0; j < mKnown.size(); ++j)
            weights[j] = mPrior[j] + x[j] - y[j] * (xSum / ySum);
        return weights;
    }

private:
    double difference(std::size_t j, std::size_t k) const { return mValues[mKnown[j] * mStride + k] - mOwn[k]; }

    void solveByNodes(Weights &x, Weights &y, std::vector<Four> &scratch) const
    {
        // D^T, a row for each node, and e.
        const std::size_t count = mKnown.size(), quads = (mBands + 3) / 4;
        scratch.assign(quads * (count + 1), Four{});
        for (std::size_t j = 0; j < count; ++j)
            for (std::size_t k = 0; k < mBands; ++k)
                scratch[quads * j + k / 4][k % 4] = difference(j, k);
        Four *error = scratch.data() + quads * count;
        for (std::size_t k = 0; k < mBands; ++k)
            error[k / 4][k % 4] = mOwn[k] * (mPriorSum - 1);
        for (std::size_t j = 0; j < count; ++j)
            for (std::size_t q = 0; q < quads; ++q)
                error[q] += scratch[quads * j + q] * mPrior[j];

        SmallSystem system;
        system.size = count;
        for (std::size_t i = 0; i < count; ++i) {
            const Four *row = scratch.data() + quads * i;
            for (std::size_t j = 0; j <= i; ++j)
                system.m[i][j] = product(row, scratch.data() + quads * j, quads);
            system.m[i][i] += mRidge;
            x[i] = -product(row, error, quads);
            y[i] = 1;
        }
        system.factorize();
        system.solve(x);
        system.solve(y);
    }

    // The same by a smaller system: x = -D^T (D D^T + r)^-1 e, and r y = 1 - D^T (D D^T + r)^-1 D 1.
    void solveByBands(Weights &x, Weights &y, std::vector<Four> &scratch) const
    {
        const std::size_t count = mKnown.size();
        scratch.assign(KnownQuads * mBands, Four{});
        SmallSystem system;
        system.size = mBands;
        Weights fromError{}, fromOnes{};
        for (std::size_t k = 0; k < mBands; ++k) {
            Four *row = scratch.data() + KnownQuads * k;
            fromError[k] = mOwn[k] * (mPriorSum - 1);
            for (std::size_t j = 0; j < count; ++j) {
                const double d = difference(j, k);
                row[j / 4][j % 4] = d;
                fromError[k] += d * mPrior[j];
                fromOnes[k] += d;
            }
            for (std::size_t l = 0; l <= k; ++l)
                system.m[k][l] = product(row, scratch.data() + KnownQuads * l, KnownQuads);
            system.m[k][k] += mRidge;
        }
        system.factorize();
        system.solve(fromError);
        system.solve(fromOnes);
        for (std::size_t j = 0; j < count; ++j) {
            y[j] = 1;
            for (std::size_t k = 0; k < mBands; ++k) {
                const double d = scratch[KnownQuads * k + j / 4][j % 4];
                x[j] -= d * fromError[k];
                y[j] -= d * fromOnes[k];
            }
        }
    }

    const std::span<const std::uint32_t> mKnown;
    const Weights &mPrior;
    const double *const mValues;
    const std::size_t mStride;
    const double *const mOwn;
    const std::size_t mBands;
    const double mRidge;
    double mPriorSum = 0;
};

} // namespace

std::vector<Weights> krigingWeights(const CoarseToFine &nodes, std::span<const Place> places)
{
    std::vector<Weights> weights(nodes.size());
    parallelRanges(nodes.size(), Grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            weights[i] = krigingWeightsOf(nodes.known[i], places, places[i]);
    });
    return weights;
}

void learnWeights(const CoarseToFine &nodes, std::span<const Weights> prior, std::span<const double> values,
                  std::size_t stride, std::size_t bands, double ridge, std::vector<Weights> &weights)
{
    parallelRanges(nodes.size(), Grain, [&](std::size_t begin, std::size_t end) {
        std::vector<Four> scratch;
        for (std::size_t i = begin; i < end; ++i)
            if (nodes.known[i].size() >= 2)
                weights[i] = Lesson(nodes.known[i], prior[i], values.data(), stride, i, bands, ridge).learn(scratch);
    });
}

} // namespace model::codec
