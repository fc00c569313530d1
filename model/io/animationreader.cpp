// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/animationreader.h"

#include "model/animation/editedframes.h"
#include "model/base/outofmemory.h"
#include "model/io/animfile.h"
#include "model/io/failure.h"
#include "model/io/filebuffer.h"
#include "model/io/framefolder.h"
#include "model/io/meshfile.h"
#include "model/io/pointcache.h"
#include "model/io/positionmemory.h"
#include "model/io/scenereader.h"

#include <QDir>
#include <QFileInfo>

namespace model::io {

namespace {

constexpr double DefaultFrameRate = 25;

std::string nameOf(const QString &path)
{
    const QFileInfo info(QDir::cleanPath(QFileInfo(path).absoluteFilePath()));
    return (info.isDir() ? info.fileName() : info.completeBaseName()).toStdString();
}

Result<FrameSourcePtr> readFolder(const QString &path, const ReadOptions &options, const Progress &progress)
{
    const Result<QStringList> files = frameFilesIn(path);
    if (!files)
        return fail(files.error());
    return readFrames(*files, options.frameRate > 0 ? options.frameRate : DefaultFrameRate, nameOf(path), progress);
}

Result<FrameSourcePtr> readAnim(const QString &path, const ReadOptions &options, const Progress &progress)
{
    auto decoded = openAnim(path, progress);
    if (!decoded)
        return fail(std::move(decoded.error()));
    FrameSourcePtr source = std::move(*decoded);
    if (!(options.frameRate > 0) || options.frameRate == source->frameRate())
        return source;
    const TimeMap all = TimeMap::identity(source->frameCount());
    std::string name = source->name();
    return std::make_shared<const EditedFrames>(std::move(source), all, Similarity(), options.frameRate,
                                                std::move(name));
}

} // namespace

Result<FrameSourcePtr> readAnimation(const QString &path, const ReadOptions &options, const Progress &progress)
{
    return catchBadAlloc([&]() -> Result<FrameSourcePtr> {
        if (QFileInfo(path).isDir())
            return readFolder(path, options, progress);
        if (!QFileInfo::exists(path))
            return failIn(path, ErrorCode::NotFound);
        const QString ending = QFileInfo(path).suffix().toLower();
        if (meshEndings().contains(ending))
            return readFrames({path}, options.frameRate > 0 ? options.frameRate : DefaultFrameRate, nameOf(path),
                              progress);
        if (pointCacheEndings().contains(ending))
            return readPointCache(path, options.baseMesh, options.frameRate, nameOf(path), progress);
        if (sceneEndings().contains(ending))
            return readScene(path, options.frameRate, options.animationIndex, nameOf(path), progress);
        if (ending == QStringLiteral("anim"))
            return readAnim(path, options, progress);
        return failIn(path, ErrorCode::UnknownFormat, ending.toStdString());
    });
}

Result<TriangleMesh> readMesh(const QString &path)
{
    return catchBadAlloc([&]() -> Result<TriangleMesh> {
        FileBuffer file;
        const auto bytes = file.load(path);
        if (!bytes)
            return fail(bytes.error());
        const auto kind = meshKindOf(path);
        if (!kind)
            return failIn(path, ErrorCode::UnknownFormat, QFileInfo(path).suffix().toLower().toStdString());
        auto mesh = parseMesh(*kind, *bytes);
        return mesh ? std::move(mesh) : failIn(path, std::move(mesh.error()));
    });
}

QStringList readableEndings()
{
    return meshEndings() + pointCacheEndings() + sceneEndings() + QStringList{QStringLiteral("anim")};
}

} // namespace model::io
