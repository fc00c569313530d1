// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/importterraindialog.h"

#include "views/dialogs/layersfield.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/pathfield.h"
#include "views/dialogs/quantitytext.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QPushButton>

#include <cmath>

namespace views {

using model::io::RawType;

namespace {

struct RawTypeText
{
    RawType type;
    int bytes;
    const char *text;
};

constexpr RawTypeText RawTypes[] = {
    {RawType::Uint8, 1, QT_TRANSLATE_NOOP("views::ImportTerrainDialog", "8 bits")},
    {RawType::Uint16, 2, QT_TRANSLATE_NOOP("views::ImportTerrainDialog", "16 bits")},
    {RawType::Int16, 2, QT_TRANSLATE_NOOP("views::ImportTerrainDialog", "16 bits with sign")},
    {RawType::Uint32, 4, QT_TRANSLATE_NOOP("views::ImportTerrainDialog", "32 bits")},
    {RawType::Float32, 4, QT_TRANSLATE_NOOP("views::ImportTerrainDialog", "32 bits, floating point")},
    {RawType::Float64, 8, QT_TRANSLATE_NOOP("views::ImportTerrainDialog", "64 bits, floating point")},
};

int bytesOf(RawType type)
{
    for (const RawTypeText &known : RawTypes)
        if (known.type == type)
            return known.bytes;
    return 1;
}

} // namespace

ImportTerrainDialog::ImportTerrainDialog(QWidget *parent)
    : QDialog(parent)
    , mForm(new QFormLayout)
    , mSource(new PathField(tr("Source"), PathField::ExistingFile, this))
    , mType(new QComboBox(this))
    , mByteOrder(new QComboBox(this))
    , mUp(new QComboBox(this))
    , mCrs(new QLineEdit(this))
    , mLayers(new LayersField(this))
    , mMessage(new HintLabel(this))
{
    setWindowTitle(tr("Import Terrain"));
    setObjectName(QStringLiteral("importTerrainDialog"));
    setMinimumWidth(520);
    QStringList patterns;
    for (const QString &ending : model::io::terrainEndings())
        patterns << QStringLiteral("*.") + ending;
    mSource->setFileFilter(tr("Terrains of Other Programs (%1)").arg(patterns.join(QLatin1Char(' '))) +
                           QStringLiteral(";;") + tr("All files (*)"));
    mSource->setObjectName(QStringLiteral("source"));
    mForm->addRow(tr("&Source:"), mSource);
    mMaxError = addNumber("maxError", tr("Largest &error:"), tr("Largest error"), 0, 10'000, 4, 0.1,
                          tr("m of height; fewer triangles where it is flat"));
    mCellSize = addNumber("cellSize", tr("&Cell size:"), tr("Cell size"), 0.0001, 100'000, 4, 1,
                          tr("m, if the file does not say"));
    mHeightScale = addNumber("heightScale", tr("&Height scale:"), tr("Height scale"), 0.000001, 100'000, 6, 1,
                             tr("m for 1 in the file"));
    mColumns = addNumber("columns", tr("C&olumns:"), tr("Columns"), 1, 1'000'000, 0, 1, {});
    mRows = addNumber("rows", tr("&Rows:"), tr("Rows"), 1, 1'000'000, 0, 1, {});
    for (const RawTypeText &type : RawTypes)
        mType->addItem(tr(type.text), int(type.type));
    mType->setCurrentIndex(mType->findData(int(RawType::Uint16)));
    mType->setObjectName(QStringLiteral("type"));
    mForm->addRow(tr("&Numbers:"), mType);
    mByteOrder->addItem(tr("Little end first"), false);
    mByteOrder->addItem(tr("Big end first"), true);
    mByteOrder->setObjectName(QStringLiteral("byteOrder"));
    mForm->addRow(tr("&Bytes:"), mByteOrder);
    mUp->addItem(tr("Z"), int(model::io::UpAxis::Z));
    mUp->addItem(tr("Y"), int(model::io::UpAxis::Y));
    mUp->setObjectName(QStringLiteral("up"));
    mForm->addRow(tr("&Upwards is:"), mUp);
    mCrs->setObjectName(QStringLiteral("crs"));
    mCrs->setPlaceholderText(tr("EPSG:5514, or nothing; if the file does not say"));
    mForm->addRow(tr("Coordinate s&ystem:"), mCrs);
    mForm->addRow(tr("Layers:"), mLayers);

    auto *buttons = new QDialogButtonBox(this);
    mImport = buttons->addButton(tr("&Import"), QDialogButtonBox::AcceptRole);
    mImport->setObjectName(QStringLiteral("import"));
    mImport->setDefault(true);
    buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
    auto *column = new QVBoxLayout(this);
    column->addLayout(mForm);
    column->addWidget(mMessage);
    column->addStretch();
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(mSource, &PathField::pathChanged, this, &ImportTerrainDialog::sourceChanged);
    connect(mType, &QComboBox::currentIndexChanged, this, &ImportTerrainDialog::guessRawSize);
    connect(mLayers, &LayersField::changed, this, &ImportTerrainDialog::refresh);
    for (const NumberField *field : {mMaxError, mCellSize, mHeightScale, mColumns, mRows})
        connect(field, &NumberField::changed, this, &ImportTerrainDialog::refresh);
    sourceChanged();
}

NumberField *ImportTerrainDialog::addNumber(const char *objectName, const QString &label, const QString &what,
                                            double min, double max, int decimals, double value, const QString &unit)
{
    auto *field = new NumberField(what, {min, max, decimals}, this);
    field->setObjectName(QLatin1String(objectName));
    field->setValue(value);
    field->setHint(unit);
    mForm->addRow(label, field);
    return field;
}

void ImportTerrainDialog::setSource(const QString &path)
{
    mSource->setPath(path);
}

QString ImportTerrainDialog::source() const
{
    return mSource->path();
}

ImportTerrainDialog::FileKind ImportTerrainDialog::fileKind() const
{
    const QString ending = QFileInfo(source()).suffix().toLower();
    if (ending == QLatin1String("raw") || ending == QLatin1String("r16") || ending == QLatin1String("r32"))
        return FileKind::Raw;
    if (QStringList{"xyz", "txt", "csv", "pts"}.contains(ending))
        return FileKind::Points;
    if (QStringList{"obj", "ply", "stl"}.contains(ending))
        return FileKind::Mesh;
    return FileKind::Raster;
}

void ImportTerrainDialog::sourceChanged()
{
    const FileKind kind = fileKind();
    const bool isGrid = kind == FileKind::Raster || kind == FileKind::Raw;
    const std::pair<QWidget *, bool> shown[] = {
        {mCellSize, isGrid},
        {mHeightScale, isGrid},
        {mColumns, kind == FileKind::Raw},
        {mRows, kind == FileKind::Raw},
        {mType, kind == FileKind::Raw},
        {mByteOrder, kind == FileKind::Raw},
        {mUp, kind == FileKind::Mesh},
    };
    for (const auto &[field, isShown] : shown) {
        field->setVisible(isShown);
        mForm->labelForField(field)->setVisible(isShown);
    }
    guessRawSize();
}

/// Most of them are square.
void ImportTerrainDialog::guessRawSize()
{
    if (fileKind() == FileKind::Raw) {
        const qint64 samples = QFileInfo(source()).size() / bytesOf(RawType(mType->currentData().toInt()));
        const double side = std::floor(std::sqrt(double(samples)));
        if (side >= 1) {
            mColumns->setValue(side);
            mRows->setValue(std::floor(double(samples) / side));
        }
    }
    refresh();
}

QString ImportTerrainDialog::problem() const
{
    const QFileInfo file(source());
    if (source().isEmpty())
        return tr("Choose a file: a raster of heights, points, or a mesh.");
    if (!file.isFile())
        return tr("There is no such file.");
    if (!model::io::terrainEndings().contains(file.suffix().toLower()))
        return tr("Files of this kind cannot be imported.");
    for (const NumberField *field : {mMaxError, mCellSize, mHeightScale, mColumns, mRows})
        if (field->isVisibleTo(this) && !field->value())
            return field->problem();
    return mLayers->problem();
}

void ImportTerrainDialog::refresh()
{
    const QString reason = problem();
    mImport->setEnabled(reason.isEmpty());
    mMessage->showHint(reason.isEmpty() ? bytesText(std::uint64_t(QFileInfo(source()).size())) : reason);
}

model::io::TerrainImportOptions ImportTerrainDialog::options() const
{
    model::io::TerrainImportOptions result;
    result.maxError = mMaxError->value().value_or(0);
    result.raster.cellSize = mCellSize->value().value_or(1);
    result.raster.heightScale = mHeightScale->value().value_or(1);
    result.raw.columns = std::uint32_t(mColumns->value().value_or(1));
    result.raw.rows = std::uint32_t(mRows->value().value_or(1));
    result.raw.type = RawType(mType->currentData().toInt());
    result.raw.isBigEndian = mByteOrder->currentData().toBool();
    result.up = model::io::UpAxis(mUp->currentData().toInt());
    result.crs = mCrs->text().trimmed().toStdString();
    return result;
}

std::vector<model::io::NewLayer> ImportTerrainDialog::layers() const
{
    return mLayers->layers();
}

} // namespace views
