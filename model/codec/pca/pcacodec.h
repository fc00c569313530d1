// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/animationcodec.h"
#include "model/codec/basis/principalbasis.h"
#include "model/codec/container/container.h"
#include "model/codec/trialencoder.h"

namespace model::codec {

// The `pca` codec, FORMAT.md 5; arguments and errors as encodeAnimation and decodeAnimation, which have checked the
// settings and the container.
Result<EncodedAnimation> encodePca(const FrameSource &source, const PcaSettings &settings, const Progress &progress);
/// The bytes of the file, of an animation already quantised. \error Cancelled
Result<Bytes> assemblePca(const FrameSource &source, const PcaSettings &settings, const QuantizedPca &pca,
                          const Bytes &indices, const Progress &progress);
Result<std::shared_ptr<const DecodedAnimation>> decodePca(Bytes file, const Container &container,
                                                          const DecodeLimits &limits, const Progress &progress);

/// Trials of `pca`: a family for each basis size, from coarse to fine resolutions.
Result<std::unique_ptr<TrialEncoder>> preparePcaTrials(const FrameSource &source, const Progress &progress);

} // namespace model::codec
