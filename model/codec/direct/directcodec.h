// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/animationcodec.h"
#include "model/codec/container.h"

namespace model::codec {

// The `direct` codec, FORMAT.md 11; arguments and errors as encodeAnimation and decodeAnimation, which have checked the
// settings and the container.
Result<EncodedAnimation> encodeDirect(const FrameSource &source, const DirectSettings &settings,
                                      const Progress &progress);
Result<std::shared_ptr<const DecodedAnimation>> decodeDirect(Bytes file, const Container &container,
                                                             const DecodeLimits &limits, const Progress &progress);

} // namespace model::codec
