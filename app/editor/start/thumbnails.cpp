// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/start/thumbnails.h"

#include "app/editor/documents/documentkind.h"
#include "model/io/animfile.h"
#include "model/io/polygonreader.h"
#include "model/io/terrain/terrainfile.h"
#include "views/dialogs/terrainpicture.h"

#include <QGuiApplication>
#include <QImage>

namespace editor {

namespace {

/// Part of the way through: many animations begin in a pose that says little.
std::uint32_t tellingFrame(std::uint32_t frameCount)
{
    return frameCount / 3;
}

model::Result<QImage> terrainThumbnail(const QString &path, double ratio, const model::Progress &progress)
{
    const auto file = model::io::openTerrain(path, progress);
    if (!file)
        return model::fail(file.error());
    QImage image = views::drawTerrain(file->terrain, QSize(Thumbnails::Width, Thumbnails::Height) * ratio, progress);
    if (image.isNull())
        return model::fail(model::ErrorCode::Cancelled);
    image.setDevicePixelRatio(ratio);
    return image;
}

QImage drawn(std::span<const model::Vec3f> positions, std::span<const model::Triangle> triangles, double ratio)
{
    const int width = int(Thumbnails::Width * ratio);
    const int height = int(Thumbnails::Height * ratio);
    model::OrbitCamera camera;
    camera.fit(model::boundingBox(positions), float(width) / float(height));
    const model::Picture picture = model::drawMesh(positions, triangles, camera, width, height);
    QImage image =
        QImage(picture.rgba.data(), picture.width, picture.height, picture.width * 4, QImage::Format_RGBA8888)
            .copy(); // the bytes belong to the picture
    image.setDevicePixelRatio(ratio);
    return image;
}

model::Result<QImage> animationThumbnail(const QString &path, double ratio, const model::Progress &progress)
{
    const auto animation = model::io::openAnim(path, progress);
    if (!animation)
        return model::fail(animation.error());
    const std::vector<model::Vec3f> positions = (*animation)->frame(tellingFrame((*animation)->frameCount()));
    if (progress.isCancelled())
        return model::fail(model::ErrorCode::Cancelled);
    return drawn(positions, (*animation)->connectivity().triangles, ratio);
}

model::Result<QImage> meshThumbnail(const QString &path, double ratio, const model::Progress &progress)
{
    const auto mesh = model::io::readPolygonMesh(path, progress);
    if (!mesh)
        return model::fail(mesh.error());
    if (progress.isCancelled())
        return model::fail(model::ErrorCode::Cancelled);
    return drawn(mesh->positions, model::fans(mesh->faces).triangles, ratio);
}

model::Result<QImage> drawThumbnail(const QString &path, double ratio, const model::Progress &progress)
{
    switch (kindOfFile(path).value_or(DocumentKind::Animation)) {
    case DocumentKind::Animation:
        return animationThumbnail(path, ratio, progress);
    case DocumentKind::Terrain:
        return terrainThumbnail(path, ratio, progress);
    case DocumentKind::Mesh:
        return meshThumbnail(path, ratio, progress);
    }
    return model::fail(model::ErrorCode::UnknownFormat);
}

} // namespace

Thumbnails::Thumbnails(QObject *parent)
    : QObject(parent)
{}

QPixmap Thumbnails::of(const QString &path)
{
    const FileStamp stamp = FileStamp::of(path);
    if (const auto known = mPictures.constFind(path); known != mPictures.constEnd() && known->stamp == stamp)
        return known->pixmap;
    if (stamp.size >= 0 && stamp.size <= MaxFileSize && !mWaiting.contains(path)) {
        mWaiting << path;
        drawNext();
    }
    return {};
}

void Thumbnails::drawNext()
{
    if (mDrawing.isRunning() || mWaiting.isEmpty())
        return;
    const QString path = mWaiting.constFirst();
    const FileStamp stamp = FileStamp::of(path);
    mDrawing.start([path, ratio = qGuiApp->devicePixelRatio()](
                       const model::Progress &progress) { return drawThumbnail(path, ratio, progress); },
                   [this, path, stamp](const model::Result<QImage> &result) {
                       mWaiting.removeAll(path);
                       // A file that cannot be read is remembered too, without a picture; opening it will say why.
                       mPictures.insert(path, {stamp, result ? QPixmap::fromImage(*result) : QPixmap()});
                       if (result)
                           emit ready(path);
                       drawNext();
                   });
}

} // namespace editor
