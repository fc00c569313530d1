// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/filefacts.h"

namespace views {

FileFacts factsOf(const model::codec::DecodedAnimation &animation)
{
    return {.bytes = animation.encodedBytes(),
            .frameCount = animation.frameCount(),
            .vertexCount = animation.vertexCount(),
            .settings = animation.settings(),
            .basisSize = animation.basisSize(),
            .creator = animation.creator(),
            .chunks = model::codec::listChunks(animation.encoded()).value_or(std::vector<model::codec::ChunkInfo>())};
}

} // namespace views
