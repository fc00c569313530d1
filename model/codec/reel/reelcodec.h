// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/animationcodec.h"
#include "model/codec/container/container.h"
#include "model/codec/reel/reelencoder.h"
#include "model/codec/trialencoder.h"

namespace model::codec {

// The `reel` codec, FORMAT.md 13; arguments and errors as encodeAnimation and decodeAnimation, which have checked the
// settings and the container.
Result<EncodedAnimation> encodeReel(const FrameSource &source, const ReelSettings &settings, bool keepOrder,
                                    const Progress &progress);
Result<std::shared_ptr<const DecodedAnimation>> decodeReel(Bytes file, const Container &container,
                                                           const DecodeLimits &limits, const Progress &progress);

/// The file of what an encoder of `source` chose. \error Cancelled
Result<EncodedAnimation> assembleReel(const FrameSource &source, const ReelEncoder &encoder, const ReelChoice &choice,
                                      bool keepOrder, const Progress &progress);

/// Trials of `reel`: one family, from coarse to fine steps.
Result<std::unique_ptr<TrialEncoder>> prepareReelTrials(const FrameSource &source, const Progress &progress);

} // namespace model::codec
