// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/compressionsettings.h"
#include "model/codec/basis/principalbasis.h"
#include "model/codec/connectivity/connectivitystage.h"

namespace model::codec {

/// An animation as `coddyac` stores it. FORMAT.md 14.
struct QuantizedCoddyac
{
    /// Root mean square over the vertices of |trajectory - mean trajectory|; 1 if that is 0.
    double unit = 1;
    std::uint32_t rank = 0;
    std::vector<std::int64_t> means;        ///< #3F
    std::vector<std::uint32_t> fineness;    ///< #rank: quarters of powers of two that the basis' step is larger by
    std::vector<std::int64_t> basis;        ///< #rank x #3F
    std::vector<std::int32_t> coefficients; ///< #rank x #V, in the coded order
    double squaredError = 0;                ///< as QuantizedPca::squaredError
};

/// The quantisation steps of a file, for both sides.
class CoddyacSteps
{
public:
    CoddyacSteps(const CoddyacSettings &settings, double unit, std::uint32_t vertexCount);

    double mean() const { return mMean; }
    double coefficient() const { return mCoefficient; }
    /// Of a trajectory whose coefficients are 2^(-fineness / 4) times as large as all together.
    double basis(std::uint32_t fineness) const;

private:
    double mMean, mCoefficient, mBasis;
};

/// Most that QuantizedCoddyac::fineness holds.
inline constexpr std::uint32_t MaxFineness = 255;

/// Quantises with the loop closed over the prediction of the coefficients.
/// \param norms  #components: the root of the sum of the squares of each trajectory's coefficients
/// \error LimitExceeded, Cancelled
Result<QuantizedCoddyac> quantizedCoddyac(const FrameStack &frames, const PrincipalComponents &components,
                                          std::span<const double> norms, const CoddyacSettings &settings,
                                          const CodedConnectivity &connectivity,
                                          std::span<const std::uint32_t> permutation, const Progress &progress);

/// The `norms` of components. \error Cancelled
Result<std::vector<double>> coefficientNorms(const FrameStack &frames, const PrincipalComponents &components,
                                             const Progress &progress);

} // namespace model::codec
