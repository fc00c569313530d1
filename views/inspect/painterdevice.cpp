// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspect/painterdevice.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

#include <vtkBrush.h>
#include <vtkMatrix3x3.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>

namespace views {

vtkStandardNewMacro(PainterDevice)

    namespace
{

    QColor colorOf(const unsigned char *rgba)
    {
        return QColor(rgba[0], rgba[1], rgba[2], rgba[3]);
    }

    /// VTK's matrices take columns, Qt's rows.
    QTransform toQt(vtkMatrix3x3 & m)
    {
        return QTransform(m.GetElement(0, 0), m.GetElement(1, 0), m.GetElement(2, 0), m.GetElement(0, 1),
                          m.GetElement(1, 1), m.GetElement(2, 1), m.GetElement(0, 2), m.GetElement(1, 2),
                          m.GetElement(2, 2));
    }

    /// VTK writes numbers as C does; people read them in their language.
    QString shown(const vtkStdString &text)
    {
        const QString plain = QString::fromStdString(text);
        bool isNumber = false;
        plain.toDouble(&isNumber);
        if (!isNumber || plain.contains(QLatin1Char('e')))
            return plain;
        return QString(plain).replace(QLatin1Char('.'), QLocale().decimalPoint());
    }

} // namespace

PainterDevice::PainterDevice() = default;
PainterDevice::~PainterDevice() = default;

void PainterDevice::setPainter(QPainter *painter, QSizeF size)
{
    mPainter = painter;
    mSize = size;
    this->Geometry[0] = int(size.width());
    this->Geometry[1] = int(size.height());
}

QPointF PainterDevice::place(float x, float y) const
{
    const QPointF up = mTransform.map(QPointF(double(x), double(y)));
    return {up.x(), mSize.height() - up.y()};
}

QPen PainterDevice::pen() const
{
    if (this->Pen->GetLineType() == vtkPen::NO_PEN)
        return QPen(Qt::NoPen);
    QPen result(colorOf(this->Pen->GetColorObject().GetData()), double(this->Pen->GetWidth()));
    result.setJoinStyle(Qt::RoundJoin);
    switch (this->Pen->GetLineType()) {
    case vtkPen::DASH_LINE:
        result.setStyle(Qt::DashLine);
        break;
    case vtkPen::DOT_LINE:
        result.setStyle(Qt::DotLine);
        break;
    default:
        break;
    }
    return result;
}

QBrush PainterDevice::brush() const
{
    return colorOf(this->Brush->GetColorObject().GetData());
}

QFont PainterDevice::font() const
{
    QFont result = mPainter->font();
    result.setPixelSize(std::max(1, this->TextProp->GetFontSize()));
    result.setBold(this->TextProp->GetBold());
    result.setItalic(this->TextProp->GetItalic());
    return result;
}

void PainterDevice::DrawPoly(float *points, int n, unsigned char *, int)
{
    QPolygonF line;
    for (int i = 0; i < n; ++i)
        line << place(points[2 * i], points[2 * i + 1]);
    mPainter->setPen(pen());
    mPainter->drawPolyline(line);
}

void PainterDevice::DrawLines(float *points, int n, unsigned char *, int)
{
    mPainter->setPen(pen());
    for (int i = 0; i + 1 < n; i += 2)
        mPainter->drawLine(place(points[2 * i], points[2 * i + 1]), place(points[2 * i + 2], points[2 * i + 3]));
}

void PainterDevice::DrawPoints(float *points, int n, unsigned char *, int)
{
    DrawMarkers(0, false, points, n, nullptr, 0);
}

void PainterDevice::DrawPointSprites(vtkImageData *, float *points, int n, unsigned char *, int)
{
    DrawMarkers(0, false, points, n, nullptr, 0);
}

void PainterDevice::DrawMarkers(int, bool, float *points, int n, unsigned char *, int)
{
    const double radius = double(this->Pen->GetWidth()) / 2;
    mPainter->setPen(Qt::NoPen);
    mPainter->setBrush(colorOf(this->Pen->GetColorObject().GetData()));
    for (int i = 0; i < n; ++i)
        mPainter->drawEllipse(place(points[2 * i], points[2 * i + 1]), radius, radius);
}

void PainterDevice::DrawQuadStrip(float *points, int n)
{
    for (int i = 0; i + 3 < n; i += 2) {
        const float *p = points + 2 * i;
        const float quad[] = {p[0], p[1], p[2], p[3], p[6], p[7], p[4], p[5]};
        fill(quad, 4);
    }
}

void PainterDevice::fill(const float *points, int n)
{
    QPolygonF area;
    for (int i = 0; i < n; ++i)
        area << place(points[2 * i], points[2 * i + 1]);
    mPainter->setPen(Qt::NoPen);
    mPainter->setBrush(brush());
    mPainter->drawPolygon(area);
}

void PainterDevice::DrawEllipseWedge(float x, float y, float outRx, float outRy, float inRx, float inRy, float start,
                                     float stop)
{
    const QPointF middle = place(x, y);
    const auto ring = [&](float rx, float ry) {
        return QRectF(middle.x() - double(rx), middle.y() - double(ry), 2 * double(rx), 2 * double(ry));
    };
    QPainterPath path;
    path.arcMoveTo(ring(outRx, outRy), double(start));
    path.arcTo(ring(outRx, outRy), double(start), double(stop - start));
    path.arcTo(ring(inRx, inRy), double(stop), double(start - stop));
    path.closeSubpath();
    mPainter->setPen(Qt::NoPen);
    mPainter->setBrush(brush());
    mPainter->drawPath(path);
}

void PainterDevice::DrawEllipticArc(float x, float y, float rX, float rY, float start, float stop)
{
    constexpr double Sixteenths = 16; // of a degree, in which Qt counts
    const QPointF middle = place(x, y);
    mPainter->setPen(pen());
    mPainter->setBrush(Qt::NoBrush);
    mPainter->drawArc(QRectF(middle.x() - double(rX), middle.y() - double(rY), 2 * double(rX), 2 * double(rY)),
                      int(double(start) * Sixteenths), int(double(stop - start) * Sixteenths));
}

void PainterDevice::DrawString(float *point, const vtkStdString &text)
{
    const QString label = shown(text);
    const QFont wanted = font();
    const QFontMetricsF metrics(wanted);
    const double width = metrics.horizontalAdvance(label);
    double x = 0, y = 0; // of the left end of the base line, from the point
    switch (this->TextProp->GetJustification()) {
    case VTK_TEXT_CENTERED:
        x = -width / 2;
        break;
    case VTK_TEXT_RIGHT:
        x = -width;
        break;
    default:
        break;
    }
    switch (this->TextProp->GetVerticalJustification()) {
    case VTK_TEXT_CENTERED:
        y = (metrics.ascent() - metrics.descent()) / 2;
        break;
    case VTK_TEXT_TOP:
        y = metrics.ascent();
        break;
    default:
        y = -metrics.descent();
        break;
    }
    double rgb[3];
    this->TextProp->GetColor(rgb);
    mPainter->save();
    mPainter->setFont(wanted);
    mPainter->setPen(
        QColor::fromRgbF(float(rgb[0]), float(rgb[1]), float(rgb[2]), float(this->TextProp->GetOpacity())));
    mPainter->translate(place(point[0], point[1]));
    mPainter->rotate(-this->TextProp->GetOrientation());
    mPainter->drawText(QPointF(x, y), label);
    mPainter->restore();
}

void PainterDevice::ComputeStringBounds(const vtkStdString &text, float bounds[4])
{
    const QFontMetricsF metrics(font());
    QTransform turned;
    turned.rotate(this->TextProp->GetOrientation());
    const QRectF box = turned.mapRect(QRectF(0, 0, metrics.horizontalAdvance(shown(text)), metrics.height()));
    bounds[0] = bounds[1] = 0;
    bounds[2] = float(box.width());
    bounds[3] = float(box.height());
}

void PainterDevice::DrawString(float *point, const vtkUnicodeString &text)
{
    DrawString(point, vtkStdString(text.utf8_str()));
}

void PainterDevice::ComputeStringBounds(const vtkUnicodeString &text, float bounds[4])
{
    ComputeStringBounds(vtkStdString(text.utf8_str()), bounds);
}

void PainterDevice::ComputeJustifiedStringBounds(const char *text, float bounds[4])
{
    ComputeStringBounds(vtkStdString(text), bounds);
}

void PainterDevice::SetPointSize(float size)
{
    this->Pen->SetWidth(size);
}

void PainterDevice::SetLineWidth(float width)
{
    this->Pen->SetWidth(width);
}

void PainterDevice::SetLineType(int type)
{
    this->Pen->SetLineType(type);
}

void PainterDevice::SetMatrix(vtkMatrix3x3 *matrix)
{
    mTransform = toQt(*matrix);
}

void PainterDevice::GetMatrix(vtkMatrix3x3 *matrix)
{
    const QTransform &t = mTransform;
    const double rows[3][3] = {{t.m11(), t.m21(), t.m31()}, {t.m12(), t.m22(), t.m32()}, {t.m13(), t.m23(), t.m33()}};
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            matrix->SetElement(r, c, rows[r][c]);
}

void PainterDevice::MultiplyMatrix(vtkMatrix3x3 *matrix)
{
    mTransform = toQt(*matrix) * mTransform;
}

void PainterDevice::PopMatrix()
{
    mTransform = mStack.back();
    mStack.pop_back();
}

void PainterDevice::SetClipping(int *area)
{
    mClip = QRectF(area[0], mSize.height() - area[1] - area[3], area[2], area[3]);
}

void PainterDevice::EnableClipping(bool enable)
{
    if (enable)
        mPainter->setClipRect(mClip);
    else
        mPainter->setClipping(false);
}

} // namespace views
