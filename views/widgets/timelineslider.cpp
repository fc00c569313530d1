// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/widgets/timelineslider.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStyle>
#include <QStyleOption>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

constexpr int StripHeight = 10;
constexpr int RulerHeight = 24;
constexpr int HandleWidth = 7;
constexpr int GrabReach = 9; ///< pixels beside a handle that still take hold of it
constexpr int PageFrames = 10;
constexpr int NotchUnits = 120;

} // namespace

TimelineSlider::TimelineSlider(QWidget *parent)
    : QAbstractSlider(parent)
{
    setOrientation(Qt::Horizontal);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setPageStep(PageFrames);
    setFrameCount(1);
}

void TimelineSlider::setFrameCount(int count)
{
    setRange(1, std::max(count, 1));
    setLoopRange(mFirst, mLast);
}

void TimelineSlider::setLoopRange(int first, int last)
{
    mFirst = std::clamp(first, minimum(), maximum());
    mLast = std::clamp(last, mFirst, maximum());
    update();
}

QRect TimelineSlider::ruler() const
{
    // Room at both ends for half a playhead and half a number.
    const int side = std::max(fontMetrics().horizontalAdvance(QString::number(maximum())) / 2 + 4, 12);
    return QRect(side, StripHeight, std::max(width() - 2 * side, 1), RulerHeight);
}

QRect TimelineSlider::rangeStrip() const
{
    return QRect(0, 0, width(), StripHeight);
}

int TimelineSlider::positionOf(int frame) const
{
    const QRect area = ruler();
    if (maximum() == minimum())
        return area.left();
    const double share = double(frame - minimum()) / double(maximum() - minimum());
    const int place = int(std::lround(share * (area.width() - 1)));
    return layoutDirection() == Qt::RightToLeft ? area.right() - place : area.left() + place;
}

int TimelineSlider::frameAt(double x) const
{
    const QRect area = ruler();
    double share = (x - area.left()) / std::max(area.width() - 1, 1);
    if (layoutDirection() == Qt::RightToLeft)
        share = 1 - share;
    return minimum() + int(std::lround(std::clamp(share, 0.0, 1.0) * (maximum() - minimum())));
}

QSize TimelineSlider::sizeHint() const
{
    return {400, StripHeight + RulerHeight + fontMetrics().height() + 2};
}

QSize TimelineSlider::minimumSizeHint() const
{
    return {100, sizeHint().height()};
}

TimelineSlider::Drag TimelineSlider::handleAt(QPointF place) const
{
    if (!rangeStrip().contains(place.toPoint()))
        return Drag::None;
    const double toFirst = std::abs(place.x() - positionOf(mFirst));
    const double toLast = std::abs(place.x() - positionOf(mLast));
    if (std::min(toFirst, toLast) > GrabReach)
        return Drag::None;
    if (toFirst == toLast) // both in one place: the side of the press decides
        return place.x() <= positionOf(mFirst) ? Drag::RangeFirst : Drag::RangeLast;
    return toFirst < toLast ? Drag::RangeFirst : Drag::RangeLast;
}

void TimelineSlider::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || mDrag != Drag::None)
        return;
    mDrag = handleAt(event->position());
    if (mDrag == Drag::None) {
        mDrag = Drag::Playhead;
        setSliderDown(true);
    }
    dragTo(event->position().x());
}

void TimelineSlider::dragTo(double x)
{
    const int frame = frameAt(x);
    if (mDrag == Drag::Playhead) {
        setSliderPosition(frame);
        return;
    }
    const int first = mDrag == Drag::RangeFirst ? std::min(frame, mLast) : mFirst;
    const int last = mDrag == Drag::RangeLast ? std::max(frame, mFirst) : mLast;
    if (first == mFirst && last == mLast)
        return;
    setLoopRange(first, last);
    emit loopRangeMoved(first, last);
}

void TimelineSlider::mouseMoveEvent(QMouseEvent *event)
{
    if (mDrag != Drag::None)
        dragTo(event->position().x());
    else
        setCursor(handleAt(event->position()) != Drag::None ? Qt::SizeHorCursor : Qt::ArrowCursor);
}

void TimelineSlider::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    if (std::exchange(mDrag, Drag::None) == Drag::Playhead)
        setSliderDown(false);
}

void TimelineSlider::wheelEvent(QWheelEvent *event)
{
    // Some platforms turn the wheel sideways while Shift is held.
    const QPoint delta = event->angleDelta();
    mWheelRest += delta.y() != 0 ? delta.y() : -delta.x();
    const int notches = mWheelRest / NotchUnits;
    mWheelRest %= NotchUnits;
    setValue(value() - notches * (event->modifiers() & Qt::ShiftModifier ? PageFrames : 1));
    event->accept();
}

bool TimelineSlider::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto &help = *static_cast<QHelpEvent *>(event);
        if (handleAt(help.pos()) != Drag::None)
            QToolTip::showText(help.globalPos(), tr("Loop range %1 - %2").arg(mFirst).arg(mLast), this);
        else
            QToolTip::showText(help.globalPos(), tr("Frame %1").arg(frameAt(help.pos().x())), this);
        return true;
    }
    return QAbstractSlider::event(event);
}

