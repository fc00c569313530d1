// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspect/chart.h"

#include "model/io/savefile.h"
#include "views/inspect/painterdevice.h"
#include "views/inspect/partcolors.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <QPalette>
#include <QSvgGenerator>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkStdString.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

namespace views {

namespace {

constexpr double LineWidth = 2;
constexpr float MarkerSize = 7;
constexpr double BarShare = 0.8; ///< of the place that a bar has

QColor seriesColor(std::size_t series, const QPalette &palette)
{
    const MarkColors &colors = markColors(palette);
    const QColor all[] = {colors.hole, colors.handle, colors.tunnel, colors.selected, colors.picked, colors.problem};
    return all[series % std::size(all)];
}

vtkSmartPointer<vtkTable> tableOf(const Chart::Series &series)
{
    auto table = vtkSmartPointer<vtkTable>::New();
    vtkNew<vtkDoubleArray> x, y;
    x->SetName("x");
    y->SetName("y");
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        x->InsertNextValue(series.x[i]);
        y->InsertNextValue(series.y[i]);
    }
    table->AddColumn(x);
    table->AddColumn(y);
    return table;
}

void styleText(vtkTextProperty &text, const QColor &color, int pixels)
{
    text.SetColor(color.redF(), color.greenF(), color.blueF());
    text.SetFontSize(pixels);
    text.SetBold(0);
    text.SetItalic(0);
}

void styleAxis(vtkAxis &axis, const Chart::Axis &from, const QPalette &palette, int pixels)
{
    const QColor ink = palette.color(QPalette::WindowText), grid = palette.color(QPalette::Mid);
    axis.SetTitle(from.title.toStdString());
    axis.SetLogScale(from.isLogarithmic);
    styleText(*axis.GetTitleProperties(), ink, pixels);
    styleText(*axis.GetLabelProperties(), ink, pixels);
    axis.GetPen()->SetColor(static_cast<unsigned char>(ink.red()), static_cast<unsigned char>(ink.green()),
                            static_cast<unsigned char>(ink.blue()));
    axis.GetGridPen()->SetColor(static_cast<unsigned char>(grid.red()), static_cast<unsigned char>(grid.green()),
                                static_cast<unsigned char>(grid.blue()), 90);
}

/// All values of one axis, with a margin; logarithms where it is logarithmic, as vtkAxis wants them.
std::pair<double, double> rangeOf(const Chart &chart, bool isX)
{
    const bool isLog = (isX ? chart.x : chart.y).isLogarithmic;
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    for (const Chart::Series &series : chart.series)
        for (const double value : isX ? series.x : series.y) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    if (chart.shape == Chart::Shape::Bars && isX)
        return {low - 0.7, high + 0.7};
    if (isLog) {
        const double factor = std::pow(high / low, 0.06) * 1.02;
        return {low / factor, high * factor};
    }
    if (!isX)
        low = std::min(low, 0.0); // lengths of bars and lines compare only from zero on
    const double margin = high > low ? (high - low) * 0.05 : std::max(std::abs(high), 1.0) * 0.05;
    return {isX ? low : low, high + margin};
}

void setRange(vtkAxis &axis, std::pair<double, double> range)
{
    axis.SetBehavior(vtkAxis::FIXED);
    axis.SetUnscaledRange(range.first, range.second);
}

void nameCategories(vtkAxis &axis, const QStringList &names)
{
    vtkNew<vtkDoubleArray> places;
    vtkNew<vtkStringArray> labels;
    for (qsizetype i = 0; i < names.size(); ++i) {
        places->InsertNextValue(double(i));
        labels->InsertNextValue(names[i].toStdString());
    }
    axis.SetCustomTickPositions(places, labels);
}

} // namespace

bool Chart::isEmpty() const
{
    return std::all_of(series.begin(), series.end(), [](const Series &one) { return one.x.empty(); });
}

