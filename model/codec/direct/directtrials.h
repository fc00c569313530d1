// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/trialencoder.h"

namespace model::codec {

/// Trials of `direct`: one family, the predictor N with the range coder, from a resolution of 4 to 2^24.
Result<std::unique_ptr<TrialEncoder>> prepareDirectTrials(const FrameSource &source, const Progress &progress);

} // namespace model::codec
