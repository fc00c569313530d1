// SPDX-License-Identifier: GPL-3.0-or-later
// Based on:
// - L. Vasa, V. Skala: CoDDyaC: Connectivity Driven Dynamic Mesh Compression, 2007
// - L. Vasa, V. Skala: COBRA: Compression of the Basis for PCA Represented Animations, 2009 (a step for each
// trajectory) Differs: the step of a trajectory follows from equal slopes (README), coefficients are fitted to the
// basis as quantised, and residuals are rounded towards zero up to DeadZone.
#include "model/codec/coddyac/coddyacquantizer.h"

#include "model/base/parallel.h"
#include "model/codec/coddyac/lanestage.h"
#include "model/codec/coddyac/parallelogramstage.h"
#include "model/codec/container/syntax.h"

#include <atomic>
#include <cmath>

namespace model::codec {

namespace {

// A residual is rounded up from this part of a step; chosen on the real sequences, see the README.
constexpr double DeadZone = 0.65;

tl::unexpected<Error> tooLarge(const char *what, double limit)
{
    return fail(ErrorCode::LimitExceeded, what, "more than " + numberText(limit), numberText(limit));
}

/// \returns false if a value is too large
template <class Integer>
bool quantize(std::span<const double> values, double step, double limit, std::vector<Integer> &out)
{
    for (const double value : values) {
        const double q = std::round(value / step);
        if (!(std::fabs(q) <= limit))
            return false;
        out.push_back(Integer(q));
    }
    return true;
}

} // namespace

CoddyacSteps::CoddyacSteps(const CoddyacSettings &settings, double unit, std::uint32_t vertexCount)
    : mMean(settings.basisStep * unit / std::sqrt(double(vertexCount)))
    , mCoefficient(settings.step * unit)
    , mBasis(settings.basisStep / std::sqrt(double(vertexCount)))
{}

double CoddyacSteps::basis(std::uint32_t fineness) const
{
    constexpr double Quarters[4] = {1, 1.189207115002721, 1.4142135623730951, 1.681792830507429};
    return std::ldexp(mBasis * Quarters[fineness % 4], int(fineness / 4));
}

Result<std::vector<double>> coefficientNorms(const FrameStack &frames, const PrincipalComponents &components,
                                             const Progress &progress)
{
    std::vector<double> basis;
    for (std::size_t k = 0; k < components.count(); ++k)
        basis.insert(basis.end(), components.trajectory(k).begin(), components.trajectory(k).end());
    const Result<FittedCoefficients> fitted = fittedCoefficients(frames, frames.rowMeans(), basis, progress);
    if (!fitted)
        return fail(fitted.error());
    std::vector<double> norms;
    const std::size_t vertices = frames.vertexCount();
    for (std::size_t k = 0; k < fitted->rank; ++k) {
        double sum = 0;
        for (std::size_t v = 0; v < vertices; ++v)
            sum += fitted->values[k * vertices + v] * fitted->values[k * vertices + v];
        norms.push_back(std::sqrt(sum));
    }
    return norms;
}

Result<QuantizedCoddyac> quantizedCoddyac(const FrameStack &frames, const PrincipalComponents &components,
                                          std::span<const double> norms, const CoddyacSettings &settings,
                                          const CodedConnectivity &connectivity,
                                          std::span<const std::uint32_t> permutation, const Progress &progress)
{
    QuantizedCoddyac result;
    const std::uint32_t vertexCount = frames.vertexCount();
    const double energy = frames.centredEnergy();
    if (energy > 0)
        result.unit = std::sqrt(energy / vertexCount);
    const CoddyacSteps steps(settings, result.unit, vertexCount);

    std::vector<double> means = frames.rowMeans();
    if (!quantize<std::int64_t>(means, steps.mean(), double(MaxLaneValue), result.means))
        return tooLarge("mean position", double(MaxLaneValue));
    for (std::size_t r = 0; r < means.size(); ++r)
        means[r] = double(result.means[r]) * steps.mean();

    std::vector<double> basis; // as the decoder will have it
    const std::size_t count = std::min<std::size_t>(settings.basisSize, components.count());
    for (std::size_t k = 0; k < count; ++k) {
        const double share = norms[k] / (result.unit * std::sqrt(double(vertexCount)));
        if (!(share > 0))
            break;
        const double fineness = std::clamp(std::round(-4 * std::log2(share)), 0.0, double(MaxFineness));
        const double step = steps.basis(std::uint32_t(fineness));
        const std::size_t start = result.basis.size();
        if (!quantize<std::int64_t>(components.trajectory(k), step, double(MaxLaneValue), result.basis))
            return tooLarge("basis", double(MaxLaneValue));
        const std::span<const std::int64_t> row = std::span(result.basis).subspan(start);
        if (std::all_of(row.begin(), row.end(), [](std::int64_t q) { return q == 0; })) {
            result.basis.resize(start);
            continue;
        }
        result.fineness.push_back(std::uint32_t(fineness));
        for (const std::int64_t q : row)
            basis.push_back(double(q) * step);
    }

    const Result<FittedCoefficients> fitted = fittedCoefficients(frames, means, basis, progress.part(0, 0.8));
    if (!fitted)
        return fail(fitted.error());
    result.coefficients.resize(fitted->values.size());
    std::vector<double> rounding(fitted->values.size());
    std::atomic<bool> exceeded = false;
    const double step = steps.coefficient();
    parallelFor(fitted->rank, [&](std::size_t k) {
        if (progress.isCancelled())
            return;
        const std::span<const double> values = std::span(fitted->values).subspan(k * vertexCount, vertexCount);
        const std::span<std::int32_t> band = std::span(result.coefficients).subspan(k * vertexCount, vertexCount);
        for (std::uint32_t v = 0; v < vertexCount; ++v) {
            const double value = values[permutation[v]];
            const std::int64_t predicted = predictedByNeighbours(band, v, connectivity.neighbours[v]);
            const double residual = value / step - double(predicted);
            const double q =
                double(predicted) + std::copysign(std::floor(std::fabs(residual) + 1 - DeadZone), residual);
            if (!(std::fabs(q) <= MaxBandValue)) {
                exceeded.store(true, std::memory_order_relaxed);
                return;
            }
            band[v] = std::int32_t(q);
            rounding[k * vertexCount + permutation[v]] = q * step - value;
        }
    });
    if (exceeded)
        return tooLarge("coefficient", MaxBandValue);
    result.squaredError = fitted->squaredErrorWith(rounding, progress);
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);

    // Bands of nothing but zeros are left out.
    const std::size_t rows = frames.rowCount();
    for (std::size_t k = 0; k < fitted->rank; ++k) {
        const auto band = result.coefficients.begin() + std::ptrdiff_t(k * vertexCount);
        if (std::all_of(band, band + vertexCount, [](std::int32_t q) { return q == 0; }))
            continue;
        if (result.rank != k) {
            std::copy_n(band, vertexCount, result.coefficients.begin() + std::ptrdiff_t(result.rank * vertexCount));
            std::copy_n(result.basis.begin() + std::ptrdiff_t(k * rows), rows,
                        result.basis.begin() + std::ptrdiff_t(result.rank * rows));
            result.fineness[result.rank] = result.fineness[k];
        }
        ++result.rank;
    }
    result.coefficients.resize(std::size_t(result.rank) * vertexCount);
    result.basis.resize(result.rank * rows);
    result.fineness.resize(result.rank);
    progress.report(1);
    return result;
}

} // namespace model::codec
