// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/terrainpicture.h"

#include "model/animation/sequence.h"
#include "model/mesh/softwareraster.h"

#include <QBuffer>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

using model::terrain::Point2;

/// From somewhat above: the ground is seen, and its shape too.
constexpr float Pitch = 0.55f;
constexpr float Yaw = 0.7f;

} // namespace

model::FrameSourcePtr terrainPreview(const model::terrain::Terrain &terrain, int cells, const model::Progress &progress)
{
    const model::terrain::Rectangle domain = terrain.tin.domain();
    const double width = domain.high.x - domain.low.x, depth = domain.high.y - domain.low.y;
    const double step = std::max(width, depth) / cells;
    const auto columns = std::uint32_t(std::max(1.0, std::ceil(width / step)));
    const auto rows = std::uint32_t(std::max(1.0, std::ceil(depth / step)));
    const auto pointAt = [&](double column, double row) {
        return Point2{domain.low.x + width * column / columns, domain.low.y + depth * row / rows};
    };
    std::vector<model::Vec3f> positions;
    for (std::uint32_t row = 0; row <= rows && !progress.isCancelled(); ++row)
        for (std::uint32_t column = 0; column <= columns; ++column) {
            const Point2 p = pointAt(column, row);
            // Centred: coordinates may be too large for the 24 bits of a float's fraction.
            positions.push_back({float(p.x - domain.low.x - width / 2), float(terrain.tin.heightAt(p)),
                                 float(domain.low.y + depth / 2 - p.y)});
        }
    model::Connectivity connectivity{std::uint32_t(positions.size()), {}};
    const model::terrain::TinArrays &arrays = terrain.tin.arrays();
    for (std::uint32_t row = 0; row < rows && !progress.isCancelled(); ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            if (arrays.isVoid(terrain.tin.triangleAt(pointAt(column + 0.5, row + 0.5))))
                continue;
            const std::uint32_t a = row * (columns + 1) + column, b = a + 1, c = a + columns + 1, d = c + 1;
            connectivity.triangles.push_back({a, b, d});
            connectivity.triangles.push_back({a, d, c});
        }
    if (progress.isCancelled())
        return nullptr;
    return std::make_shared<model::Sequence>(std::move(connectivity), std::move(positions), 25, std::string());
}

QImage drawTerrain(const model::terrain::Terrain &terrain, QSize size, const model::Progress &progress)
{
    const model::FrameSourcePtr mesh = terrainPreview(terrain, size.width(), progress);
    if (progress.isCancelled())
        return {};
    const std::vector<model::Vec3f> positions = mesh->frame(0);
    model::OrbitCamera camera;
    camera.pitch = Pitch;
    camera.yaw = Yaw;
    camera.fit(model::boundingBox(positions), float(size.width()) / float(size.height()));
    const model::Picture picture =
        model::drawMesh(positions, mesh->connectivity().triangles, camera, size.width(), size.height(), {}, progress);
    if (progress.isCancelled())
        return {};
    return QImage(picture.rgba.data(), picture.width, picture.height, picture.width * 4, QImage::Format_RGBA8888)
        .copy(); // the bytes belong to the picture
}

model::Bytes thumbnailOf(const model::terrain::Terrain &terrain, const model::Progress &progress)
{
    const QImage image = drawTerrain(terrain, TerrainThumbnailSize, progress);
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    if (image.isNull() || !image.convertToFormat(QImage::Format_RGB888).save(&buffer, "PNG"))
        return {};
    return {png.begin(), png.end()};
}

} // namespace views
