// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/settingsfields.h"
#include "model/codec/basis/kernels.h"
#include "model/codec/ratecontrol.h"
#include "model/io/animationreader.h"
#include "tests/model/codec/animations.h"
#include "tests/support/realdata.h"

#include <benchmark/benchmark.h>

#include <QFileInfo>

#include <chrono>
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

/// Any of the sequences, as the program reads it. Precondition: SANDREEL_DATA is set.
FrameSourcePtr anySequence(const std::string &name)
{
    static std::map<std::string, FrameSourcePtr> known;
    auto &animation = known[name];
    const QString folder = tests::sequenceFolder(QString::fromStdString(name));
    const QString cache = folder + u'/' + QString::fromStdString(name) + QStringLiteral(".pc2");
    if (!animation)
        animation = *io::readAnimation(QFileInfo::exists(cache) ? cache : folder);
    return animation;
}

CompressionSettings settingsOf(std::int64_t basisSize, std::int64_t resolution)
{
    return {PcaSettings{std::uint32_t(basisSize), double(resolution)}};
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
/// Sizes of `direct`: the table of model/codec/README.md. Arguments: resolution, predictor, entropy coder.
void direct(benchmark::State &state, const std::string &name)
{
    const auto source = anySequence(name);
    const CompressionSettings settings{
        DirectSettings{std::uint32_t(state.range(0)), Predictor(state.range(1)), Entropy(state.range(2))}};
    Bytes bytes;
    for (auto _ : state)
        bytes = encodeAnimation(*source, settings)->bytes;
    state.counters["bpfv"] = 8.0 * double(bytes.size()) / source->frameCount() / source->vertexCount();
    state.SetLabel(settingsText(settings));
    std::vector<Vec3f> frame(source->vertexCount());
    const auto begin = std::chrono::steady_clock::now();
    const auto decoded = *decodeAnimation(bytes);
    for (std::uint32_t f = 0; f < decoded->frameCount(); ++f)
        decoded->positions(f, frame);
    state.counters["decode_all_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void directSettings(benchmark::internal::Benchmark *benchmark)
{
    benchmark->ArgsProduct({{1024, 4096, 16384}, {0, 1, 2, 3, 4}, {0, 1}});
    benchmark->Unit(benchmark::kMillisecond)->Iterations(1)->UseRealTime();
}

/// Settings searched for a KG error in hundredths of a per cent, by codec.
void target(benchmark::State &state, const std::string &name)
{
    const auto source = anySequence(name);
    Result<TargetedEncoding> result;
    for (auto _ : state)
        result = encodeToTarget(*source, CodecId(state.range(0)), false, MaxKgError{double(state.range(1)) / 100});
    if (!result) {
        state.SkipWithError("not to be reached");
        return;
    }
    state.SetLabel(settingsText(result->settings));
    state.counters["bpfv"] = 8.0 * double(result->encoded.bytes.size()) / source->frameCount() / source->vertexCount();
    state.counters["kg_percent"] = result->errors.kgErrorPercent;
}

void targets(benchmark::internal::Benchmark *benchmark)
{
    for (const CodecId codec : availableCodecs())
        for (const int percent : {500, 100, 10})
            benchmark->Args({int(codec), percent});
    benchmark->Unit(benchmark::kMillisecond)->Iterations(1)->UseRealTime();
}

/// 200 encodings: only where there are sequences to encode.
const bool registered = [] {
    if (tests::dataFolder().isEmpty())
        return false;
    for (const std::string name : {"chicken", "cow", "dance", "samba"})
        for (const bool normalise : {true, false})
            benchmark::RegisterBenchmark(("rate/" + name + (normalise ? "" : "AsItIs")).c_str(), rate, name, normalise)
                ->Apply(allRates);
    for (const std::string name : {"chicken", "cow", "dance", "samba", "horse-gallop"}) {
        benchmark::RegisterBenchmark(("direct/" + name).c_str(), direct, name)->Apply(directSettings);
        benchmark::RegisterBenchmark(("target/" + name).c_str(), target, name)->Apply(targets);
    }
    return true;
}();

} // namespace
