// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/metrics.h"
#include "model/animation/qualitytarget.h"
#include "model/codec/trialencoder.h"

#include <functional>

namespace model::codec {

/// Called with every trial of a search, from the thread that searches.
using TrialObserver = std::function<void(const Trial &)>;

/// The smallest file within an error, or the least error within a size, that a codec's settings give.
/// \param target  not MaxVertexError, which no trial shows: encodeToTarget decodes for it
/// \error BadSetting  a target outside its range, or one that no settings of the codec reach
/// Others as encodeAnimation. Deterministic: the same animation and target give the same settings.
/// Cost: some 10 to 60 trials, each about an encoding without its analysis.
Result<Trial> searchSettings(TrialEncoder &encoder, const QualityTarget &target, const Progress &progress,
                             const TrialObserver &observe = {});

/// What the search found and made of it.
struct TargetedEncoding
{
    EncodedAnimation encoded;
    CompressionSettings settings;
    ComparisonResult errors; ///< measured on what a decoder shows
};

/// Searches settings for `target`, encodes, decodes again and measures: the result keeps to the target as measured.
/// \param encoder  prepared for `source`
/// Errors as searchSettings.
Result<TargetedEncoding> encodeToTarget(const FrameSource &source, TrialEncoder &encoder, bool keepOrder,
                                        const QualityTarget &target, const Progress &progress,
                                        const TrialObserver &observe = {});
Result<TargetedEncoding> encodeToTarget(const FrameSource &source, CodecId codec, bool keepOrder,
                                        const QualityTarget &target, const Progress &progress = Progress(),
                                        const TrialObserver &observe = {});

} // namespace model::codec
