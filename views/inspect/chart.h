// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"

#include <QColor>
#include <QString>
#include <QStringList>

#include <vector>

class QPainter;
class QPalette;
class QRectF;
class QSize;

namespace views {

/// What a chart shows, without how it is drawn.
struct Chart
{
    enum class Shape { Line, Points, Bars };
    struct Axis
    {
        QString title;
        bool isLogarithmic = false;
    };
    struct Series
    {
        QString name;
        std::vector<double> x, y; ///< as many; finite, and above zero along a logarithmic axis
    };

    QString title;
    Axis x, y;
    Shape shape = Shape::Line;
    std::vector<Series> series;
    QStringList categories; ///< names of x = 0, 1, ... for bars; empty: numbers

    bool isEmpty() const;
};

/// Draws a chart by VTK's vtkChartXY into a rectangle of any paint device: a widget, a picture, an SVG file.
/// VTK's own painters need OpenGL, write text in a font without Czech letters, and know no pixel ratio; so they are
/// replaced by one that paints with Qt.
void paintChart(QPainter &painter, const QRectF &area, const Chart &chart, const QPalette &palette);

/// A line of names, then a line for each place: x, and the value of each series there. Numbers are C's.
QString chartCsv(const Chart &chart);

/// As PNG, SVG or CSV, by the ending of the path. \param size  of a picture, in units of the screen
/// \param ratio  pixels for such a unit in PNG files
/// \error UnknownFormat, CannotOpen, CannotWrite
model::Result<void> saveChart(const QString &path, const Chart &chart, const QPalette &palette, QSize size,
                              double ratio);

} // namespace views
