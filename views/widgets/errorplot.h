// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>

#include <vector>

namespace views {

class TimelineSlider;

/// A curve over the frames of a timeline, each above its place on the ruler. A press or drag chooses a frame; the keys
/// for frames are the timeline's.
class ErrorPlot final : public QWidget
{
    Q_OBJECT

public:
    /// \param slider  the ruler below; must be in the same window
    explicit ErrorPlot(const TimelineSlider &slider, QWidget *parent = nullptr);

    /// \param values  one for each frame, not negative
    /// \param name    what they are, for tool tips and screen readers: "KG error"
    /// \param unit    "%"; may be empty
    void setValues(std::vector<double> values, const QString &name, const QString &unit);
    const std::vector<double> &values() const { return mValues; }
    /// The frame whose value is marked, numbered from 1.
    void setFrame(int number);
    /// "2.31 %"
    QString valueText(int number) const;

    /// Where the value of a frame is drawn.
    QPointF placeOf(int number) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void frameChosen(int number);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    bool event(QEvent *event) override;

private:
    QRectF area() const;
    int frameAt(double x) const;
    void choose(double x);

    QPointer<const TimelineSlider> mSlider;
    std::vector<double> mValues;
    QString mName, mUnit;
    double mLargest = 0;
    int mWorst = 1;
    int mFrame = 1;
};

} // namespace views
