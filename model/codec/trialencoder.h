// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/animationcodec.h"

#include <memory>
#include <optional>

namespace model::codec {

/// What some settings give.
struct Trial
{
    CodecSettings settings;
    std::uint64_t bytes = 0;   ///< of the whole file
    double kgErrorPercent = 0; ///< of what a decoder will show, up to the rounding of its floats
};

/// An animation prepared for trying many settings of one codec: what does not depend on them is done once, and no frame
/// is decoded to know the error. Not thread-safe; keeps a reference to the animation.
///
/// How a codec joins in: a class that implements this, and a line in prepareTrials().
class TrialEncoder
{
public:
    virtual ~TrialEncoder() = default;

    /// Settings come in families, each from coarse to fine: one where a codec has a single knob, one for each basis
    /// size where the other knob is a step. Sorted, so that the size at a given error falls to the best family and
    /// rises again.
    virtual std::size_t familyCount() const = 0;
    /// \param fineness  0 ... 1. The finer, the larger the file and the smaller the error; the error's logarithm falls
    ///                  about evenly
    virtual CodecSettings settingsAt(std::size_t family, double fineness) const = 0;

    /// Errors as encodeAnimation.
    virtual Result<Trial> attempt(const CodecSettings &settings, const Progress &progress) = 0;
    /// The file itself.
    virtual Result<EncodedAnimation> encode(const CompressionSettings &settings, const Progress &progress) = 0;
    /// The error alone, for codecs that know it without coding anything; nothing for the others.
    virtual std::optional<Result<double>> quickKgError(const CodecSettings &, const Progress &) { return std::nullopt; }
};

/// \param source  outlives the result
/// Errors as encodeAnimation.
Result<std::unique_ptr<TrialEncoder>> prepareTrials(const FrameSource &source, CodecId codec, const Progress &progress);

} // namespace model::codec
