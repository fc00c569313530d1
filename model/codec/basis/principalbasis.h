// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/compressionsettings.h"
#include "model/codec/framestack.h"

#include <memory>

namespace model::codec {

/// An animation as the `pca` codec stores it, everything in steps of 1 / resolution. FORMAT.md 5.
struct QuantizedPca
{
    std::uint32_t rank = 0;
    std::vector<std::int64_t> means;        ///< #3F
    std::vector<std::int32_t> basis;        ///< #rank x #3F, one trajectory after another
    std::vector<std::int32_t> coefficients; ///< #rank x #V
    /// Sum of the squared distances of all vertices from where the decoder will have them, computed on the
    /// coefficients.
    double squaredError = 0;
};

/// Coefficients of every vertex on some trajectories, before they are rounded.
struct FittedCoefficients
{
    std::size_t rank = 0;
    std::vector<double> values; ///< #rank x #V
    std::vector<double> gram;   ///< #rank x #rank: the products of the trajectories
    /// Sum of the squared distances of all vertices that the fit leaves; it is orthogonal to what rounding adds.
    double squaredError = 0;

    /// The same sum with coefficients that differ from `values`; anything once the work is cancelled.
    /// \param differences  #rank x #V
    double squaredErrorWith(std::span<const double> differences, const Progress &progress) const;
};

/// The coefficients that fit best. \param basis  #rank x #3F, any trajectories. \error Cancelled
Result<FittedCoefficients> fittedCoefficients(const FrameStack &frames, std::span<const double> means,
                                              std::span<const double> basis, const Progress &progress);

/// The strongest trajectories of an animation as they are before anything is rounded: found once, quantised in many
/// ways.
class PrincipalComponents
{
public:
    /// \param count  how many at most. \error Cancelled
    static Result<PrincipalComponents> of(const FrameStack &frames, std::size_t count, const Progress &progress);
    PrincipalComponents(PrincipalComponents &&) noexcept;
    ~PrincipalComponents();

    /// How many were found; fewer than asked for where the animation has no more.
    std::size_t count() const;
    /// One of them, #3F entries; all are orthonormal, the strongest first.
    std::span<const double> trajectory(std::size_t k) const;

    /// The first of them, means and coefficients, quantised. The coefficients are those that fit the quantised basis
    /// best. \param frames  those that the components are of \error LimitExceeded, Cancelled
    Result<QuantizedPca> quantized(const FrameStack &frames, const PcaSettings &settings,
                                   const Progress &progress) const;

private:
    struct Basis;
    explicit PrincipalComponents(std::unique_ptr<Basis> basis);
    std::unique_ptr<Basis> mBasis;
};

/// Principal component analysis and quantisation. \error LimitExceeded, Cancelled
Result<QuantizedPca> quantizedPca(const FrameStack &frames, const PcaSettings &settings, const Progress &progress);

} // namespace model::codec
