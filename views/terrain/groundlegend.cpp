// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/groundlegend.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

struct Legend
{
    Q_DECLARE_TR_FUNCTIONS(views::Legend)
};

constexpr int Ticks = 4;

QStringList ticksOf(const GroundRange &range, bool isSigned)
{
    const double span = range.high - range.low;
    const int decimals = std::clamp(2 - int(std::floor(std::log10(span))), 0, 6);
    QStringList ticks;
    for (int tick = 0; tick <= Ticks; ++tick) {
        double value = range.low + span * tick / Ticks;
        if (std::abs(value) < span * 1e-9)
            value = 0; // not minus zero
        const QString text = QLocale().toString(value, 'f', decimals);
        ticks += isSigned && value > 0 ? QLatin1Char('+') + text : text;
    }
    return ticks;
}

} // namespace

ColorScale groundScale(const TerrainStyle &style, const GroundRange &range, const model::terrain::Terrain &terrain)
{
    ColorScale scale;
    const QString metres = Legend::tr("metres");
    bool isSigned = false;
    switch (style.overlay) {
    case GroundOverlay::None:
        break;
    case GroundOverlay::Height:
        scale.title = Legend::tr("Height");
        scale.notes = QStringList{metres};
        break;
    case GroundOverlay::Slope:
        scale.title = Legend::tr("Slope");
        scale.notes = QStringList{Legend::tr("degrees")};
        break;
    case GroundOverlay::Humidity:
        scale.title = Legend::tr("Humidity");
        scale.notes = {Legend::tr("% of saturation"), Legend::tr("top layer")};
        break;
    case GroundOverlay::Thickness: {
        const auto layer = std::uint32_t(std::max(style.thicknessLayer, 0));
        const bool isOne = style.thicknessLayer >= 0 && layer < terrain.tin.arrays().layerCount();
        scale.title = Legend::tr("Thickness");
        scale.notes = {metres,
                       isOne ? QString::fromStdString(terrain.materialOf(layer).name) : Legend::tr("all layers")};
        break;
    }
    case GroundOverlay::Mask:
        scale.title = Legend::tr("Mask");
        scale.notes = QStringList{Legend::tr("% protected")};
        break;
    case GroundOverlay::CutAndFill:
        scale.title = Legend::tr("Cut and fill");
        scale.notes = QStringList{metres};
        isSigned = true;
        break;
    }
    const GroundColors &colors = colorsOf(style.overlay);
    scale.colors.assign(colors.begin(), colors.end());
    scale.ticks = ticksOf(range, isSigned);
    return scale;
}

void drawGroundLegend(QPainter &painter, const QRect &area, const TerrainStyle &style, const GroundRange &range,
                      const model::terrain::Terrain &terrain)
{
    drawColorScale(painter, area, groundScale(style, range, terrain), style.isDark);
}

} // namespace views
