// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/terrain/profileplot.h"

#include "views/dialogs/measuretext.h"
#include "views/dialogs/quantitytext.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace views {

using namespace model::terrain;

namespace {

constexpr int Gap = 6;
/// Pixels between two labels of an axis, at least.
constexpr double LabelGapX = 70, LabelGapY = 30;
/// Of the heights' range, left free above and below.
constexpr double Margin = 0.08;
/// A section as flat as this, in parts of its length, is drawn with this range of heights.
constexpr double LeastRelief = 1e-6;
constexpr double KeyPixels = 2, LargeKeyPixels = 20;

/// 1, 2 or 5 times a power of ten, at least `least`.
double roundStep(double least)
{
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= least * (1 - 1e-12))
            return digit * power;
    return 10 * power;
}

/// Decimals that tell neighbours apart.
int decimalsFor(double step)
{
    return std::max(0, int(-std::floor(std::log10(step) + 1e-9)));
}

} // namespace

ProfilePlot::ProfilePlot(QWidget *parent)
    : QWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Cross-section: height over distance"));
}

void ProfilePlot::setCurves(Curve now, Curve before)
{
    mNow = std::move(now);
    mBefore = std::move(before);
    if (mCursor && (mNow.empty() || *mCursor < mNow.front().distance || *mCursor > mNow.back().distance))
        mCursor.reset();
    update();
    emit cursorChanged(); // it reads something else
}

void ProfilePlot::setCursor(std::optional<double> distance)
{
    if (distance == mCursor)
        return;
    mCursor = distance;
    update();
    emit cursorChanged();
}

QRectF ProfilePlot::plotArea() const
{
    const QFontMetrics metrics = fontMetrics();
    const int left = metrics.horizontalAdvance(QStringLiteral("-000.000")) + Gap;
    return QRectF(rect()).adjusted(left, metrics.height() + Gap, -Gap - metrics.horizontalAdvance(u'0') * 3,
                                   -2 * metrics.height() - Gap);
}

ProfilePlot::Span ProfilePlot::distances() const
{
    return mNow.empty() ? Span() : Span{mNow.front().distance, mNow.back().distance};
}

ProfilePlot::Span ProfilePlot::heights() const
{
    if (mNow.empty())
        return {};
    Span span{mNow.front().height, mNow.front().height};
    for (const Curve *const curve : {&mNow, &mBefore})
        for (const ProfilePoint &point : *curve) {
            span.from = std::min(span.from, point.height);
            span.to = std::max(span.to, point.height);
        }
    const double least = std::max(LeastRelief * distances().length(), 1e-9 * std::abs(span.to));
    const double missing = std::max(0.0, least - span.length()) / 2 + Margin * std::max(span.length(), least);
    return {span.from - missing, span.to + missing};
}

QPointF ProfilePlot::placeOf(double distance, double height) const
{
    const QRectF area = plotArea();
    const Span x = distances(), y = heights();
    return {area.left() + area.width() * (distance - x.from) / x.length(),
            area.bottom() - area.height() * (height - y.from) / y.length()};
}

QColor ProfilePlot::nowColor() const
{
    return palette().color(QPalette::Base).lightness() < 128 ? QColor(0xf0, 0xb8, 0x60) : QColor(0xa8, 0x6a, 0x12);
}

QColor ProfilePlot::beforeColor() const
{
    return palette().color(QPalette::Base).lightness() < 128 ? QColor(0x7f, 0xb8, 0xe8) : QColor(0x00, 0x5c, 0x99);
}

void ProfilePlot::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window)); // also when it is copied as a picture
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = plotArea();
    painter.fillRect(area, palette().color(QPalette::Base));
    if (mNow.size() < 2) {
        painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
        painter.drawText(area, Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Press “Pick” and draw a line over the terrain, from one end to the other."));
    } else {
        paintAxes(painter);
        painter.save();
        painter.setClipRect(area);
        paintCurve(painter, mNow, QPen(nowColor(), 2), true);
        paintCurve(painter, mBefore, QPen(beforeColor(), 1.5, Qt::DashLine), false);
        painter.restore();
        paintCursor(painter);
        paintLegend(painter);
    }
    QColor frame = palette().color(QPalette::Text);
    frame.setAlphaF(0.3f);
    painter.setPen(hasFocus() ? palette().color(QPalette::Highlight) : frame);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(area);
}

