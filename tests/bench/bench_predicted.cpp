// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/connectivity/connectivitystage.h"
#include "model/codec/entropy/rangecoder.h"
#include "model/codec/ratecontrol.h"
#include "model/io/animationreader.h"
#include "tests/model/codec/animations.h"
#include "tests/support/realdata.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

// The codecs that predict over the mesh, and their stages.

using namespace model;
using namespace model::codec;

namespace {

FrameSourcePtr dance()
{
    static const FrameSourcePtr animation = *io::readAnimation(tests::sequenceFolder("dance") + "/dance.pc2");
    return animation;
}

/// Fixed settings. Argument: the codec.
void encodeDanceFixed(benchmark::State &state)
{
    if (tests::dataFolder().isEmpty()) {
        state.SkipWithError("SANDREEL_DATA is not set");
        return;
    }
    const CompressionSettings settings{defaultSettings(CodecId(state.range(0)))};
    std::size_t bytes = 0;
    for (auto _ : state)
        bytes = encodeAnimation(*dance(), settings)->bytes.size();
    state.counters["bpfv"] = 8.0 * double(bytes) / dance()->frameCount() / dance()->vertexCount();
}
BENCHMARK(encodeDanceFixed)->Arg(3)->Arg(4)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

/// 35k vertices x 187 frames.
const tests::PlainAnimation &large()
{
    static const tests::PlainAnimation animation = tests::waves(187, 35000, 40);
    return animation;
}

/// A grid with its vertices and triangles as a scanner would leave them: rows, alternating diagonals.
Connectivity grid(std::uint32_t width, std::uint32_t height)
{
    Connectivity mesh{width * height, {}};
    for (std::uint32_t y = 0; y + 1 < height; ++y)
        for (std::uint32_t x = 0; x + 1 < width; ++x) {
            const std::uint32_t a = y * width + x, b = a + 1, c = a + width, d = c + 1;
            if ((x * 7 + y * 13) % 3 == 0) {
                mesh.triangles.push_back({a, b, d});
                mesh.triangles.push_back({a, d, c});
            } else {
                mesh.triangles.push_back({a, b, c});
                mesh.triangles.push_back({b, d, c});
            }
        }
    return mesh;
}

/// The same size, with 20 parts of a sheet that swing each at its own rate: so many trajectories count.
tests::PlainAnimation swings()
{
    constexpr std::uint32_t Width = 200, Height = 175, Frames = 187;
    constexpr unsigned Parts = 20;
    std::vector<float> shares(std::size_t(Width) * Height * Parts), turns(std::size_t(Frames) * Parts);
    for (unsigned part = 0; part < Parts; ++part) {
        const double x0 = Width * (part % 5 + 0.5) / 5, y0 = Height * (part / 5 + 0.5) / 4;
        for (std::uint32_t v = 0; v < Width * Height; ++v)
            shares[v * Parts + part] =
                float(std::exp(-(std::pow(v % Width - x0, 2) + std::pow(v / Width - y0, 2)) / 500));
        for (std::uint32_t f = 0; f < Frames; ++f)
            turns[f * Parts + part] = float(8 * std::sin(0.03 * (part + 3) * f + part));
    }
    return {Frames, Width * Height, grid(Width, Height).triangles, [&](std::uint32_t f, std::uint32_t v) {
                float height = 0;
                for (unsigned part = 0; part < Parts; ++part)
                    height += shares[v * Parts + part] * turns[f * Parts + part];
                return Vec3f{float(v % Width), float(v / Width), height};
            }};
}

void decodeReelToAnyFrame(benchmark::State &state)
{
    const Bytes file = encodeAnimation(swings(), {ReelSettings{0.002, 20}})->bytes;
    std::vector<Vec3f> frame(35000);
    std::uint32_t basisSize = 0;
    for (auto _ : state) {
        const auto animation = *decodeAnimation(file);
        animation->positions(100, frame);
        basisSize = animation->basisSize();
    }
    state.counters["basis"] = basisSize;
    state.counters["file_kB"] = double(file.size()) / 1e3;
}
BENCHMARK(decodeReelToAnyFrame)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

void encodeLargeToOnePercent(benchmark::State &state)
{
    std::size_t bytes = 0;
    for (auto _ : state)
        bytes = encodeToTarget(large(), CodecId::Reel, false, MaxKgError{1})->encoded.bytes.size();
    state.counters["bpfv"] = 8.0 * double(bytes) / 187 / 35000;
}
BENCHMARK(encodeLargeToOnePercent)->Unit(benchmark::kSecond)->Iterations(1)->UseRealTime();

/// Arguments: vertices along a side; whether vertices and triangles are in a random order, as no program writes them,
/// but the worst for the memory.
Connectivity orderedGrid(const benchmark::State &state)
{
    Connectivity mesh = grid(std::uint32_t(state.range(0)), std::uint32_t(state.range(0)));
    if (!state.range(1))
        return mesh;
    std::mt19937 random(1);
    std::vector<std::uint32_t> names(mesh.vertexCount);
    std::iota(names.begin(), names.end(), 0u);
    std::shuffle(names.begin(), names.end(), random);
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
    for (Triangle &triangle : mesh.triangles)
        for (std::uint32_t &vertex : triangle)
            vertex = names[vertex];
    return mesh;
}

void connectivityArguments(benchmark::internal::Benchmark *benchmark)
{
    benchmark->ArgNames({"side", "shuffled"})->Args({708, 0})->Args({2237, 0})->Args({708, 1})->Args({2237, 1});
    benchmark->Unit(benchmark::kMillisecond)->UseRealTime();
}

void encodeConnectivity(benchmark::State &state)
{
    const Connectivity mesh = orderedGrid(state);
    std::size_t bytes = 0;
    for (auto _ : state)
        bytes = codec::encodeConnectivity(mesh, Progress())->bytes.size();
    state.SetItemsProcessed(state.iterations() * std::int64_t(mesh.triangles.size()));
    state.counters["bits_per_triangle"] = 8.0 * double(bytes) / double(mesh.triangles.size());
}
BENCHMARK(encodeConnectivity)->Apply(connectivityArguments);

void decodeConnectivity(benchmark::State &state)
{
    const Connectivity mesh = orderedGrid(state);
    const Bytes bytes = codec::encodeConnectivity(mesh, Progress())->bytes;
    Chunk chunk;
    chunk.payload = bytes;
    for (auto _ : state)
        benchmark::DoNotOptimize(codec::decodeConnectivity(
            chunk, mesh.vertexCount, std::uint32_t(mesh.triangles.size()), ~std::uint64_t(0), Progress()));
    state.SetItemsProcessed(state.iterations() * std::int64_t(mesh.triangles.size()));
}
BENCHMARK(decodeConnectivity)->Apply(connectivityArguments);

/// Decisions in 16 contexts, one in eight of them 1.
void decodeDecisions(benchmark::State &state)
{
    constexpr std::size_t Count = 1u << 22;
    RangeEncoder encoder;
    std::array<AdaptiveBit, 16> writing;
    std::uint32_t random = 1;
    for (std::size_t i = 0; i < Count; ++i) {
        random = random * 1664525 + 1013904223;
        encoder.bit(writing[i % 16], random >> 29 == 0);
    }
    const Bytes bytes = encoder.finish();
    for (auto _ : state) {
        RangeDecoder decoder(bytes);
        std::array<AdaptiveBit, 16> reading;
        std::uint32_t ones = 0;
        for (std::size_t i = 0; i < Count; ++i)
            ones += decoder.bit(reading[i % 16]);
        benchmark::DoNotOptimize(ones);
    }
    state.SetItemsProcessed(state.iterations() * std::int64_t(Count));
}
BENCHMARK(decodeDecisions)->Unit(benchmark::kMillisecond);

} // namespace
