// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/sequence.h"
#include "model/base/parallel.h"
#include "model/io/animationreader.h"
#include "model/io/animationwriter.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>

namespace {

using namespace model;

/// `dance` (7,061 vertices, 14,118 triangles, 201 frames) as a folder of OBJ frames, about 90 MB; without SANDREEL_DATA
/// waves of the same size. Made once, in the folder for temporary files.
class ObjFolder
{
public:
    ObjFolder()
    {
        const FrameSourcePtr source = dance();
        if (!source || !io::writeFrames(path(), *source, io::MeshFormat::Obj))
            std::abort();
        for (const QFileInfo &file : QDir(path()).entryInfoList(QDir::Files))
            mBytes += file.size();
    }

    QString path() const { return mFolder.filePath(QStringLiteral("frames")); }
    qint64 bytes() const { return mBytes; }

private:
    static FrameSourcePtr dance()
    {
        const QString unpacked =
            qEnvironmentVariable("SANDREEL_UNPACKED", QDir::homePath() + QStringLiteral("/.cache/sandreel-data"));
        if (const auto read = io::readAnimation(unpacked + QStringLiteral("/dance/dance.pc2")))
            return *read;
        constexpr std::uint32_t Side = 84, Frames = 201;
        Connectivity connectivity{Side * Side, {}};
        for (std::uint32_t i = 0; i + Side + 1 < Side * Side; ++i) {
            connectivity.triangles.push_back({i, i + 1, i + Side});
            connectivity.triangles.push_back({i + 1, i + Side + 1, i + Side});
        }
        std::vector<Vec3f> positions;
        for (std::uint32_t frame = 0; frame < Frames; ++frame)
            for (std::uint32_t i = 0; i < Side * Side; ++i)
                positions.push_back({std::sin(float(i)), std::cos(float(i + frame)), std::sin(float(i * frame))});
        return std::make_shared<const Sequence>(std::move(connectivity), std::move(positions));
    }

    QTemporaryDir mFolder;
    qint64 mBytes = 0;
};

const ObjFolder &objFolder()
{
    static const ObjFolder folder;
    return folder;
}

void readObjFolder(benchmark::State &state)
{
    const ObjFolder &folder = objFolder();
    setThreadCount(unsigned(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(io::readAnimation(folder.path()));
    setThreadCount(0);
    state.SetBytesProcessed(state.iterations() * folder.bytes());
}
BENCHMARK(readObjFolder)->Arg(1)->Arg(2)->ArgName("threads")->Unit(benchmark::kMillisecond)->UseRealTime();

/// Faces are parsed too, unlike in frames after the first.
void readSingleObjs(benchmark::State &state)
{
    const ObjFolder &folder = objFolder();
    const auto files = io::frameFilesIn(folder.path());
    for (auto _ : state)
        for (const QString &file : *files)
            benchmark::DoNotOptimize(io::readMesh(file));
    state.SetBytesProcessed(state.iterations() * folder.bytes());
}
BENCHMARK(readSingleObjs)->Unit(benchmark::kMillisecond)->UseRealTime();

void writeObjFolder(benchmark::State &state)
{
    const FrameSourcePtr source = *io::readAnimation(objFolder().path());
    for (auto _ : state) {
        const QTemporaryDir target;
        benchmark::DoNotOptimize(io::writeFrames(target.filePath(QStringLiteral("out")), *source, io::MeshFormat::Obj));
    }
    state.SetBytesProcessed(state.iterations() * objFolder().bytes());
}
BENCHMARK(writeObjFolder)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
