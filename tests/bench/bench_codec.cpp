// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/animationcodec.h"
#include "model/codec/kernels.h"
#include "tests/model/codec/animations.h"
#include "tests/support/realdata.h"

#include <benchmark/benchmark.h>

#include <map>

using namespace model;
using namespace model::codec;

namespace {

/// A real sequence, read once; null without SANDREEL_DATA.
const tests::PlainAnimation *realSequence(const std::string &name)
{
    static std::map<std::string, std::shared_ptr<tests::PlainAnimation>> known;
    if (tests::dataFolder().isEmpty())
        return nullptr;
    auto &animation = known[name];
    if (!animation)
        animation = tests::readPointCache(tests::sequenceFolder(QString::fromStdString(name)).toStdString());
    return animation.get();
}

CompressionSettings settingsOf(std::int64_t basisSize, std::int64_t resolution)
{
    CompressionSettings settings;
    settings.basisSize = std::uint32_t(basisSize);
    settings.resolution = double(resolution);
    return settings;
}

void encode(benchmark::State &state, const FrameSource &source)
{
    std::size_t bytes = 0;
    for (auto _ : state)
        bytes = encodeAnimation(source, settingsOf(20, 10000))->bytes.size();
    state.counters["bpfv"] = 8.0 * double(bytes) / source.frameCount() / source.vertexCount();
}

void encodeDance(benchmark::State &state)
{
    if (const auto *dance = realSequence("dance"))
        encode(state, *dance);
    else
        state.SkipWithError("SANDREEL_DATA is not set");
}
BENCHMARK(encodeDance)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

void encodeJumpSized(benchmark::State &state)
{
    const auto source = tests::waves(222, 16000, 40);
    encode(state, source);
}
BENCHMARK(encodeJumpSized)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

/// 35k vertices x 187 frames, basis 20.
const Bytes &largeFile()
{
    static const Bytes file = encodeAnimation(tests::waves(187, 35000, 40), settingsOf(20, 10000))->bytes;
    return file;
}

void openToFirstFrame(benchmark::State &state)
{
    const Bytes &file = largeFile();
    std::vector<Vec3f> frame(35000);
    std::size_t memory = 0;
    for (auto _ : state) {
        const auto animation = decodeAnimation(file);
        (*animation)->positions(0, frame);
        memory = (*animation)->memoryBytes();
    }
    state.counters["file_kB"] = double(file.size()) / 1e3;
    state.counters["memory_MB"] = double(memory) / 1e6;
    state.counters["allowed_MB"] = 12.0 * ((3 * 187 + 35000) * 20 + 10 * 35000) / 1e6;
}
BENCHMARK(openToFirstFrame)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

void oneFrame(benchmark::State &state)
{
    const auto animation = *decodeAnimation(largeFile());
    std::vector<Vec3f> frame(35000);
    std::uint32_t index = 0;
    for (auto _ : state) {
        animation->positions(index, frame);
        index = (index + 67) % animation->frameCount();
    }
    state.SetLabel(kernels().name);
}
BENCHMARK(oneFrame)->Unit(benchmark::kMicrosecond);

/// Size and error over basis size and resolution: the table of model/codec/README.md.
void rate(benchmark::State &state, const std::string &name, bool normalise)
{
    const auto *read = realSequence(name);
    if (!read) {
        state.SkipWithError("SANDREEL_DATA is not set");
        return;
    }
    const tests::PlainAnimation source = normalise ? tests::normalised(*read) : *read;
    Bytes bytes;
    for (auto _ : state)
        bytes = encodeAnimation(source, settingsOf(state.range(0), state.range(1)))->bytes;
    state.counters["bpfv"] = 8.0 * double(bytes.size()) / source.frameCount() / source.vertexCount();
    state.counters["kg_percent"] = tests::kgErrorPercent(source, **decodeAnimation(bytes));
}

void allRates(benchmark::internal::Benchmark *benchmark)
{
    for (const int resolution : {300, 1000, 3000, 10000, 100000})
        for (const int basisSize : {10, 20, 30, 40, 50})
            benchmark->Args({basisSize, resolution});
    benchmark->Unit(benchmark::kMillisecond)->Iterations(1);
}
/// 200 encodings: only where there are sequences to encode.
const bool registered = [] {
    if (tests::dataFolder().isEmpty())
        return false;
    for (const std::string name : {"chicken", "cow", "dance", "samba"})
        for (const bool normalise : {true, false})
            benchmark::RegisterBenchmark(("rate/" + name + (normalise ? "" : "AsItIs")).c_str(), rate, name, normalise)
                ->Apply(allRates);
    return true;
}();

} // namespace
