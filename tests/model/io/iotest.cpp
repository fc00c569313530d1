// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/io/iotest.h"

#include "model/base/parallel.h"

#include <cmath>

#include <QDir>
#include <QFile>
#include <QFileInfo>

// The FBX importer of assimp loses the keys of morph targets, a few bytes each.
extern "C" const char *__lsan_default_suppressions()
{
    return "leak:libassimp";
}

namespace tests {

WavyFrames::WavyFrames(std::uint32_t vertexCount, std::uint32_t frameCount)
    : mFrameCount(frameCount)
{
    mConnectivity.vertexCount = vertexCount;
    for (std::uint32_t i = 2; i < vertexCount; ++i)
        mConnectivity.triangles.push_back({i - 2, i - 1, i});
}

void WavyFrames::positions(std::uint32_t frame, std::span<model::Vec3f> out) const
{
    if (onFrame)
        onFrame(frame);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const float angle = float(i) * 0.37f + float(frame) * 0.11f;
        out[i] = {std::sin(angle), std::cos(angle * 1.7f) * 1e-3f, float(i) - angle * 10};
    }
}

void FolderTest::makeFolder()
{
    mFolder = std::make_unique<QTemporaryDir>();
    QVERIFY(mFolder->isValid());
}

void FolderTest::cleanup()
{
    model::setThreadCount(0);
}

QByteArray contents(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("cannot read %s", qPrintable(path));
    return file.readAll();
}

QStringList argsOf(const model::Error &error)
{
    QStringList result;
    for (const std::string &arg : error.args)
        result << QString::fromStdString(arg);
    return result;
}

void checkEveryPrefix(const QByteArray &bytes,
                      const std::function<model::Result<model::TriangleMesh>(std::string_view)> &parse)
{
    for (qsizetype length = 0; length <= bytes.size(); ++length) {
        const std::vector<char> exact(bytes.begin(), bytes.begin() + length);
        const auto mesh = parse({exact.data(), exact.size()});
        if (!mesh)
            continue;
        QCOMPARE(std::size_t(mesh->connectivity.vertexCount), mesh->positions.size());
        for (const model::Triangle &triangle : mesh->connectivity.triangles)
            for (const std::uint32_t index : triangle)
                QVERIFY(index < mesh->connectivity.vertexCount);
    }
}

void put(const QString &path, const QByteArray &bytes)
{
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

} // namespace tests
