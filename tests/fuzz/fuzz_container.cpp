// SPDX-License-Identifier: GPL-3.0-or-later
// Chunks and header; the codecs only as far as they refuse.
#include "model/codec/animationcodec.h"
#include "model/codec/container/container.h"
#include "tests/fuzz/animbytes.h"
#include "tests/fuzz/require.h"
#include "tests/support/scarcity.h"

using namespace model;
using namespace model::codec;

namespace {

void check(const Bytes &file)
{
    tests::AllocationMeter meter;
    const Result<Container> container = readContainer(file);
    const auto chunks = listChunks(file);
    // What a chunk of a byte takes in the list of them is less than this.
    SANDREEL_REQUIRE(meter.peak() <= (std::uint64_t(1) << 20) + 64 * file.size());
    SANDREEL_REQUIRE(container.has_value() == chunks.has_value());
    if (!container) {
        SANDREEL_REQUIRE(container.error().offset != Error::None);
        SANDREEL_REQUIRE(container.error().offset <= file.size());
        return;
    }
    std::uint64_t sum = Magic.size();
    for (const ChunkInfo &chunk : *chunks)
        sum += chunk.bytes;
    SANDREEL_REQUIRE(sum == file.size());

    // Another name, and back.
    const auto renamed = withNameAndRate(file, "another", 12);
    SANDREEL_REQUIRE(renamed.has_value());
    const Result<Container> after = readContainer(*renamed);
    SANDREEL_REQUIRE(after.has_value());
    SANDREEL_REQUIRE(after->header.name == "another" && after->chunks.size() == container->chunks.size());
    const auto back = withNameAndRate(*renamed, container->header.name, container->header.frameRate);
    SANDREEL_REQUIRE(back.has_value());
    const Result<Container> again = readContainer(*back);
    SANDREEL_REQUIRE(again.has_value() && again->chunks.size() == container->chunks.size());
    for (std::size_t i = 0; i < again->chunks.size(); ++i) {
        const Chunk &a = container->chunks[i], &b = again->chunks[i];
        SANDREEL_REQUIRE(a.tag == b.tag);
        if (i > 0) // a header may have been written in a longer form than ours
            SANDREEL_REQUIRE(std::equal(a.payload.begin(), a.payload.end(), b.payload.begin(), b.payload.end()));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    check(Bytes(data, data + size));
    check(tests::withChecksums({data, size}));
    return 0;
}
