// SPDX-License-Identifier: GPL-3.0-or-later
// Any small animation through each codec: opens again, in the same order as the permutation says, the same bytes twice.
// Input: codec, vertices, frames, settings, triangles and positions, a byte or two each.
#include "model/codec/animationcodec.h"
#include "tests/fuzz/bytesource.h"
#include "tests/fuzz/require.h"
#include "tests/model/codec/animations.h"

#include <algorithm>
#include <cmath>

using namespace model;
using namespace model::codec;

namespace {

CompressionSettings settingsOf(tests::ByteSource &in)
{
    CompressionSettings settings;
    settings.method = defaultSettings(availableCodecs()[in.u8() % availableCodecs().size()]);
    const std::uint8_t choice = in.u8();
    settings.keepOrder = choice & 1;
    const std::uint32_t size = choice / 2 % 8 + 1u;
    const double step = std::pow(10, -(choice / 16) / 2.5);
    if (auto *pca = std::get_if<PcaSettings>(&settings.method))
        *pca = {size, 1 / step};
    else if (auto *coddyac = std::get_if<CoddyacSettings>(&settings.method))
        *coddyac = {size, step, step};
    else if (auto *reel = std::get_if<ReelSettings>(&settings.method))
        *reel = {step, size - 1};
    else if (auto *direct = std::get_if<DirectSettings>(&settings.method))
        *direct = {std::uint32_t(4 / step), Predictor(size % 5), Entropy(choice >> 7)};
    return settings;
}

std::vector<Triangle> canonical(const std::vector<Triangle> &triangles, const std::vector<std::uint32_t> &names)
{
    std::vector<Triangle> result;
    for (const Triangle &t : triangles) {
        Triangle &named = result.emplace_back(Triangle{names[t[0]], names[t[1]], names[t[2]]});
        std::rotate(named.begin(), std::min_element(named.begin(), named.end()), named.end());
    }
    std::sort(result.begin(), result.end());
    return result;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    tests::ByteSource in({data, size});
    const CompressionSettings settings = settingsOf(in);
    const std::uint32_t vertices = in.u8() % 24 + 1u, frames = in.u8() % 40 + 1u;
    const std::uint32_t triangleCount = in.u8() % 48;
    std::vector<Triangle> triangles;
    for (std::uint32_t t = 0; t < triangleCount; ++t)
        triangles.push_back({in.below(vertices), in.below(vertices), in.below(vertices)});
    const float unit = float(std::pow(10, in.u8() % 40 - 20));
    tests::PlainAnimation source(frames, vertices, std::move(triangles), [&](std::uint32_t, std::uint32_t) {
        const auto coordinate = [&] { return float(in.integer(20)) * unit; };
        return Vec3f{coordinate(), coordinate(), coordinate()};
    });

    const auto encoded = encodeAnimation(source, settings);
    if (!encoded) { // pca's resolution is absolute
        SANDREEL_REQUIRE(encoded.error().code == ErrorCode::LimitExceeded);
        return 0;
    }
    SANDREEL_REQUIRE(encodeAnimation(source, settings)->bytes == encoded->bytes);
    SANDREEL_REQUIRE(encoded->permutation.size() == vertices);
    const auto decoded = decodeAnimation(encoded->bytes);
    SANDREEL_REQUIRE(decoded.has_value());
    SANDREEL_REQUIRE((*decoded)->frameCount() == frames && (*decoded)->settings().method == settings.method);
    std::vector<std::uint32_t> names(vertices);
    for (std::uint32_t v = 0; v < vertices; ++v)
        names[v] = v;
    SANDREEL_REQUIRE(canonical((*decoded)->connectivity().triangles, encoded->permutation) ==
                     canonical(source.connectivity().triangles, names));
    SANDREEL_REQUIRE((*decoded)->check(Progress()).has_value());
    for (std::uint32_t f = 0; f < frames; ++f)
        for (const Vec3f &p : (*decoded)->frame(f))
            SANDREEL_REQUIRE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    return 0;
}
