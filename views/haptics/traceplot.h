// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QWidget>

#include <array>
#include <deque>
#include <vector>

namespace views {

/// Values of the last seconds, as they come: some curves over one axis of time. A thousand values a second are put
/// together to their least and greatest in each column, so that nothing between two pixels is lost.
class TracePlot final : public QWidget
{
    Q_OBJECT

public:
    static constexpr double Seconds = 8;

    struct Curve
    {
        QString name;
        QColor onLight, onDark;
    };

    /// \param title       what is shown, with its unit, above the plot and for screen readers
    /// \param leastRange  of the values: a quiet curve is not blown up to noise
    TracePlot(const QString &title, std::vector<Curve> curves, double leastRange, QWidget *parent = nullptr);

    /// \param seconds  ascending. \param values  one for each curve
    void add(double seconds, const std::vector<double> &values);
    void clear();
    /// Columns that hold a value.
    std::size_t columnCount() const { return mColumns.size(); }
    /// The least and the greatest of all that is shown, of one curve; both 0 without values.
    std::pair<double, double> rangeOf(std::size_t curve) const;

    QSize sizeHint() const override { return {260, 110}; }
    QSize minimumSizeHint() const override { return {180, 90}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    struct Extent
    {
        float least, greatest;
    };
    /// What came in one span of time.
    struct Column
    {
        qint64 number;
        std::vector<Extent> extents;
    };

    void paintAxis(QPainter &painter, const QRectF &area, double low, double high) const;

    const QString mTitle;
    const std::vector<Curve> mCurves;
    const double mLeastRange;
    std::deque<Column> mColumns;
};

} // namespace views
