// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/hausdorff.h"
#include "model/animation/metrics.h"
#include "model/animation/settingsfields.h"
#include "model/animation/sted.h"
#include "model/codec/ratecontrol.h"
#include "model/io/animationreader.h"
#include "model/io/animationwriter.h"
#include "model/mesh/softwareraster.h"
#include "tests/model/codec/animations.h"
#include "tests/support/realdata.h"

#include <benchmark/benchmark.h>

#include <QDir>
#include <QTemporaryDir>

#include <chrono>
#include <future>
#include <random>

// How long work goes on after it was cancelled: at most 100 ms is promised (model/base/progress.h). Each job is run to
// its end once, then cancelled at random moments of that time; `latency_max_ms` is the longest that it took to return.

using namespace model;
using namespace model::codec;

namespace {

using Clock = std::chrono::steady_clock;
/// Returns whether it was stopped.
using Work = std::function<bool(const Progress &)>;

constexpr int Cancels = 40;

double milliseconds(Clock::duration duration)
{
    return std::chrono::duration<double, std::milli>(duration).count();
}

void cancel(benchmark::State &state, const std::function<Work()> &prepare)
{
    const Work work = prepare();
    const auto begin = Clock::now();
    work(Progress());
    const auto whole = Clock::now() - begin;
    std::mt19937 random(1);
    double longest = 0;
    int stopped = 0;
    for (auto _ : state) {
        const double share = double(random()) / double(std::mt19937::max());
        const Progress progress;
        auto running = std::async(std::launch::async, [&] { return work(progress); });
        running.wait_for(whole * share);
        const auto asked = Clock::now();
        progress.cancel();
        running.wait();
        const double latency = milliseconds(Clock::now() - asked);
        state.SetIterationTime(latency / 1000);
        longest = std::max(longest, latency);
        stopped += running.get();
    }
    state.counters["latency_max_ms"] = longest;
    state.counters["stopped"] = stopped;
    state.counters["whole_ms"] = milliseconds(whole);
}

template <class T>
bool isStopped(const Result<T> &result)
{
    return !result && result.error().code == ErrorCode::Cancelled;
}

FrameSourcePtr dance()
{
    static const FrameSourcePtr animation = *io::readAnimation(tests::sequenceFolder("dance") + "/dance.pc2");
    return animation;
}

Work reading(const QString &path)
{
    return [path](const Progress &progress) { return isStopped(io::readAnimation(path, {}, progress)); };
}

Work encoding(const CodecSettings &method)
{
    return [method](const Progress &progress) { return isStopped(encodeAnimation(*dance(), {method}, progress)); };
}

/// The dance as OBJ frames, 80 MB of text, for as long as the program runs.
QString objFolder()
{
    static const QTemporaryDir folder;
    static const bool written = io::writeFrames(folder.filePath("dance"), *dance(), io::MeshFormat::Obj).has_value();
    return written ? folder.filePath("dance") : QString();
}

/// Another animation of the same mesh, to compare with.
FrameSourcePtr decodedDance()
{
    static const FrameSourcePtr animation = *decodeAnimation(encodeAnimation(*dance(), {PcaSettings()})->bytes);
    return animation;
}

void add(const std::string &name, const std::function<Work()> &prepare)
{
    benchmark::RegisterBenchmark(("cancel/" + name).c_str(), cancel, prepare)
        ->Unit(benchmark::kMillisecond)
        ->Iterations(Cancels)
        ->UseManualTime();
}

void addReading()
{
    add("read/obj folder", [] { return reading(objFolder()); });
    add("read/pc2", [] { return reading(tests::sequenceFolder("dance") + "/dance.pc2"); });
    const QDir scenes(tests::dataFolder() + "/scenes");
    for (const QString &scene : scenes.entryList({"*.glb", "*.gltf", "*.fbx", "*.dae"}, QDir::Files))
        add("read/" + scene.toStdString(), [path = scenes.filePath(scene)] { return reading(path); });
}

void addCodecs()
{
    for (const CodecId codec : availableCodecs()) {
        const std::string key(codecKey(codec));
        add("encode/" + key, [codec] { return encoding(defaultSettings(codec)); });
        add("search/" + key, [codec]() -> Work {
            return [codec](const Progress &progress) {
                return isStopped(encodeToTarget(*dance(), codec, false, MaxKgError{0.5}, progress));
            };
        });
        add("decode/" + key, [codec]() -> Work {
            return [bytes = encodeAnimation(*dance(), {defaultSettings(codec)})->bytes](const Progress &progress) {
                return isStopped(decodeAnimation(bytes, progress));
            };
        });
    }
    // All trajectories: the full eigenvalue problem of 603 rows. And of 3000, the largest that is written down.
    add("encode/pca, all", [] { return encoding(PcaSettings{603, 10000}); });
    add("encode/pca, 800 of 3000", [] {
        const auto large = std::make_shared<tests::PlainAnimation>(tests::waves(1000, 3200, 900));
        return Work([large](const Progress &progress) {
            return isStopped(encodeAnimation(*large, {PcaSettings{800, 10000}}, progress));
        });
    });
    add("encode/pca, 700 of more than 3000", [] {
        const auto large = std::make_shared<tests::PlainAnimation>(tests::waves(1100, 3400, 900));
        return Work([large](const Progress &progress) {
            return isStopped(encodeAnimation(*large, {PcaSettings{700, 10000}}, progress));
        });
    });
}

void addComparing()
{
    add("compare/vertex errors", []() -> Work {
        decodedDance(); // made before anything is timed
        return [](const Progress &p) { return isStopped(compareAnimations(*dance(), *decodedDance(), {}, p)); };
    });
    add("compare/sted", []() -> Work {
        decodedDance();
        return [](const Progress &p) { return isStopped(spatioTemporalDifference(*dance(), *decodedDance(), {}, p)); };
    });
    add("compare/hausdorff", []() -> Work {
        decodedDance();
        return [](const Progress &progress) {
            return isStopped(hausdorffDistance(*dance(), *decodedDance(), {}, DefaultSurfaceSamples, progress));
        };
    });
}

void addWriting()
{
    add("write/obj frames", []() -> Work {
        return [](const Progress &progress) {
            const QTemporaryDir folder; // an empty one each time
            return isStopped(io::writeFrames(folder.path(), *dance(), io::MeshFormat::Obj, progress));
        };
    });
    add("write/pc2", []() -> Work {
        const auto folder = std::make_shared<QTemporaryDir>();
        return [folder](const Progress &progress) {
            return isStopped(io::writePc2(folder->filePath("dance.pc2"), *dance(), progress));
        };
    });
    add("draw/8192 x 8192", []() -> Work {
        return [](const Progress &progress) {
            OrbitCamera camera;
            camera.fit(boundingBox(dance()->frame(0)), 1);
            drawMesh(dance()->frame(0), dance()->connectivity().triangles, camera, 8192, 8192, {}, progress);
            return progress.isCancelled();
        };
    });
}

/// Only where there are sequences to work on.
const bool registered = [] {
    if (tests::dataFolder().isEmpty())
        return false;
    addReading();
    addCodecs();
    addComparing();
    addWriting();
    return true;
}();

} // namespace
