// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/hillshade.h"

#include "views/terrain/picture/groundvertices.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace views {

using namespace model::terrain;

namespace {

constexpr double Brightness = 0.86; ///< of level ground: slopes towards the sun may be brighter
constexpr double Ambient = 0.25;

} // namespace

double shadeOf(Gradient gradient, const TerrainStyle &style)
{
    const double azimuth = style.sunAzimuth * std::numbers::pi / 180;
    const double elevation = style.sunElevation * std::numbers::pi / 180;
    const double facing =
        std::sin(elevation) - (gradient.x * std::sin(azimuth) + gradient.y * std::cos(azimuth)) * std::cos(elevation);
    const double cosine = facing / std::sqrt(1 + gradient.x * gradient.x + gradient.y * gradient.y);
    return Ambient + (1 - Ambient) * std::max(cosine, 0.0) / std::sin(elevation);
}

void HillShade::resize(QSize size)
{
    const Rectangle &domain = mTerrain.tin.domain();
    const QSizeF shape(domain.high.x - domain.low.x, domain.high.y - domain.low.y);
    const QSize fitted = shape.scaled(size, Qt::KeepAspectRatio).toSize().expandedTo({1, 1});
    if (fitted == mImage.size())
        return;
    mImage = QImage(fitted, QImage::Format_ARGB32_Premultiplied);
    mImage.fill(Qt::transparent);
    restart();
}

void HillShade::note(const Edit &edit)
{
    const TinArrays &tin = mTerrain.tin.arrays();
    const Rectangle &domain = mTerrain.tin.domain();
    double low = domain.high.y, high = domain.low.y;
    const auto add = [&](VertexId v) {
        if (!tin.isVertex(v))
            return;
        low = std::min(low, tin.points[v].y);
        high = std::max(high, tin.points[v].y);
    };
    for (const TinPart part : {TinPart::Points, TinPart::Heights, TinPart::Layers})
        for (const SlotRange &range : edit.dirtyRanges(part))
            for (VertexId v = range.first; v < range.first + range.count; ++v) {
                if (!tin.isVertex(v))
                    continue;
                forEachCornerAround(tin, v, [&](Corner c) { add(tin.vertex(next(c))); });
                add(v);
            }
    for (const SlotRange &range : edit.dirtyRanges(TinPart::Triangles))
        for (TriangleId t = range.first; t < range.first + range.count; ++t)
            if (tin.isTriangle(t))
                for (std::uint32_t i = 0; i < 3; ++i)
                    add(tin.vertex(cornerOf(t, i)));
    if (low > high || mImage.isNull())
        return;
    const auto row = [&](double y) {
        return std::clamp(int((domain.high.y - y) / (domain.high.y - domain.low.y) * mImage.height()), 0,
                          mImage.height() - 1);
    };
    int first = row(high), last = row(low);
    if (mRowsLeft > 0) { // together with those that are waiting
        first = std::min(first, mNextRow);
        last = std::max(last, mNextRow + mRowsLeft - 1);
    }
    mNextRow = first;
    mRowsLeft = last - first + 1;
}

bool HillShade::draw(double milliseconds)
{
    QElapsedTimer clock;
    clock.start();
    while (mRowsLeft > 0) {
        drawRow(mNextRow++);
        --mRowsLeft;
        if (double(clock.nsecsElapsed()) * 1e-6 > milliseconds)
            break;
    }
    return mRowsLeft > 0;
}

void HillShade::drawRow(int row)
{
    const Tin &tin = mTerrain.tin;
    const TinArrays &arrays = tin.arrays();
    const Rectangle &domain = tin.domain();
    const TerrainStyle style;
    auto *pixels = reinterpret_cast<QRgb *>(mImage.scanLine(row));
    const double y = domain.high.y - (row + 0.5) / mImage.height() * (domain.high.y - domain.low.y);
    VertexId near = None;
    for (int column = 0; column < mImage.width(); ++column) {
        const Point2 p{domain.low.x + (column + 0.5) / mImage.width() * (domain.high.x - domain.low.x), y};
        const TriangleId t = tin.triangleAt(p, near);
        near = arrays.vertex(cornerOf(t, 0));
        if (arrays.isVoid(t)) {
            pixels[column] = 0;
            continue;
        }
        const std::uint32_t layer = GroundVertexMaker::topLayer(arrays, near);
        const QColor color =
            layer < arrays.layerCount() ? colorOf(mTerrain.materialOf(layer)) : bedrockColor(arrays.layerCount() > 0);
        const double shade = Brightness * shadeOf(gradientOf(arrays, t), style);
        const auto shaded = [shade](int part) { return std::min(int(std::lround(part * shade)), 255); };
        pixels[column] = qRgb(shaded(color.red()), shaded(color.green()), shaded(color.blue()));
    }
}

} // namespace views
