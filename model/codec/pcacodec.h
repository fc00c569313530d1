// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/animationcodec.h"
#include "model/codec/container.h"

namespace model::codec {

// The `pca` codec, FORMAT.md 5; arguments and errors as encodeAnimation and decodeAnimation, which have checked the
// settings and the container.
Result<EncodedAnimation> encodePca(const FrameSource &source, const CompressionSettings &settings,
                                   const Progress &progress);
Result<std::shared_ptr<const DecodedAnimation>> decodePca(Bytes file, const Container &container,
                                                          const DecodeLimits &limits, const Progress &progress);

} // namespace model::codec