int TimelineSlider::labelStep() const
{
    const int wanted = fontMetrics().horizontalAdvance(QString::number(maximum())) + 18;
    const double pixelsPerFrame = double(ruler().width() - 1) / std::max(maximum() - minimum(), 1);
    for (int power = 1; power < 1'000'000'000; power *= 10)
        for (const int factor : {1, 2, 5})
            if (power * factor * pixelsPerFrame >= wanted)
                return power * factor;
    return maximum();
}

void TimelineSlider::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(isEnabled() ? QPalette::Base : QPalette::Window));
    painter.drawRoundedRect(ruler().adjusted(-6, 0, 6, 0), 4, 4);
    paintRange(painter);
    paintTicks(painter);
    if (isEnabled())
        paintPlayhead(painter);
    if (hasFocus()) {
        QStyleOptionFocusRect option;
        option.initFrom(this);
        option.rect = rect().adjusted(1, 1, -1, -1);
        style()->drawPrimitive(QStyle::PE_FrameFocusRect, &option, &painter, this);
    }
}

void TimelineSlider::paintRange(QPainter &painter) const
{
    if (!isEnabled())
        return;
    const int a = std::min(positionOf(mFirst), positionOf(mLast));
    const int b = std::max(positionOf(mFirst), positionOf(mLast));
    QColor color = palette().color(QPalette::Highlight);
    painter.setPen(Qt::NoPen);
    const bool isWhole = mFirst == minimum() && mLast == maximum();
    color.setAlpha(isWhole ? 28 : 70);
    painter.setBrush(color);
    painter.drawRect(QRectF(a, ruler().top(), b - a + 1, ruler().height()));
    color.setAlpha(isWhole ? 110 : 255);
    painter.setBrush(color);
    painter.drawRect(QRectF(a, StripHeight - 3, b - a + 1, 3));
    for (const auto &[x, side] : {std::pair(a, -1), std::pair(b, 1)}) {
        // Brackets that point inwards, so that two ends on one frame can be told apart.
        QPainterPath handle(QPointF(x, 1));
        handle.lineTo(x + side * HandleWidth, 1);
        handle.lineTo(x, StripHeight);
        handle.closeSubpath();
        painter.drawPath(handle);
    }
}

void TimelineSlider::paintTicks(QPainter &painter) const
{
    const QPalette::ColorGroup group = isEnabled() ? QPalette::Active : QPalette::Disabled;
    QColor ink = palette().color(group, QPalette::WindowText);
    QColor faint = ink;
    faint.setAlpha(90);
    const int step = labelStep();
    const double pixelsPerFrame = double(ruler().width() - 1) / std::max(maximum() - minimum(), 1);
    int minor = std::max(step / 10, 1);
    while (minor * pixelsPerFrame < 4 && minor < step)
        minor = minor * 5 > step ? step : minor * 5;
    const QFontMetrics metrics = fontMetrics();
    const int bottom = ruler().bottom();
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (std::int64_t frame = minor; frame <= maximum(); frame += minor) {
        const int x = positionOf(int(frame));
        const bool isMajor = frame % step == 0;
        painter.setPen(faint);
        painter.drawLine(x, bottom - (isMajor ? 11 : 5), x, bottom);
    }
    painter.setPen(ink);
    const auto label = [&](int frame) {
        const QString text = locale().toString(frame);
        const int width = metrics.horizontalAdvance(text);
        const QRect box(positionOf(frame) - width / 2, bottom + 2, width + 1, metrics.height());
        painter.drawText(box, Qt::AlignCenter, text);
        return box;
    };
    QRect lastBox = label(minimum());
    const QRect endBox(positionOf(maximum()) - 1000, bottom, 2000, metrics.height());
    const int endWidth = metrics.horizontalAdvance(locale().toString(maximum()));
    for (std::int64_t frame = step; frame < maximum(); frame += step) {
        const int x = positionOf(int(frame));
        const int half = metrics.horizontalAdvance(locale().toString(int(frame))) / 2 + 6;
        const bool isFree = std::abs(x - lastBox.center().x()) > half + lastBox.width() / 2 &&
                            std::abs(x - endBox.center().x()) > half + endWidth / 2;
        if (isFree)
            lastBox = label(int(frame));
    }
    if (maximum() > minimum())
        label(maximum());
    painter.setRenderHint(QPainter::Antialiasing);
}

void TimelineSlider::paintPlayhead(QPainter &painter) const
{
    const int x = positionOf(sliderPosition());
    const QColor color = palette().color(QPalette::Highlight);
    const QString text = locale().toString(sliderPosition());
    const int width = std::max(fontMetrics().horizontalAdvance(text) + 10, 16);
    QRectF flag(x - width / 2.0 + 0.5, ruler().top() + 1, width, ruler().height() - 9);
    flag.moveLeft(std::clamp(flag.left(), 0.0, std::max(0.0, double(this->width()) - width)));
    painter.setPen(QPen(color, 2));
    painter.drawLine(QPointF(x + 0.5, ruler().top()), QPointF(x + 0.5, ruler().bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRoundedRect(flag, 3, 3);
    painter.setPen(palette().color(QPalette::HighlightedText));
    painter.drawText(flag, Qt::AlignCenter, text);
}

} // namespace views
