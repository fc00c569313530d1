// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/compressionsettings.h"
#include "model/animation/metrics.h"
#include "model/animation/normalisation.h"
#include "views/scene/framedata.h"

#include <QString>

namespace views {

/// All that is needed to make an `.anim` of an animation; plain values, for a worker.
struct EncodingOrder
{
    model::FrameSourcePtr frames;
    model::Normalisation normalisation = model::Normalisation::None;
    double frameRate = 25; ///< of the result; frames are not resampled
    QString name;
    model::CompressionSettings settings;
    QString output;
};

/// What came of it.
struct EncodingReport
{
    EncodingOrder order;  ///< without its frames
    OriginalPtr original; ///< what the file was made of, normalised, in the file's order of vertices
    std::uint64_t fileBytes = 0;
    std::uint64_t rawBytes = 0; ///< the positions as float32
    double bitsPerFrameAndVertex = 0;
    model::ComparisonResult errors; ///< against the normalised animation, in its units
    double encodingSeconds = 0;     ///< without the measuring of the errors
};

/// Normalises, encodes, decodes again to measure what was lost, and only then writes the file: an error or a cancel
/// leaves what was there before.
/// Errors as codec::encodeAnimation, compareAnimations, io::saveBytes.
model::Result<EncodingReport> encodeToFile(const EncodingOrder &order, const model::Progress &progress);

} // namespace views
