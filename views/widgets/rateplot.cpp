// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/widgets/rateplot.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace views {

namespace {

constexpr double PointRadius = 4;
constexpr double GrabDistance = 9; // pixels
constexpr int Gap = 6;
// Shown while there is nothing to show: what codecs usually reach.
constexpr double EmptySizeFrom = 0.05, EmptySizeTo = 5, EmptyErrorFrom = 0.05, EmptyErrorTo = 10;
constexpr double LeastDecades = 0.6; ///< of an axis
constexpr double MarginDecades = 0.08;

/// The numbers 1, 2 and 5 times powers of ten between two logarithms.
std::vector<double> ticks(double from, double to)
{
    std::vector<double> result;
    for (int power = int(std::floor(from)); power <= int(std::ceil(to)); ++power)
        for (const double digit : {1.0, 2.0, 5.0})
            if (const double log = power + std::log10(digit); log >= from && log <= to)
                result.push_back(digit * std::pow(10, power));
    return result;
}

QString tickText(double value)
{
    return QLocale().toString(value, 'g', 3);
}

} // namespace

RatePlot::RatePlot(QWidget *parent)
    : QWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Size and error of what was tried"));
}

void RatePlot::setSeriesName(int series, const QString &name)
{
    if (mSeriesNames.size() <= std::size_t(series))
        mSeriesNames.resize(std::size_t(series) + 1);
    mSeriesNames[std::size_t(series)] = name;
    update();
}

int RatePlot::addPoint(const RatePoint &point)
{
    if (!(point.size > 0))
        return -1;
    const auto known = std::find(mPoints.begin(), mPoints.end(), point);
    if (known != mPoints.end())
        return int(known - mPoints.begin());
    mPoints.push_back(point);
    update();
    return int(mPoints.size()) - 1;
}

void RatePlot::clear()
{
    mPoints.clear();
    mCurrent = mHovered = -1;
    setAccessibleDescription({});
    update();
}

void RatePlot::setCurrent(int index)
{
    mCurrent = index;
    setAccessibleDescription(index >= 0 ? mPoints[std::size_t(index)].text : QString());
    update();
}

QSize RatePlot::sizeHint() const
{
    return {360, 200};
}

QSize RatePlot::minimumSizeHint() const
{
    return {220, 140};
}

RatePlot::Axis RatePlot::axisOf(double RatePoint::*value, double least, double most) const
{
    Axis axis{std::log10(least), std::log10(most)};
    bool isFirst = true;
    for (const RatePoint &point : mPoints) {
        if (!(point.*value > 0))
            continue; // without error: drawn at the axis' end
        const double log = std::log10(point.*value);
        axis = isFirst ? Axis{log, log} : Axis{std::min(axis.from, log), std::max(axis.to, log)};
        isFirst = false;
    }
    const double missing = std::max(0.0, LeastDecades - (axis.to - axis.from)) / 2 + MarginDecades;
    return {axis.from - missing, axis.to + missing};
}

QRectF RatePlot::plotArea() const
{
    const QFontMetrics metrics = fontMetrics();
    const int left = metrics.height() + Gap + metrics.horizontalAdvance(QStringLiteral("0.00005")) + Gap;
    const int bottom = 2 * metrics.height() + Gap;
    return QRectF(rect()).adjusted(left, metrics.height() / 2 + 2, -metrics.horizontalAdvance(u'0') * 2, -bottom);
}

QPointF RatePlot::placeOf(int index) const
{
    const RatePoint &point = mPoints[std::size_t(index)];
    const QRectF area = plotArea();
    const Axis x = axisOf(&RatePoint::size, EmptySizeFrom, EmptySizeTo);
    const Axis y = axisOf(&RatePoint::error, EmptyErrorFrom, EmptyErrorTo);
    const double logError = point.error > 0 ? std::log10(point.error) : y.from;
    return {area.left() + area.width() * (std::log10(point.size) - x.from) / (x.to - x.from),
            area.bottom() - area.height() * (logError - y.from) / (y.to - y.from)};
}

QColor RatePlot::colorOf(int series) const
{
    // Told apart by the colour-blind too (Okabe and Ito 2008), lighter on dark.
    static const QColor Colors[] = {QColor(0xE6, 0x9F, 0x00), QColor(0x00, 0x72, 0xB2), QColor(0x00, 0x9E, 0x73),
                                    QColor(0xCC, 0x79, 0xA7)};
    const QColor color = Colors[std::size_t(series) % std::size(Colors)];
    return palette().color(QPalette::Base).lightness() < 128 ? color.lighter(125) : color;
}

void RatePlot::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = plotArea();
    painter.fillRect(area, palette().color(QPalette::Base));
    paintAxes(painter);
    paintPoints(painter);
    paintLegend(painter);
    if (mPoints.empty()) {
        painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
        painter.drawText(area, Qt::AlignCenter | Qt::TextWordWrap, tr("What is tried appears here."));
    }
}

