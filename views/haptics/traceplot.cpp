// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/haptics/traceplot.h"

#include "views/dialogs/quantitytext.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

constexpr double ColumnSeconds = 0.02;
constexpr qint64 ColumnCount = qint64(TracePlot::Seconds / ColumnSeconds);
/// Of the range, left free above and below.
constexpr double Margin = 0.08;
constexpr int Gap = 4;

/// 1, 2 or 5 times a power of ten, at least `least`.
double roundStep(double least)
{
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= least * (1 - 1e-12))
            return digit * power;
    return 10 * power;
}

} // namespace

TracePlot::TracePlot(const QString &title, std::vector<Curve> curves, double leastRange, QWidget *parent)
    : QWidget(parent)
    , mTitle(title)
    , mCurves(std::move(curves))
    , mLeastRange(leastRange)
{
    setAccessibleName(title);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void TracePlot::add(double seconds, const std::vector<double> &values)
{
    const qint64 number = qint64(std::floor(seconds / ColumnSeconds));
    if (mColumns.empty() || mColumns.back().number < number)
        mColumns.push_back({number, {}});
    std::vector<Extent> &extents = mColumns.back().extents;
    for (std::size_t i = 0; i < mCurves.size(); ++i) {
        const float value = std::isfinite(values[i]) ? float(values[i]) : 0;
        if (extents.size() == i)
            extents.push_back({value, value});
        extents[i] = {std::min(extents[i].least, value), std::max(extents[i].greatest, value)};
    }
    while (mColumns.front().number <= number - ColumnCount)
        mColumns.pop_front();
    update();
}

void TracePlot::clear()
{
    mColumns.clear();
    update();
}

std::pair<double, double> TracePlot::rangeOf(std::size_t curve) const
{
    if (mColumns.empty())
        return {0, 0};
    Extent all = mColumns.front().extents[curve];
    for (const Column &column : mColumns)
        all = {std::min(all.least, column.extents[curve].least),
               std::max(all.greatest, column.extents[curve].greatest)};
    return {all.least, all.greatest};
}

void TracePlot::paintAxis(QPainter &painter, const QRectF &area, double low, double high) const
{
    const QFontMetrics metrics = fontMetrics();
    QColor line = palette().color(QPalette::Text);
    line.setAlphaF(0.14f);
    const double step = roundStep((high - low) * 2.2 * metrics.height() / area.height());
    const int decimals = std::max(0, int(-std::floor(std::log10(step) + 1e-9)));
    for (double tick = std::ceil(low / step) * step; tick <= high; tick += step) {
        const double y = area.bottom() - (tick - low) / (high - low) * area.height();
        painter.setPen(line);
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(palette().color(QPalette::WindowText));
        const double value = std::abs(tick) < 1e-9 * step ? 0 : tick;
        painter.drawText(QRectF(0, y - metrics.height() / 2.0, area.left() - Gap, metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, numberText(value, decimals));
    }
}

void TracePlot::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const QFontMetrics metrics = fontMetrics();
    const bool isDark = palette().color(QPalette::Base).lightness() < 128;
    const int left = metrics.horizontalAdvance(QStringLiteral("-00.0")) + Gap;
    const QRectF area(left, metrics.height() + Gap, width() - left - 1, height() - 2.1 * metrics.height() - Gap);
    painter.fillRect(area, palette().color(QPalette::Base));

    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QPointF(0, metrics.ascent()), mTitle);
    double right = width();
    for (std::size_t i = mCurves.size(); i-- > 0 && mCurves.size() > 1;) {
        right -= metrics.horizontalAdvance(mCurves[i].name) + 2 * Gap;
        painter.setPen(isDark ? mCurves[i].onDark : mCurves[i].onLight);
        painter.drawText(QPointF(right, metrics.ascent()), mCurves[i].name);
    }

    double low = 0, high = 0; // nothing is always in sight
    for (std::size_t i = 0; i < mCurves.size(); ++i) {
        const auto [least, greatest] = rangeOf(i);
        low = std::min(low, least);
        high = std::max(high, greatest);
    }
    const double missing = std::max(0.0, mLeastRange - (high - low)) / 2;
    const double margin = Margin * std::max(high - low, mLeastRange) + missing;
    low -= margin;
    high += margin;
    paintAxis(painter, area, low, high);

    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(area);
    const qint64 last = mColumns.empty() ? 0 : mColumns.back().number;
    for (std::size_t i = 0; i < mCurves.size(); ++i) {
        QPolygonF line;
        for (const Column &column : mColumns) {
            const double x = area.right() - double(last - column.number) / double(ColumnCount) * area.width();
            const auto place = [&](float value) {
                return QPointF(x, area.bottom() - (double(value) - low) / (high - low) * area.height());
            };
            line << place(column.extents[i].least);
            if (column.extents[i].greatest != column.extents[i].least)
                line << place(column.extents[i].greatest);
        }
        painter.setPen(QPen(isDark ? mCurves[i].onDark : mCurves[i].onLight, 1.4));
        painter.drawPolyline(line);
    }
    painter.restore();

    QColor frame = palette().color(QPalette::Text);
    frame.setAlphaF(0.3f);
    painter.setPen(frame);
    painter.drawRect(area);
    painter.setPen(palette().color(QPalette::WindowText));
    const QRectF below(area.left(), area.bottom(), area.width(), height() - area.bottom());
    painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter, tr("%1 s ago").arg(numberText(Seconds, 0)));
    painter.drawText(below, Qt::AlignRight | Qt::AlignVCenter, tr("now"));
}

} // namespace views
