// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/widgets/errorplot.h"

#include "views/widgets/timelineslider.h"

#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>

namespace views {

namespace {

constexpr int Height = 62;
constexpr int TopRoom = 5;

} // namespace

ErrorPlot::ErrorPlot(const TimelineSlider &slider, QWidget *parent)
    : QWidget(parent)
    , mSlider(&slider)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setMouseTracking(true);
    setCursor(Qt::PointingHandCursor);
}

void ErrorPlot::setValues(std::vector<double> values, const QString &name, const QString &unit)
{
    mValues = std::move(values);
    mName = name;
    mUnit = unit;
    const auto worst = std::ranges::max_element(mValues);
    mLargest = mValues.empty() ? 0 : *worst;
    mWorst = mValues.empty() ? 1 : int(worst - mValues.begin()) + 1;
    update();
}

void ErrorPlot::setFrame(int number)
{
    mFrame = number;
    update();
}

QString ErrorPlot::valueText(int number) const
{
    if (number < 1 || number > int(mValues.size()))
        return {};
    const QString text = locale().toString(mValues[std::size_t(number - 1)], 'g', 3);
    return mUnit.isEmpty() ? text : text + QLatin1Char(' ') + mUnit;
}

QSize ErrorPlot::sizeHint() const
{
    return {400, Height};
}

QSize ErrorPlot::minimumSizeHint() const
{
    return {100, Height};
}

QRectF ErrorPlot::area() const
{
    return QRectF(rect()).adjusted(0, TopRoom, 0, -1);
}

QPointF ErrorPlot::placeOf(int number) const
{
    const int x = mSlider ? mapFromGlobal(mSlider->mapToGlobal(QPoint(mSlider->positionOf(number), 0))).x() : 0;
    const double value = number >= 1 && number <= int(mValues.size()) ? mValues[std::size_t(number - 1)] : 0;
    return {x + 0.5, area().bottom() - (mLargest > 0 ? value / mLargest : 0) * area().height()};
}

int ErrorPlot::frameAt(double x) const
{
    if (!mSlider || mValues.empty())
        return 1;
    const double inSlider = x + mSlider->mapFromGlobal(mapToGlobal(QPoint())).x();
    return std::clamp(mSlider->frameAt(inSlider), 1, int(mValues.size()));
}

void ErrorPlot::choose(double x)
{
    if (!mValues.empty())
        emit frameChosen(frameAt(x));
}

void ErrorPlot::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        choose(event->position().x());
}

void ErrorPlot::mouseMoveEvent(QMouseEvent *event)
{
    if (event->buttons() & Qt::LeftButton)
        choose(event->position().x());
}

bool ErrorPlot::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip && !mValues.empty()) {
        const auto &help = *static_cast<QHelpEvent *>(event);
        const int number = frameAt(help.pos().x());
        QToolTip::showText(help.globalPos(), tr("Frame %1: %2 %3").arg(number).arg(mName, valueText(number)), this);
        return true;
    }
    return QWidget::event(event);
}

void ErrorPlot::paintEvent(QPaintEvent *)
{
    if (mValues.empty() || !mSlider)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF first = placeOf(1), last = placeOf(int(mValues.size()));
    const QRectF ground(QPointF(std::min(first.x(), last.x()) - 6, area().top() - 3),
                        QPointF(std::max(first.x(), last.x()) + 6, area().bottom() + 1));
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(ground, 4, 4);

    const QColor ink = palette().color(QPalette::WindowText);
    const QColor accent = palette().color(QPalette::Highlight);
    QColor faint = ink;
    faint.setAlpha(45);
    painter.setPen(QPen(faint, 1, Qt::DotLine));
    for (const double share : {0.0, 0.5}) {
        const double y = area().top() + share * area().height();
        painter.drawLine(QPointF(ground.left() + 4, y), QPointF(ground.right() - 4, y));
    }

    QPainterPath curve(first);
    for (int number = 2; number <= int(mValues.size()); ++number)
        curve.lineTo(placeOf(number));
    QPainterPath filled = curve;
    filled.lineTo(last.x(), area().bottom());
    filled.lineTo(first.x(), area().bottom());
    filled.closeSubpath();
    QColor tint = accent;
    tint.setAlpha(70);
    painter.fillPath(filled, tint);
    painter.setPen(QPen(accent, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(curve);

    const QPointF here = placeOf(mFrame);
    painter.setPen(QPen(accent, 1));
    painter.drawLine(QPointF(here.x(), area().top() - 3), QPointF(here.x(), area().bottom() + 1));
    painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
    painter.setBrush(accent);
    painter.drawEllipse(here, 4.5, 4.5);

    // The scale, on the side where the curve leaves more room.
    const QString top = valueText(mWorst);
    const bool atLeft = placeOf(mWorst).x() > ground.center().x();
    const double width = fontMetrics().horizontalAdvance(top) + 8;
    const QRectF label(atLeft ? ground.left() + 4 : ground.right() - 4 - width, ground.top() + 1, width,
                       fontMetrics().height());
    QColor paper = palette().color(QPalette::Base);
    paper.setAlpha(190);
    painter.setPen(Qt::NoPen);
    painter.setBrush(paper);
    painter.drawRoundedRect(label, 3, 3);
    QColor quiet = ink;
    quiet.setAlpha(200);
    painter.setPen(quiet);
    painter.drawText(label, Qt::AlignCenter, top);
}

} // namespace views
