// SPDX-License-Identifier: GPL-3.0-or-later
// A file that comes in pieces: what is shown on the way, and that the end is what opening it whole gives.
#include "model/codec/container/progressivereader.h"
#include "tests/fuzz/animbytes.h"
#include "tests/fuzz/require.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace model;
using namespace model::codec;

namespace {

const DecodeLimits QuickMemory{std::uint64_t(12) << 20};

void checkShown(const DecodedAnimation &shown)
{
    const std::vector<Vec3f> first = shown.frame(0);
    for (const Vec3f &p : first)
        SANDREEL_REQUIRE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    const auto saved = decodeAnimation(shown.encoded(), Progress());
    SANDREEL_REQUIRE(saved.has_value());
    SANDREEL_REQUIRE((*saved)->frame(0) == first);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const Bytes file = tests::withChecksums({data, size});
    ProgressiveReader reader(QuickMemory);
    // Pieces that depend on the bytes alone: the same run for the same input.
    std::minstd_rand random(std::uint32_t(size) + (size > 0 ? data[size / 2] : 0u));
    std::uint32_t bands = 0;
    bool isRefused = false;
    for (std::size_t at = 0; at < file.size() && !isRefused;) {
        const std::size_t length = std::min<std::size_t>(1 + random() % 200, file.size() - at);
        isRefused = !reader.append(std::span(file).subspan(at, length));
        at += length;
        if (!isRefused && reader.isPlayable() && reader.bandCount() != bands) {
            bands = reader.bandCount();
            checkShown(*reader.animation());
        }
    }
    const auto whole = decodeAnimation(Bytes(file), Progress(), QuickMemory);
    SANDREEL_REQUIRE(reader.isComplete() == whole.has_value());
    if (whole)
        SANDREEL_REQUIRE(reader.animation()->frame(0) == (*whole)->frame(0));
    else if (!isRefused)
        SANDREEL_REQUIRE(whole.error().code == ErrorCode::Truncated || whole.error().code == ErrorCode::LimitExceeded ||
                         whole.error().code == ErrorCode::BadMagic);
    return 0;
}
