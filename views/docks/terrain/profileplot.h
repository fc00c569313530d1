// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/query/profile.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace views {

/// A cross-section: height over distance, now and at another moment, with a cursor that the mouse or the arrow keys
/// (Shift: in larger steps, Home, End) move.
class ProfilePlot final : public QWidget
{
    Q_OBJECT

public:
    using Curve = std::vector<model::terrain::ProfilePoint>;

    explicit ProfilePlot(QWidget *parent = nullptr);

    /// \param before  empty: nothing to compare with
    void setCurves(Curve now, Curve before);
    const Curve &now() const { return mNow; }
    const Curve &before() const { return mBefore; }
    /// Metres along the section; nothing while nobody points at it.
    std::optional<double> cursor() const { return mCursor; }
    void setCursor(std::optional<double> distance);
    /// Where a point of the section is drawn.
    QPointF placeOf(double distance, double height) const;

    QSize sizeHint() const override { return {560, 190}; }
    QSize minimumSizeHint() const override { return {240, 120}; }

signals:
    void cursorChanged();

protected:
    void paintEvent(QPaintEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    /// What an axis shows, in metres.
    struct Span
    {
        double from = 0, to = 1;
        double length() const { return to - from; }
    };

    QRectF plotArea() const;
    Span distances() const;
    Span heights() const;
    void paintAxes(QPainter &painter) const;
    void paintCurve(QPainter &painter, const Curve &curve, const QPen &pen, bool isFilled) const;
    void paintCursor(QPainter &painter) const;
    void paintLegend(QPainter &painter) const;
    QColor nowColor() const;
    QColor beforeColor() const;

    Curve mNow, mBefore;
    std::optional<double> mCursor;
};

} // namespace views
