// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/camera.h"

#include <QPainter>
#include <QStringList>

#include <vector>

namespace views {

/// What the viewport tells about itself.
struct ViewportStatistics
{
    std::uint32_t vertexCount = 0;
    std::size_t triangleCount = 0;
    double framesPerSecond = 0;     ///< different frames shown in the last second
    double computeMilliseconds = 0; ///< decoding and normals, in the worker
    double uploadMilliseconds = 0;
    double drawMilliseconds = 0;
};

/// The read-out in the upper left corner.
void drawStatistics(QPainter &painter, const ViewportStatistics &statistics, bool isDark);

/// What colours mean.
struct ColorScale
{
    QString title;
    QStringList notes;        ///< below it, one a line: the unit, what it is of
    std::vector<QRgb> colors; ///< from the lowest value to the highest, at equal distances
    QStringList ticks;        ///< values, likewise
};

/// A scale at the right side of `area`; nothing if there is no room.
void drawColorScale(QPainter &painter, const QRect &area, const ColorScale &scale, bool isDark);

/// What the colours of the errors mean.
struct ErrorLegend
{
    double range = 0;    ///< the error that has the last colour, in the animation's units
    double diagonal = 0; ///< of the original, which the numbers are per cent of; 0: they are plain lengths
    bool isOfFrame = false;
};

/// A scale at the right side of `area`.
void drawErrorLegend(QPainter &painter, const QRect &area, const ErrorLegend &legend, bool isDark);

/// Where x, y and z point, in the lower left corner of `area`.
void drawAxes(QPainter &painter, const QRect &area, const model::OrbitCamera &camera, bool isDark);

} // namespace views
