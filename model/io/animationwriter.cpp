// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/animationwriter.h"

#include "model/base/bytes.h"
#include "model/base/parallel.h"
#include "model/io/failure.h"
#include "model/io/firsterror.h"
#include "model/io/meshtext.h"
#include "model/io/rawpositions.h"
#include "model/io/savefile.h"
#include "model/io/workspaces.h"

#include <atomic>

#include <QDir>
#include <QFile>

namespace model::io {

namespace {

std::span<const std::uint8_t> asBytes(const std::string &text)
{
    return {reinterpret_cast<const std::uint8_t *>(text.data()), text.size()};
}

/// The files of one export. Unless kept, removes those that it made, and the folder if it made that.
class FrameFolder
{
public:
    FrameFolder(const QString &folder, std::uint32_t frameCount, MeshFormat format)
        : mFolder(folder)
        , mMade(frameCount)
        , mDigits(std::max(4, int(QString::number(frameCount).size())))
        , mEnding(QString::fromLatin1(endingOf(format)))
    {}
    FrameFolder(const FrameFolder &) = delete;
    FrameFolder &operator=(const FrameFolder &) = delete;

    ~FrameFolder()
    {
        if (mKept)
            return;
        for (std::uint32_t frame = 0; frame < mMade.size(); ++frame)
            if (mMade[frame])
                QFile::remove(path(frame));
        if (mMadeFolder)
            QDir().rmdir(mFolder);
    }

    Result<void> open()
    {
        const QString folder = QDir(mFolder).absolutePath();
        mMadeFolder = !QFile::exists(folder);
        if (!QDir().mkpath(folder))
            return failIn(mFolder, ErrorCode::CannotOpen, QT_TRANSLATE_NOOP("ErrorText", "the folder cannot be made"));
        if (!QDir(folder).entryList({QStringLiteral("*.") + mEnding}, QDir::Files).isEmpty())
            return failIn(mFolder, ErrorCode::CannotWrite,
                          QT_TRANSLATE_NOOP("ErrorText", "the folder holds frames already"));
        return {};
    }

    /// From any thread, each frame once.
    Result<void> write(std::uint32_t frame, std::span<const std::uint8_t> bytes)
    {
        QFile file(path(frame));
        // NewOnly: somebody else's file of this name is not overwritten.
        if (!file.open(QIODevice::WriteOnly | QIODevice::NewOnly | QIODevice::Unbuffered))
            return failIn(file, ErrorCode::CannotOpen);
        mMade[frame] = 1;
        return writeAll(file, bytes);
    }

    void keep() { mKept = true; }

private:
    QString path(std::uint32_t frame) const
    {
        return QDir(mFolder).filePath(
            QStringLiteral("frame_%1.%2").arg(frame + 1, mDigits, 10, QLatin1Char('0')).arg(mEnding));
    }

    QString mFolder;
    std::vector<char> mMade; // not bool: frames are marked from several threads
    int mDigits;
    QString mEnding;
    bool mMadeFolder = false;
    bool mKept = false;
};

} // namespace

Result<void> writeMesh(const QString &path, std::span<const Vec3f> positions, const Connectivity &connectivity,
                       MeshFormat format)
{
    std::string text;
    formatMesh(positions, connectivity, format, text);
    return saveBytes(path, asBytes(text));
}

Result<void> writePolygonMesh(const QString &path, const PolygonMesh &mesh, MeshFormat format)
{
    std::string text;
    formatMesh(mesh.positions, mesh.faces, format, text);
    return saveBytes(path, asBytes(text));
}

Result<void> writeFrames(const QString &folder, const FrameSource &source, MeshFormat format, const Progress &progress)
{
    struct Workspace
    {
        std::vector<Vec3f> positions;
        std::string text;
    };

    FrameFolder frames(folder, source.frameCount(), format);
    if (auto opened = frames.open(); !opened)
        return opened;
    Workspaces<Workspace> workspaces;
    FirstError firstError;
    std::atomic<std::uint32_t> done = 0;
    parallelFor(source.frameCount(), [&](std::size_t i) {
        if (firstError.isBefore(i))
            return;
        if (progress.isCancelled())
            return firstError.set(i, fail(ErrorCode::Cancelled).value());
        const auto workspace = workspaces.take();
        workspace->positions.resize(source.vertexCount());
        source.positions(std::uint32_t(i), workspace->positions);
        formatMesh(workspace->positions, source.connectivity(), format, workspace->text);
        if (auto written = frames.write(std::uint32_t(i), asBytes(workspace->text)); !written)
            return firstError.set(i, std::move(written.error()));
        progress.report(double(++done) / source.frameCount());
    });
    if (firstError)
        return fail(firstError.take());
    frames.keep();
    return {};
}

Result<void> writePc2(const QString &path, const FrameSource &source, const Progress &progress)
{
    SaveFile file(path);
    if (auto opened = file.open(); !opened)
        return opened;

    ByteWriter header;
    header.bytes(std::span(reinterpret_cast<const std::uint8_t *>("POINTCACHE2"), 12)); // with its final zero
    header.u32(1);                                                                      // version
    header.u32(source.vertexCount());
    header.f32(0); // frame of the first sample
    header.f32(1); // frames from one sample to the next
    header.u32(source.frameCount());
    if (auto written = file.write(header.data()); !written)
        return written;

    std::vector<Vec3f> positions(source.vertexCount());
    for (std::uint32_t frame = 0; frame < source.frameCount(); ++frame) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        source.positions(frame, positions);
        swapBytesUnlessNative(positions, std::endian::little);
        const std::size_t bytes = positions.size() * sizeof(Vec3f);
        if (auto written = file.write({reinterpret_cast<const std::uint8_t *>(positions.data()), bytes}); !written)
            return written;
        progress.report((frame + 1.0) / source.frameCount());
    }
    return file.commit();
}

} // namespace model::io
