// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractSlider>

namespace views {

/// A ruler of frames, numbered from 1, with a playhead and a loop range. A press or drag on the ruler moves the
/// playhead (sliderPressed, valueChanged, sliderReleased), one on a handle of the range moves that. The wheel steps by
/// one frame, with Shift by ten.
class TimelineSlider final : public QAbstractSlider
{
    Q_OBJECT

public:
    explicit TimelineSlider(QWidget *parent = nullptr);

    /// value() is 1..count from now on. Precondition: count > 0.
    void setFrameCount(int count);
    int frameCount() const { return maximum(); }
    /// The loop range, both ends included, numbered from 1.
    void setLoopRange(int first, int last);

    /// Where a frame is drawn, in the widget's coordinates.
    int positionOf(int frame) const;
    /// The frame whose place is nearest.
    int frameAt(double x) const;
    /// The strip in which the range's handles can be grabbed.
    QRect rangeStrip() const;
    QRect ruler() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// The user drags an end of the range.
    void loopRangeMoved(int first, int last);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    bool event(QEvent *event) override;

private:
    enum class Drag { None, Playhead, RangeFirst, RangeLast };

    /// The handle under `place`.
    Drag handleAt(QPointF place) const;
    void dragTo(double x);
    /// Frames between two numbers of the ruler: 1, 2 or 5 times a power of ten.
    int labelStep() const;
    void paintRange(QPainter &painter) const;
    void paintTicks(QPainter &painter) const;
    void paintPlayhead(QPainter &painter) const;

    int mFirst = 1;
    int mLast = 1;
    Drag mDrag = Drag::None;
    int mWheelRest = 0; ///< eighths of a degree that made no whole notch yet
};

} // namespace views
