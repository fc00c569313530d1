// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/viewport/overlay.h"

#include "views/viewport/errorcolors.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

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

/// What is written over the picture stands on this.
void drawPanel(QPainter &painter, const QRect &panel, bool isDark)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(isDark ? QColor(0, 0, 0, 110) : QColor(255, 255, 255, 170));
    painter.drawRoundedRect(panel, 5, 5);
}

QColor inkOn(bool isDark)
{
    return isDark ? QColor(235, 238, 242) : QColor(30, 34, 40);
}

} // namespace

void drawColorScale(QPainter &painter, const QRect &area, const ColorScale &scale, bool isDark)
{
    constexpr int BarWidth = 14, LargestBar = 240, LeastBar = 60;
    const QFontMetrics metrics = painter.fontMetrics();
    const int lineHeight = metrics.height();
    int numbers = 0;
    for (const QString &tick : scale.ticks)
        numbers = std::max(numbers, metrics.horizontalAdvance(tick));
    int width = std::max(BarWidth + 10 + numbers, metrics.horizontalAdvance(scale.title));
    for (const QString &note : scale.notes)
        width = std::max(width, metrics.horizontalAdvance(note));
    const int text = (1 + int(scale.notes.size())) * lineHeight, edge = Margin + 2;
    const int bar = std::min(LargestBar, area.height() - text - 4 * Margin - lineHeight);
    if (bar < LeastBar)
        return; // the picture is more important
    const QSize size(width + 2 * edge, text + lineHeight / 2 + bar + lineHeight / 2 + edge);
    const QRect panel(area.right() - Margin - size.width(), area.top() + Margin, size.width(), size.height());
    drawPanel(painter, panel, isDark);
    const QColor ink = inkOn(isDark);
    QColor faint = ink;
    faint.setAlpha(170);
    QRect line(panel.left() + edge, panel.top() + edge / 2, width, lineHeight);
    painter.setPen(ink);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, scale.title);
    painter.setPen(faint);
    for (const QString &note : scale.notes) {
        line.translate(0, lineHeight);
        painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, note);
    }
    const QRect strip(panel.left() + edge, line.bottom() + 1 + lineHeight / 2, BarWidth, bar);
    QLinearGradient gradient(strip.bottomLeft(), strip.topLeft());
    for (std::size_t i = 0; i < scale.colors.size(); ++i)
        gradient.setColorAt(double(i) / double(scale.colors.size() - 1), QColor(scale.colors[i]));
    painter.setPen(Qt::NoPen);
    painter.setBrush(gradient);
    painter.drawRoundedRect(strip, 2, 2);
    painter.setPen(ink);
    const int last = int(scale.ticks.size()) - 1;
    for (int tick = 0; tick <= last; ++tick) {
        const int y = strip.bottom() - (strip.height() - 1) * tick / last;
        painter.drawLine(strip.right() + 2, y, strip.right() + 5, y);
        const QRect box(strip.right() + 10, y - lineHeight / 2, numbers, lineHeight);
        painter.drawText(box, Qt::AlignRight | Qt::AlignVCenter, scale.ticks[tick]);
    }
}

void drawErrorLegend(QPainter &painter, const QRect &area, const ErrorLegend &legend, bool isDark)
{
    constexpr int Ticks = 4;
    const double largest = legend.diagonal > 0 ? 100 * legend.range / legend.diagonal : legend.range;
    const bool isPlain = largest >= 1e-4 && largest < 1e5;
    const int decimals = isPlain ? std::clamp(2 - int(std::floor(std::log10(largest))), 0, 6) : 2;
    ColorScale scale;
    scale.title = Statistics::tr("Vertex error");
    scale.notes = {legend.diagonal > 0 ? Statistics::tr("% of diagonal") : Statistics::tr("length"),
                   legend.isOfFrame ? Statistics::tr("this frame") : Statistics::tr("all frames")};
    scale.colors.assign(ErrorColors.begin(), ErrorColors.end());
    for (int tick = 0; tick <= Ticks; ++tick)
        scale.ticks += QLocale().toString(largest * tick / Ticks, isPlain ? 'f' : 'e', decimals);
    drawColorScale(painter, area, scale, isDark);
}

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
    drawPanel(painter, panel, isDark);
    const QColor ink = inkOn(isDark);
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
