// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/compressionsettings.h"
#include "model/codec/framestack.h"

namespace model::codec {

/// An animation as the `pca` codec stores it, everything in steps of 1 / resolution. FORMAT.md 5.
struct QuantizedPca
{
    std::uint32_t rank = 0;
    std::vector<std::int64_t> means;        ///< #3F
    std::vector<std::int32_t> basis;        ///< #rank x #3F, one trajectory after another
    std::vector<std::int32_t> coefficients; ///< #rank x #V
};

/// Principal component analysis and quantisation. The coefficients are those that fit the quantised basis best.
/// \error LimitExceeded, Cancelled
Result<QuantizedPca> quantizedPca(const FrameStack &frames, const CompressionSettings &settings,
                                  const Progress &progress);

} // namespace model::codec
