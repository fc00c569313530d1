// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/viewport/overlay.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>

namespace views {

namespace {

constexpr int Margin = 10;

struct Statistics
{
    Q_DECLARE_TR_FUNCTIONS(views::Statistics)
};

QString milliseconds(double value)
{
    return QLocale().toString(value, 'f', 1) + QStringLiteral(" ms");
}

} // namespace

void drawStatistics(QPainter &painter, const ViewportStatistics &statistics, bool isDark)
{
    const QLocale locale;
    const std::array<std::pair<QString, QString>, 6> rows{{
        {Statistics::tr("Vertices"), locale.toString(statistics.vertexCount)},
        {Statistics::tr("Triangles"), locale.toString(qulonglong(statistics.triangleCount))},
        {Statistics::tr("Frames/s"), locale.toString(statistics.framesPerSecond, 'f', 0)},
        {Statistics::tr("Decode"), milliseconds(statistics.computeMilliseconds)},
        {Statistics::tr("Upload"), milliseconds(statistics.uploadMilliseconds)},
        {Statistics::tr("Draw"), milliseconds(statistics.drawMilliseconds)},
    }};
    const QFontMetrics metrics = painter.fontMetrics();
    int names = 0, values = metrics.horizontalAdvance(QStringLiteral("000.0 ms"));
    for (const auto &[name, value] : rows) {
        names = std::max(names, metrics.horizontalAdvance(name));
        values = std::max(values, metrics.horizontalAdvance(value));
    }
    const int gap = 2 * metrics.averageCharWidth();
    const int lineHeight = metrics.height();
    const QRect panel(Margin, Margin, names + gap + values + 2 * Margin, int(rows.size()) * lineHeight + Margin + 2);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(isDark ? QColor(0, 0, 0, 110) : QColor(255, 255, 255, 170));
    painter.drawRoundedRect(panel, 5, 5);
    const QColor ink = isDark ? QColor(235, 238, 242) : QColor(30, 34, 40);
    QColor faint = ink;
    faint.setAlpha(170);
    QRect line(panel.left() + Margin, panel.top() + Margin / 2 + 1, names + gap + values, lineHeight);
    for (const auto &[name, value] : rows) {
        painter.setPen(faint);
        painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, name);
        painter.setPen(ink);
        painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, value);
        line.translate(0, lineHeight);
    }
}

void drawAxes(QPainter &painter, const QRect &area, const model::OrbitCamera &camera, bool isDark)
{
    struct Axis
    {
        QString name;
        QColor color;
        QPointF tip; ///< -1..1, y down
        float depth; ///< towards the viewer
    };
    const model::Vec3f x = camera.right(), y = camera.up();
    const model::Vec3f z = cross(x, y);
    std::array<Axis, 3> axes{{
        {QStringLiteral("X"), QColor(224, 82, 82), QPointF(x.x, -y.x), z.x},
        {QStringLiteral("Y"), QColor(104, 176, 76), QPointF(x.y, -y.y), z.y},
        {QStringLiteral("Z"), QColor(78, 134, 230), QPointF(x.z, -y.z), z.z},
    }};
    std::ranges::sort(axes, {}, &Axis::depth);
    constexpr double Reach = 26, Ball = 8;
    const QPointF middle(area.left() + Margin + Reach + Ball, area.bottom() - Margin - Reach - Ball);
    QFont font = painter.font();
    font.setPixelSize(10);
    font.setBold(true);
    painter.save();
    painter.setFont(font);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Axis &axis : axes) {
        QColor color = axis.color;
        if (axis.depth < -0.05f)
            color.setAlpha(130);
        const QPointF tip = middle + axis.tip * Reach;
        painter.setPen(QPen(color, 2, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(middle, tip);
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        painter.drawEllipse(tip, Ball, Ball);
        painter.setPen(isDark ? QColor(12, 14, 18) : QColor(255, 255, 255));
        painter.drawText(QRectF(tip.x() - Ball, tip.y() - Ball, 2 * Ball, 2 * Ball), Qt::AlignCenter, axis.name);
    }
    painter.restore();
}

} // namespace views
