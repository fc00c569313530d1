// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspect/chartwidget.h"

#include <QPainter>

namespace views {

ChartWidget::ChartWidget(QWidget *parent)
    : QWidget(parent)
{}

void ChartWidget::setChart(const Chart &chart)
{
    mChart = chart;
    setAccessibleName(chart.title);
    update();
}

void ChartWidget::setMessage(const QString &message)
{
    mMessage = message;
    update();
}

void ChartWidget::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    paintChart(painter, rect(), mChart, palette());
    if (mChart.isEmpty())
        painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap, mMessage);
}

} // namespace views