void ProfilePlot::paintAxes(QPainter &painter) const
{
    const QRectF area = plotArea();
    const QFontMetrics metrics = fontMetrics();
    const QColor text = palette().color(QPalette::WindowText);
    QColor line = palette().color(QPalette::Text);
    line.setAlphaF(0.12f);
    const QLocale locale;

    const Span x = distances();
    const LengthUnit across = lengthUnitFor(x.to);
    const double stepX = roundStep(x.length() / across.metres * LabelGapX / area.width());
    for (double tick = std::ceil(x.from / across.metres / stepX) * stepX; tick <= x.to / across.metres + 1e-9 * stepX;
         tick += stepX) {
        const double at = placeOf(tick * across.metres, 0).x();
        painter.setPen(line);
        painter.drawLine(QPointF(at, area.top()), QPointF(at, area.bottom()));
        const QString label = locale.toString(std::abs(tick) < 1e-9 * stepX ? 0 : tick, 'f', decimalsFor(stepX));
        painter.setPen(text);
        painter.drawText(QPointF(at - metrics.horizontalAdvance(label) / 2.0, area.bottom() + metrics.ascent() + 2),
                         label);
    }
    const Span y = heights();
    const LengthUnit up = lengthUnitFor(std::max(y.length(), 1e-300));
    const double stepY = roundStep(y.length() / up.metres * LabelGapY / area.height());
    for (double tick = std::ceil(y.from / up.metres / stepY) * stepY; tick <= y.to / up.metres; tick += stepY) {
        const double at = placeOf(x.from, tick * up.metres).y();
        painter.setPen(line);
        painter.drawLine(QPointF(area.left(), at), QPointF(area.right(), at));
        const QString label = locale.toString(std::abs(tick) < 1e-9 * stepY ? 0 : tick, 'f', decimalsFor(stepY));
        painter.setPen(text);
        painter.drawText(QPointF(area.left() - Gap - metrics.horizontalAdvance(label), at + metrics.ascent() / 2.0 - 1),
                         label);
    }
    painter.setPen(text);
    painter.drawText(QRectF(area.left(), height() - metrics.height() - 1, area.width(), metrics.height()),
                     Qt::AlignCenter, tr("Distance (%1)").arg(QLatin1String(across.symbol)));
    painter.drawText(QRectF(0, 0, width(), metrics.height()), Qt::AlignLeft,
                     tr("Height (%1)").arg(QLatin1String(up.symbol)));
}

void ProfilePlot::paintCurve(QPainter &painter, const Curve &curve, const QPen &pen, bool isFilled) const
{
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    QPolygonF piece;
    const auto finish = [&] {
        if (piece.size() > 1) {
            if (isFilled) {
                QPolygonF body = piece;
                body << QPointF(piece.last().x(), plotArea().bottom())
                     << QPointF(piece.first().x(), plotArea().bottom());
                QColor fill = pen.color();
                fill.setAlphaF(0.22f);
                painter.save();
                painter.setPen(Qt::NoPen);
                painter.setBrush(fill);
                painter.drawPolygon(body);
                painter.restore();
            }
            painter.drawPolyline(piece);
        }
        piece.clear();
    };
    for (const ProfilePoint &point : curve) {
        piece << placeOf(point.distance, point.height);
        if (point.isVoidAfter)
            finish();
    }
    finish();
}

void ProfilePlot::paintCursor(QPainter &painter) const
{
    if (!mCursor)
        return;
    const QRectF area = plotArea();
    const double x = placeOf(*mCursor, 0).x();
    painter.setPen(QPen(palette().color(QPalette::Text), 1));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    for (const auto &[curve, color] : {std::pair(&mBefore, beforeColor()), std::pair(&mNow, nowColor())})
        if (const auto height = heightAt(*curve, *mCursor)) {
            painter.setBrush(color);
            painter.drawEllipse(placeOf(*mCursor, *height), 3.5, 3.5);
        }
}

void ProfilePlot::paintLegend(QPainter &painter) const
{
    const QFontMetrics metrics = fontMetrics();
    double right = plotArea().right();
    const auto entry = [&](const QString &name, const QPen &pen) {
        right -= metrics.horizontalAdvance(name);
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(QPointF(right, metrics.ascent()), name);
        painter.setPen(pen);
        painter.drawLine(QPointF(right - 26, metrics.height() / 2.0), QPointF(right - 5, metrics.height() / 2.0));
        right -= 40;
    };
    if (!mBefore.empty())
        entry(tr("Reference"), QPen(beforeColor(), 1.5, Qt::DashLine));
    entry(tr("Now"), QPen(nowColor(), 2));
    const QRectF area = plotArea();
    const double times = area.height() / heights().length() * distances().length() / area.width();
    entry(tr("heights ×%1").arg(numberText(times, times < 10 ? 1 : 0)), QPen(Qt::NoPen));
}

void ProfilePlot::mouseMoveEvent(QMouseEvent *event)
{
    if (mNow.empty())
        return;
    const QRectF area = plotArea();
    const Span x = distances();
    const double share = (event->position().x() - area.left()) / area.width();
    setCursor(x.from + std::clamp(share, 0.0, 1.0) * x.length());
}

void ProfilePlot::leaveEvent(QEvent *)
{
    if (!hasFocus())
        setCursor(std::nullopt);
}

void ProfilePlot::keyPressEvent(QKeyEvent *event)
{
    if (mNow.empty())
        return QWidget::keyPressEvent(event);
    const Span x = distances();
    const double metres = (event->modifiers() & Qt::ShiftModifier ? LargeKeyPixels : KeyPixels) * x.length() /
                          std::max(plotArea().width(), 1.0);
    const double at = mCursor.value_or((x.from + x.to) / 2);
    switch (event->key()) {
    case Qt::Key_Left:
        return setCursor(std::max(x.from, at - metres));
    case Qt::Key_Right:
        return setCursor(std::min(x.to, at + metres));
    case Qt::Key_Home:
        return setCursor(x.from);
    case Qt::Key_End:
        return setCursor(x.to);
    default:
        QWidget::keyPressEvent(event);
    }
}

void ProfilePlot::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    update();
}

void ProfilePlot::focusOutEvent(QFocusEvent *event)
{
    QWidget::focusOutEvent(event);
    update();
}

} // namespace views