void RatePlot::paintAxes(QPainter &painter) const
{
    const QRectF area = plotArea();
    const QColor text = palette().color(QPalette::WindowText);
    QColor line = palette().color(QPalette::Text);
    line.setAlphaF(0.15f);
    const QFontMetrics metrics = fontMetrics();

    const Axis x = axisOf(&RatePoint::size, EmptySizeFrom, EmptySizeTo);
    double end = -1e9;
    for (const double tick : ticks(x.from, x.to)) {
        const double at = area.left() + area.width() * (std::log10(tick) - x.from) / (x.to - x.from);
        painter.setPen(line);
        painter.drawLine(QPointF(at, area.top()), QPointF(at, area.bottom()));
        const QString label = tickText(tick);
        const double width = metrics.horizontalAdvance(label);
        if (at - width / 2 < end + Gap || at + width / 2 > this->width())
            continue;
        painter.setPen(text);
        painter.drawText(QPointF(at - width / 2, area.bottom() + metrics.ascent() + 2), label);
        end = at + width / 2;
    }
    const Axis y = axisOf(&RatePoint::error, EmptyErrorFrom, EmptyErrorTo);
    double last = 1e9;
    for (const double tick : ticks(y.from, y.to)) {
        const double at = area.bottom() - area.height() * (std::log10(tick) - y.from) / (y.to - y.from);
        painter.setPen(line);
        painter.drawLine(QPointF(area.left(), at), QPointF(area.right(), at));
        if (at + metrics.height() > last)
            continue;
        const QString label = tickText(tick);
        painter.setPen(text);
        painter.drawText(QPointF(area.left() - Gap - metrics.horizontalAdvance(label), at + metrics.ascent() / 2.0 - 1),
                         label);
        last = at;
    }
    painter.setPen(hasFocus() ? palette().color(QPalette::Highlight) : line);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(area);
    painter.setPen(text);
    painter.drawText(QRectF(area.left(), height() - metrics.height(), area.width(), metrics.height()), Qt::AlignCenter,
                     tr("bits per frame and vertex"));
    painter.save();
    painter.translate(0, area.bottom());
    painter.rotate(-90);
    painter.drawText(QRectF(0, 0, area.height(), metrics.height()), Qt::AlignCenter, tr("KG error, %"));
    painter.restore();
}

void RatePlot::paintPoints(QPainter &painter) const
{
    for (int i = 0; i < int(mPoints.size()); ++i) {
        const bool isMarked = i == mCurrent || i == mHovered;
        const QColor color = colorOf(mPoints[std::size_t(i)].series);
        painter.setPen(QPen(isMarked ? palette().color(QPalette::Text) : color, isMarked ? 2 : 1));
        // A search leaves many points: where they crowd, the colour grows.
        QColor fill = color;
        fill.setAlphaF(isMarked ? 1.0f : 0.35f);
        painter.setBrush(fill);
        const double radius = i == mCurrent ? PointRadius + 2 : PointRadius;
        painter.drawEllipse(placeOf(i), radius, radius);
    }
}

void RatePlot::paintLegend(QPainter &painter) const
{
    const QFontMetrics metrics = fontMetrics();
    double top = plotArea().top() + Gap;
    for (int series = 0; series < int(mSeriesNames.size()); ++series) {
        const QString &name = mSeriesNames[std::size_t(series)];
        const bool isShown = std::any_of(mPoints.begin(), mPoints.end(),
                                         [series](const RatePoint &point) { return point.series == series; });
        if (name.isEmpty() || !isShown)
            continue;
        const double right = plotArea().right() - Gap;
        const double left = right - metrics.horizontalAdvance(name);
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(QPointF(left, top + metrics.ascent()), name);
        painter.setPen(Qt::NoPen);
        painter.setBrush(colorOf(series));
        painter.drawEllipse(QPointF(left - PointRadius - Gap, top + metrics.height() / 2.0), PointRadius, PointRadius);
        top += metrics.height();
    }
}

int RatePlot::pointAt(QPointF place) const
{
    int nearest = -1;
    double least = GrabDistance;
    for (int i = 0; i < int(mPoints.size()); ++i) {
        const QPointF d = placeOf(i) - place;
        if (const double distance = std::hypot(d.x(), d.y()); distance <= least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

void RatePlot::showHovered(int index)
{
    if (index == mHovered)
        return;
    mHovered = index;
    setCursor(index >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update();
}

void RatePlot::mouseMoveEvent(QMouseEvent *event)
{
    showHovered(pointAt(event->position()));
}

void RatePlot::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    if (const int index = pointAt(event->position()); index >= 0)
        emit pointChosen(index);
}

void RatePlot::leaveEvent(QEvent *)
{
    showHovered(-1);
}

void RatePlot::keyPressEvent(QKeyEvent *event)
{
    const bool isForward = event->key() == Qt::Key_Right, isBack = event->key() == Qt::Key_Left;
    const bool isChoice =
        event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space;
    if (mPoints.empty() || !(isForward || isBack || isChoice)) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (isChoice) {
        if (mHovered >= 0)
            emit pointChosen(mHovered);
        return;
    }
    // From left to right, as they are drawn.
    std::vector<int> order(mPoints.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [this](int a, int b) { return mPoints[std::size_t(a)].size < mPoints[std::size_t(b)].size; });
    const int from = mHovered >= 0 ? mHovered : mCurrent;
    const auto at = std::find(order.begin(), order.end(), from);
    const int place = at == order.end() ? (isForward ? -1 : int(order.size())) : int(at - order.begin());
    const int next = std::clamp(place + (isForward ? 1 : -1), 0, int(order.size()) - 1);
    showHovered(order[std::size_t(next)]);
    setAccessibleDescription(mPoints[std::size_t(mHovered)].text);
    QToolTip::showText(mapToGlobal(placeOf(mHovered).toPoint()), mPoints[std::size_t(mHovered)].text, this);
}

void RatePlot::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    update();
}

void RatePlot::focusOutEvent(QFocusEvent *event)
{
    QWidget::focusOutEvent(event);
    showHovered(-1);
    update();
}

bool RatePlot::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    const int index = pointAt(help->pos());
    if (index >= 0)
        QToolTip::showText(help->globalPos(), mPoints[std::size_t(index)].text, this);
    else
        QToolTip::hideText();
    return true;
}

} // namespace views
