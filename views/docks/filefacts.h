// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/animationcodec.h"

#include <cstdint>
#include <string>
#include <vector>

namespace views {

/// What is known of an `.anim` file; a value, so that it outlives the animation that it tells about.
struct FileFacts
{
    std::uint64_t bytes = 0;
    std::uint32_t frameCount = 0;
    std::uint32_t vertexCount = 0;
    model::CompressionSettings settings;
    std::uint32_t basisSize = 0; ///< vectors kept
    std::string creator;
    std::vector<model::codec::ChunkInfo> chunks;

    /// As float32 positions, without the connectivity.
    std::uint64_t rawBytes() const { return std::uint64_t(frameCount) * vertexCount * 12; }
    double ratio() const { return bytes ? double(rawBytes()) / double(bytes) : 0; }
    /// Bits per vertex and frame.
    double bitsPerVertexFrame() const
    {
        const double count = double(frameCount) * vertexCount;
        return count > 0 ? 8.0 * double(bytes) / count : 0;
    }
};

FileFacts factsOf(const model::codec::DecodedAnimation &animation);

} // namespace views
