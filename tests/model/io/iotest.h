// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/base/error.h"
#include "tests/support/compareerror.h"

#include <functional>
#include <string_view>

#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace tests {

/// An animation for tests of files; each coordinate has all its bits in use.
class WavyFrames final : public model::FrameSource
{
public:
    /// A strip of `vertexCount - 2` triangles.
    WavyFrames(std::uint32_t vertexCount, std::uint32_t frameCount);

    std::uint32_t frameCount() const override { return mFrameCount; }
    const model::Connectivity &connectivity() const override { return mConnectivity; }
    void positions(std::uint32_t frame, std::span<model::Vec3f> out) const override;
    double frameRate() const override { return 30; }
    const std::string &name() const override { return mName; }
    std::uint64_t digest() const override { return 1; }
    std::size_t memoryBytes() const override { return 0; }

    /// Called at each positions(); to cancel in the middle, for instance.
    std::function<void(std::uint32_t)> onFrame = {};

private:
    model::Connectivity mConnectivity;
    std::uint32_t mFrameCount;
    std::string mName = "wavy";
};

/// A class whose tests each begin with an empty folder of their own, and with the processor's number of threads.
class FolderTest : public QObject
{
    Q_OBJECT

protected:
    const QTemporaryDir &folder() const { return *mFolder; }
    QString path(const QString &name) const { return mFolder->filePath(name); }
    /// For a class with an init() of its own.
    void makeFolder();

private slots:
    void init() { makeFolder(); }
    void cleanup();

private:
    std::unique_ptr<QTemporaryDir> mFolder;
};

/// The contents of a file; fails the test if there is none.
QByteArray contents(const QString &path);
/// The arguments of an error, to compare.
QStringList argsOf(const model::Error &error);
/// Parses every prefix of `bytes`, in memory of the exact size so that the address sanitizer sees a read past the end:
/// each is an error or a mesh whose indices are in range.
void checkEveryPrefix(const QByteArray &bytes,
                      const std::function<model::Result<model::TriangleMesh>(std::string_view)> &parse);
/// Writes a file, folders included.
void put(const QString &path, const QByteArray &bytes);

} // namespace tests
