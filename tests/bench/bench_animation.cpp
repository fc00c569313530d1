// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/editedframes.h"
#include "model/animation/hausdorff.h"
#include "model/animation/metrics.h"
#include "model/animation/normalisation.h"
#include "model/animation/sequence.h"
#include "model/animation/sted.h"
#include "tests/support/meshes.h"

#include <benchmark/benchmark.h>

using namespace model;

namespace {

/// As large as the largest of the real sequences in vertices: 35k.
std::shared_ptr<const Sequence> large(std::uint32_t frameCount)
{
    constexpr std::uint32_t VertexCount = 35'000;
    std::vector<Vec3f> positions(std::size_t(VertexCount) * frameCount);
    for (std::size_t i = 0; i < positions.size(); ++i)
        positions[i] = {float(i % 1009) * 0.001f, float(i % 757) * 0.002f, float(i % 499) * 0.003f};
    return std::make_shared<Sequence>(Connectivity{VertexCount, {}}, std::move(positions));
}

void editedFrame(benchmark::State &state, double position, const Similarity &placement)
{
    const EditedFrames frames(large(2), TimeMap({position}), placement, 25, "");
    std::vector<Vec3f> out(frames.vertexCount());
    for (auto _ : state)
        frames.positions(0, out);
}
const Similarity Moved{0.5, {1, 2, 3}};
BENCHMARK_CAPTURE(editedFrame, untouched, 1, Similarity{})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(editedFrame, placed, 1, Moved)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(editedFrame, blended, 0.5, Similarity{})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(editedFrame, blendedAndPlaced, 0.5, Moved)->Unit(benchmark::kMicrosecond);

void resampleMillion(benchmark::State &state)
{
    const TimeMap map = TimeMap::identity(10'000);
    for (auto _ : state)
        benchmark::DoNotOptimize(map.resampled(1, 100));
}
BENCHMARK(resampleMillion)->Unit(benchmark::kMillisecond);

void digest(benchmark::State &state)
{
    const auto source = large(187);
    for (auto _ : state) {
        state.PauseTiming(); // a sequence keeps its digest
        const Sequence fresh(source->connectivity(), {source->allPositions().begin(), source->allPositions().end()});
        state.ResumeTiming();
        benchmark::DoNotOptimize(fresh.digest());
    }
    state.SetBytesProcessed(std::int64_t(state.iterations()) * std::int64_t(source->allPositions().size_bytes()));
}
BENCHMARK(digest)->Unit(benchmark::kMillisecond);

void compare(benchmark::State &state)
{
    const auto source = large(187);
    for (auto _ : state)
        benchmark::DoNotOptimize(compareAnimations(*source, *source));
}
BENCHMARK(compare)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A sheet of 35k vertices, and the same with every vertex a little off.
std::pair<tests::SequencePtr, tests::SequencePtr> sheets()
{
    const tests::SequencePtr sheet = tests::wave(tests::grid(186, 186), 20);
    std::vector<Vec3f> positions(sheet->allPositions().begin(), sheet->allPositions().end());
    for (std::size_t i = 0; i < positions.size(); ++i)
        positions[i] = positions[i] + Vec3f{float(i % 13), float(i % 17), float(i % 19)} * 1e-4f;
    return {sheet, std::make_shared<Sequence>(sheet->connectivity(), std::move(positions))};
}

void sted(benchmark::State &state)
{
    const auto [source, test] = sheets();
    for (auto _ : state)
        benchmark::DoNotOptimize(spatioTemporalDifference(*source, *test));
}
BENCHMARK(sted)->Unit(benchmark::kMillisecond)->UseRealTime();

void hausdorff(benchmark::State &state)
{
    const auto [source, test] = sheets();
    for (auto _ : state)
        benchmark::DoNotOptimize(hausdorffDistance(*source, *test, {}, double(state.range(0))));
}
BENCHMARK(hausdorff)->Arg(0)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

void boxOfAll(benchmark::State &state)
{
    const auto source = large(187);
    for (auto _ : state)
        benchmark::DoNotOptimize(boundingBoxOfAll(*source));
}
BENCHMARK(boxOfAll)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
