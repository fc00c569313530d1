// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/exportterraindialog.h"

#include "views/dialogs/numberfield.h"
#include "views/dialogs/pathfield.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace views {

using model::io::TerrainFormat;

namespace {

struct FormatText
{
    TerrainFormat format;
    const char *ending;
    const char *text;
};

constexpr FormatText Formats[] = {
    {TerrainFormat::Obj, "obj", QT_TRANSLATE_NOOP("views::ExportTerrainDialog", "Mesh, OBJ")},
    {TerrainFormat::Ply, "ply", QT_TRANSLATE_NOOP("views::ExportTerrainDialog", "Mesh, PLY")},
    {TerrainFormat::Stl, "stl", QT_TRANSLATE_NOOP("views::ExportTerrainDialog", "Mesh, STL")},
    {TerrainFormat::GeoTiff, "tif", QT_TRANSLATE_NOOP("views::ExportTerrainDialog", "Raster, GeoTIFF")},
    {TerrainFormat::AsciiGrid, "asc", QT_TRANSLATE_NOOP("views::ExportTerrainDialog", "Raster, ESRI ASCII Grid")},
    {TerrainFormat::Png16, "png", QT_TRANSLATE_NOOP("views::ExportTerrainDialog", "Raster, PNG with 16 Bits")},
    {TerrainFormat::Contours, "geojson", QT_TRANSLATE_NOOP("views::ExportTerrainDialog", "Contours, GeoJSON")},
};

bool isMesh(TerrainFormat format)
{
    return format == TerrainFormat::Obj || format == TerrainFormat::Ply || format == TerrainFormat::Stl;
}

QString endingOf(TerrainFormat format)
{
    for (const FormatText &known : Formats)
        if (known.format == format)
            return QLatin1Char('.') + QLatin1String(known.ending);
    return {};
}

/// As the exporter chooses it: about a thousand cells along the longer side.
double proposedCell(const model::terrain::Terrain &terrain, model::terrain::Point2 step)
{
    const model::terrain::Rectangle domain = terrain.tin.domain();
    constexpr double Cells = 1024;
    return step.x > 0 ? step.x : std::max(domain.high.x - domain.low.x, domain.high.y - domain.low.y) / Cells;
}

} // namespace

ExportTerrainDialog::ExportTerrainDialog(std::shared_ptr<const model::terrain::Terrain> terrain,
                                         model::terrain::Point2 step, const QString &path, QWidget *parent)
    : ExportDialog(tr("Export Terrain"), parent)
    , mTerrain(std::move(terrain))
    , mStep(step)
    , mFormat(new QComboBox(this))
    , mOutput(new PathField(tr("Output File"), PathField::NewFile, this))
    , mIsWorld(new QCheckBox(tr("In &world coordinates"), this))
    , mCell(new NumberField(tr("Cell size"), {0.0001, 100'000, 4}, this))
    , mInterval(new NumberField(tr("Interval"), {0.001, 10'000, 3}, this))
{
    setObjectName(QStringLiteral("exportTerrainDialog"));
    for (const FormatText &known : Formats)
        mFormat->addItem(tr(known.text), int(known.format));
    mFormat->setObjectName(QStringLiteral("format"));
    mOutput->setObjectName(QStringLiteral("output"));
    mOutput->setPath(path);
    mIsWorld->setObjectName(QStringLiteral("world"));
    mIsWorld->setToolTip(tr("As the georeference says; else the terrain's south-western corner is the origin"));
    mCell->setObjectName(QStringLiteral("cell"));
    mCell->setValue(proposedCell(*mTerrain, mStep));
    mCell->setHint(tr("m"));
    mInterval->setObjectName(QStringLiteral("interval"));
    mInterval->setValue(1);
    mInterval->setHint(tr("m of height"));
    form().addRow(tr("&Format:"), mFormat);
    form().addRow(tr("&Output file:"), mOutput);
    form().addRow(QString(), mIsWorld);
    form().addRow(tr("&Cell size:"), mCell);
    form().addRow(tr("&Interval:"), mInterval);
    connect(mFormat, &QComboBox::currentIndexChanged, this, &ExportTerrainDialog::formatChanged);
    connect(mOutput, &PathField::pathChanged, this, &ExportTerrainDialog::refresh);
    connect(mIsWorld, &QCheckBox::toggled, this, &ExportTerrainDialog::refresh);
    connect(mCell, &NumberField::changed, this, &ExportTerrainDialog::refresh);
    connect(mInterval, &NumberField::changed, this, &ExportTerrainDialog::refresh);
    formatChanged();
}

TerrainFormat ExportTerrainDialog::format() const
{
    return TerrainFormat(mFormat->currentData().toInt());
}

void ExportTerrainDialog::formatChanged()
{
    // The path keeps its name and gets the new ending.
    QString path = mOutput->path();
    for (const FormatText &known : Formats)
        if (path.endsWith(endingOf(known.format), Qt::CaseInsensitive)) {
            path.chop(endingOf(known.format).size());
            break;
        }
    mOutput->setFileFilter(QStringLiteral("%1 (*%2)").arg(mFormat->currentText(), endingOf(format())));
    mOutput->setPath(withEnding(path, endingOf(format())));
    const bool isContours = format() == TerrainFormat::Contours;
    const std::pair<QWidget *, bool> shown[] = {
        {mIsWorld, isMesh(format()) && format() != TerrainFormat::Stl},
        {mCell, !isMesh(format()) && !isContours},
        {mInterval, isContours},
    };
    for (const auto &[field, isShown] : shown) {
        field->setVisible(isShown);
        if (QWidget *label = form().labelForField(field))
            label->setVisible(isShown);
    }
    refresh();
}

QString ExportTerrainDialog::problem() const
{
    for (const NumberField *field : {mCell, mInterval})
        if (field->isVisibleTo(this) && !field->value())
            return field->problem();
    return newFileProblem(outputPath());
}

QString ExportTerrainDialog::consequence() const
{
    const QLocale locale;
    if (isMesh(format()))
        return tr("%1 vertices and %2 triangles will be written.")
            .arg(locale.toString(mTerrain->tin.vertexCount()), locale.toString(mTerrain->tin.triangleCount()));
    if (format() == TerrainFormat::Contours)
        return {};
    const model::terrain::Rectangle domain = mTerrain->tin.domain();
    const auto cells = [&](double length) {
        return locale.toString(std::floor(length / mCell->value().value_or(1)) + 1, 'f', 0);
    };
    return tr("%1 × %2 samples will be written.")
        .arg(cells(domain.high.x - domain.low.x), cells(domain.high.y - domain.low.y));
}

QStringList ExportTerrainDialog::filesToReplace() const
{
    return QFileInfo::exists(outputPath()) ? QStringList{outputPath()} : QStringList();
}

QString ExportTerrainDialog::outputPath() const
{
    return withEnding(mOutput->path(), endingOf(format()));
}

ExportDialog::Work ExportTerrainDialog::work()
{
    model::io::TerrainExportOptions options;
    options.isWorld = mIsWorld->isChecked();
    options.cell = mCell->value().value_or(0);
    options.interval = mInterval->value().value_or(1);
    return [terrain = mTerrain, step = mStep, path = outputPath(), format = format(),
            options](const model::Progress &progress) -> model::Result<void> {
        const auto written = model::io::exportTerrain(path, format, *terrain, step, options, progress);
        return written ? model::Result<void>() : model::fail(written.error());
    };
}

} // namespace views