void paintChart(QPainter &painter, const QRectF &area, const Chart &chart, const QPalette &palette)
{
    painter.fillRect(area, palette.color(QPalette::Base));
    if (chart.isEmpty() || area.width() < 80 || area.height() < 60)
        return;
    const int pixels = QFontInfo(painter.font()).pixelSize();
    vtkNew<vtkContextScene> scene;
    scene->SetGeometry(int(area.width()), int(area.height()));
    vtkNew<vtkChartXY> drawn;
    scene->AddItem(drawn);
    drawn->SetRenderEmpty(true);
    drawn->SetTitle(chart.title.toStdString());
    styleText(*drawn->GetTitleProperties(), palette.color(QPalette::WindowText), pixels + 2);
    drawn->GetTitleProperties()->SetBold(1);
    styleAxis(*drawn->GetAxis(vtkAxis::BOTTOM), chart.x, palette, pixels);
    styleAxis(*drawn->GetAxis(vtkAxis::LEFT), chart.y, palette, pixels);
    std::size_t index = 0;
    for (const Chart::Series &series : chart.series) {
        if (series.x.empty())
            continue;
        vtkPlot *plot = drawn->AddPlot(chart.shape == Chart::Shape::Bars ? vtkChart::BAR : vtkChart::LINE);
        plot->SetInputData(tableOf(series), 0, 1);
        plot->SetLabel(series.name.toStdString());
        const QColor color = seriesColor(index++, palette);
        plot->SetColor(static_cast<unsigned char>(color.red()), static_cast<unsigned char>(color.green()),
                       static_cast<unsigned char>(color.blue()), 255);
        plot->SetWidth(chart.shape == Chart::Shape::Bars ? 1 : float(LineWidth));
        if (auto *points = vtkPlotPoints::SafeDownCast(plot)) {
            points->SetMarkerStyle(chart.shape == Chart::Shape::Points ? vtkPlotPoints::CIRCLE : vtkPlotPoints::NONE);
            points->SetMarkerSize(MarkerSize);
        }
        if (chart.shape == Chart::Shape::Bars) {
            plot->GetPen()->SetLineType(vtkPen::NO_PEN);
            drawn->SetBarWidthFraction(float(BarShare));
        }
    }
    drawn->SetShowLegend(chart.series.size() > 1);
    const QColor base = palette.color(QPalette::Base);
    drawn->GetLegend()->GetBrush()->SetColor(static_cast<unsigned char>(base.red()),
                                             static_cast<unsigned char>(base.green()),
                                             static_cast<unsigned char>(base.blue()), 220);
    styleText(*drawn->GetLegend()->GetLabelProperties(), palette.color(QPalette::WindowText), pixels);
    setRange(*drawn->GetAxis(vtkAxis::BOTTOM), rangeOf(chart, true));
    setRange(*drawn->GetAxis(vtkAxis::LEFT), rangeOf(chart, false));
    if (!chart.categories.isEmpty())
        nameCategories(*drawn->GetAxis(vtkAxis::BOTTOM), chart.categories);

    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(area.topLeft());
    vtkNew<PainterDevice> device;
    device->setPainter(&painter, area.size());
    vtkNew<vtkContext2D> context;
    context->Begin(device);
    scene->Paint(context);
    context->End();
    painter.restore();
}

QString chartCsv(const Chart &chart)
{
    const auto quoted = [](QString text) {
        if (text.contains(QLatin1Char(',')) || text.contains(QLatin1Char('"')))
            text = QLatin1Char('"') + text.replace(QLatin1String("\""), QLatin1String("\"\"")) + QLatin1Char('"');
        return text;
    };
    QStringList lines, cells{quoted(chart.x.title)};
    std::map<double, std::vector<QString>> rows;
    for (std::size_t s = 0; s < chart.series.size(); ++s) {
        const Chart::Series &series = chart.series[s];
        cells << quoted(series.name.isEmpty() ? chart.y.title : series.name);
        for (std::size_t i = 0; i < series.x.size(); ++i) {
            std::vector<QString> &row = rows[series.x[i]];
            row.resize(chart.series.size());
            row[s] = QString::number(series.y[i], 'g', 9);
        }
    }
    lines << cells.join(QLatin1Char(','));
    for (const auto &[x, row] : rows) {
        const auto at = qsizetype(x);
        cells = {at >= 0 && at < chart.categories.size() ? quoted(chart.categories[at]) : QString::number(x, 'g', 9)};
        for (const QString &value : row)
            cells << value;
        lines << cells.join(QLatin1Char(','));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

model::Result<void> saveChart(const QString &path, const Chart &chart, const QPalette &palette, QSize size,
                              double ratio)
{
    QByteArray bytes;
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending == QLatin1String("csv")) {
        bytes = chartCsv(chart).toUtf8();
    } else if (ending == QLatin1String("svg")) {
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        QSvgGenerator svg;
        svg.setOutputDevice(&buffer);
        svg.setSize(size);
        svg.setViewBox(QRect(QPoint(), size));
        svg.setTitle(chart.title);
        QPainter painter(&svg);
        paintChart(painter, QRectF(QPointF(), size), chart, palette);
    } else if (ending == QLatin1String("png")) {
        QImage image(size * ratio, QImage::Format_RGB32);
        image.setDevicePixelRatio(ratio);
        {
            QPainter painter(&image);
            paintChart(painter, QRectF(QPointF(), size), chart, palette);
        }
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        image.save(&buffer, "PNG");
    } else {
        return model::fail(model::Error{model::ErrorCode::UnknownFormat, {ending.toStdString()}, path.toStdString()});
    }
    return model::io::saveBytes(path,
                                {reinterpret_cast<const std::uint8_t *>(bytes.constData()), std::size_t(bytes.size())});
}

} // namespace views
