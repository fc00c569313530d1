// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/haptics/latenessplot.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace views {

using namespace model::haptics;

namespace {

constexpr int BarsPerDecade = 10;
constexpr int Gap = 4;
constexpr const char *DecadeNames[] = {"1 µs", "10 µs", "100 µs", "1 ms", "10 ms"};

double decadesOf(Time lateness)
{
    return std::log10(std::max(1.0, double(lateness.count()) / 1000));
}

} // namespace

LatenessPlot::LatenessPlot(QWidget *parent)
    : QWidget(parent)
{
    setAccessibleName(tr("Lateness of the steps"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

int LatenessPlot::barOf(Time lateness)
{
    return std::min(BarCount - 1, int(decadesOf(lateness) * BarsPerDecade));
}

void LatenessPlot::setLateness(const Histogram *lateness)
{
    mBars.fill(0);
    mMost = Time(0);
    if (lateness) {
        for (std::uint32_t bucket = 0; bucket < Histogram::BucketCount; ++bucket)
            if (const std::uint32_t count = lateness->countIn(bucket))
                mBars[std::size_t(barOf(Histogram::endOf(bucket)))] += count;
        mMost = lateness->percentile(0.99);
    }
    update();
}

void LatenessPlot::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const QFontMetrics metrics = fontMetrics();
    const QRectF area(0, metrics.height() + Gap, width() - 1, height() - 2.2 * metrics.height() - Gap);
    painter.fillRect(area, palette().color(QPalette::Base));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QPointF(0, metrics.ascent()), tr("Lateness of the steps"));

    const auto placeOf = [&](double decades) {
        return area.left() + area.width() * std::clamp(decades * BarsPerDecade / BarCount, 0.0, 1.0);
    };
    QColor line = palette().color(QPalette::Text);
    line.setAlphaF(0.14f);
    for (int decade = 0; decade < int(std::size(DecadeNames)); ++decade) {
        const double x = placeOf(decade);
        painter.setPen(line);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        const QString name = QString::fromUtf8(DecadeNames[decade]);
        const double wide = metrics.horizontalAdvance(name);
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(QPointF(std::clamp(x - wide / 2, 0.0, width() - wide), height() - metrics.descent()), name);
    }

    const std::uint64_t most = *std::max_element(mBars.begin(), mBars.end());
    if (most == 0)
        return;
    const double barWidth = area.width() / BarCount;
    for (int i = 0; i < BarCount; ++i)
        if (const std::uint64_t count = mBars[std::size_t(i)]) {
            // Logarithmic, so that one late step in ten thousand is seen.
            const double high = std::log10(1 + double(count)) / std::log10(1 + double(most)) * (area.height() - 2);
            painter.fillRect(QRectF(area.left() + i * barWidth, area.bottom() - high, barWidth - 0.5, high),
                             palette().color(QPalette::Highlight));
        }
    const double x = placeOf(decadesOf(mMost));
    painter.setPen(QPen(palette().color(QPalette::Text), 1, Qt::DashLine));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    const QString mark = tr("99 %");
    const double wide = metrics.horizontalAdvance(mark);
    painter.drawText(QPointF(x + Gap + wide < area.right() ? x + Gap : x - Gap - wide, area.top() + metrics.ascent()),
                     mark);
}

} // namespace views
