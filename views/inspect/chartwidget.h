// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/inspect/chart.h"

#include <QWidget>

namespace views {

/// A chart in a window.
class ChartWidget final : public QWidget
{
    Q_OBJECT

public:
    explicit ChartWidget(QWidget *parent = nullptr);

    void setChart(const Chart &chart);
    const Chart &chart() const { return mChart; }
    /// What stands where nothing is to be drawn.
    void setMessage(const QString &message);

    QSize sizeHint() const override { return {420, 300}; }
    QSize minimumSizeHint() const override { return {200, 140}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    Chart mChart;
    QString mMessage;
};

} // namespace views
