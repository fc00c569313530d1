// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <vector>

namespace views {

/// One encoding, tried or made.
struct RatePoint
{
    int series = 0;   ///< which colour, and which name in the legend
    double size = 0;  ///< bits per frame and vertex, above zero
    double error = 0; ///< KG, per cent
    QString text;     ///< shown when the mouse is over it

    friend bool operator==(const RatePoint &, const RatePoint &) = default;
};

/// Sizes against errors on logarithmic axes, a point for each encoding. A point is chosen by a click, or by the arrow
/// keys and Enter.
class RatePlot final : public QWidget
{
    Q_OBJECT

public:
    explicit RatePlot(QWidget *parent = nullptr);

    /// Points of unknown series have no name in the legend.
    void setSeriesName(int series, const QString &name);
    /// A point that is there already is not added again. Points without size are left out. \returns its index, or -1
    int addPoint(const RatePoint &point);
    void clear();
    /// The point drawn as the present one; -1: none.
    void setCurrent(int index);
    int current() const { return mCurrent; }

    const std::vector<RatePoint> &points() const { return mPoints; }
    /// Where a point is drawn, in the widget's coordinates.
    QPointF placeOf(int index) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void pointChosen(int index);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    bool event(QEvent *event) override;

private:
    /// The logarithms (base 10) that an axis shows.
    struct Axis
    {
        double from = 0;
        double to = 1;
    };

    Axis axisOf(double RatePoint::*value, double least, double most) const;
    QRectF plotArea() const;
    /// The point at most a few pixels away from `place`; -1 if there is none.
    int pointAt(QPointF place) const;
    void showHovered(int index);
    void paintAxes(QPainter &painter) const;
    void paintPoints(QPainter &painter) const;
    void paintLegend(QPainter &painter) const;
    QColor colorOf(int series) const;

    std::vector<RatePoint> mPoints;
    std::vector<QString> mSeriesNames;
    int mCurrent = -1;
    int mHovered = -1;
};

} // namespace views
