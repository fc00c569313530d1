// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/positionmemory.h"

#include "model/io/failure.h"

#include <new>

namespace model::io {

Result<std::vector<Vec3f>> positionMemory(std::uint64_t vertexCount, std::uint64_t frameCount)
{
    // Both counts are below 2^32, but 12 times their product need not fit.
    if (frameCount && vertexCount > MaxPositionBytes / sizeof(Vec3f) / frameCount) {
        return fail(ErrorCode::LimitExceeded, QT_TRANSLATE_NOOP("ErrorText", "the number of vertices times frames"),
                    std::to_string(vertexCount) + " x " + std::to_string(frameCount),
                    std::to_string(MaxPositionBytes / sizeof(Vec3f)));
    }
    try {
        return std::vector<Vec3f>(std::size_t(vertexCount * frameCount));
    } catch (const std::bad_alloc &) {
        return fail(ErrorCode::OutOfMemory, std::to_string(vertexCount * frameCount * sizeof(Vec3f)));
    }
}

} // namespace model::io
