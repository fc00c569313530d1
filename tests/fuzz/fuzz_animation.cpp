// SPDX-License-Identifier: GPL-3.0-or-later
// A whole file of one codec (SANDREEL_FUZZ_CODEC), opened and played.
#include "model/codec/animationcodec.h"
#include "model/codec/container/container.h"
#include "tests/fuzz/animbytes.h"
#include "tests/fuzz/require.h"
#include "tests/support/scarcity.h"

#include <cmath>

using namespace model;
using namespace model::codec;

namespace {

/// Memory that most files may use: enough for thousands of vertices, little enough for thousands of files a second.
constexpr std::uint64_t QuickMemory = std::uint64_t(12) << 20;

void requireFinite(const DecodedAnimation &animation, std::uint32_t frame)
{
    for (const Vec3f &p : animation.frame(frame))
        SANDREEL_REQUIRE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const Bytes file = tests::withChecksums({data, size});
    DecodeLimits limits;
    if (const Result<Container> container = readContainer(file)) {
        if (container->header.codec != SANDREEL_FUZZ_CODEC)
            return 0;
        // One in 32 may use all that a stranger's file may.
        if (container->chunks[container->chunks.size() / 2].crc % 32 != 0)
            limits.memoryBytes = QuickMemory;
    }
    tests::AllocationMeter meter;
    const auto decoded = decodeAnimation(Bytes(file), Progress(), limits);
    SANDREEL_REQUIRE(meter.peak() <= limits.bytesFor(file.size()));
    if (!decoded) {
        SANDREEL_REQUIRE(decoded.error().offset != Error::None);
        SANDREEL_REQUIRE(decoded.error().offset <= file.size());
        return 0;
    }
    const DecodedAnimation &animation = **decoded;
    for (const Triangle &triangle : animation.connectivity().triangles)
        for (const std::uint32_t vertex : triangle)
            SANDREEL_REQUIRE(vertex < animation.vertexCount());
    requireFinite(animation, 0);
    requireFinite(animation, animation.frameCount() - 1);
    (void)animation.check(Progress());
    SANDREEL_REQUIRE(meter.peak() <= limits.bytesFor(file.size()));
    return 0;
}
