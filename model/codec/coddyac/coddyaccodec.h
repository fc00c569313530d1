// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/animationcodec.h"
#include "model/codec/container/container.h"
#include "model/codec/trialencoder.h"

namespace model::codec {

// The `coddyac` codec, FORMAT.md 14; arguments and errors as encodeAnimation and decodeAnimation, which have checked
// the settings and the container.
Result<EncodedAnimation> encodeCoddyac(const FrameSource &source, const CoddyacSettings &settings, bool keepOrder,
                                       const Progress &progress);
Result<std::shared_ptr<const DecodedAnimation>> decodeCoddyac(Bytes file, const Container &container,
                                                              const DecodeLimits &limits, const Progress &progress);

/// Trials of `coddyac`: a family for each basis size, from coarse to fine steps.
Result<std::unique_ptr<TrialEncoder>> prepareCoddyacTrials(const FrameSource &source, const Progress &progress);

} // namespace model::codec
