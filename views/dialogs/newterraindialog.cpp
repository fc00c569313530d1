// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/newterraindialog.h"

#include "views/dialogs/framepreview.h"
#include "views/dialogs/layersfield.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/terrainpicture.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

#include <algorithm>

namespace views {

using model::io::NewTerrain;
using model::io::ReliefShape;

namespace {

/// Enough to see the shape, and ready in a moment.
constexpr int PreviewCells = 160;
constexpr double MostVertices = 2e7;

QString shapeTitle(ReliefShape shape)
{
    switch (shape) {
    case ReliefShape::Dunes:
        return NewTerrainDialog::tr("Dunes");
    case ReliefShape::Noise:
        return NewTerrainDialog::tr("Hills");
    case ReliefShape::Flat:
        break;
    }
    return NewTerrainDialog::tr("Flat");
}

} // namespace

NewTerrainDialog::NewTerrainDialog(QWidget *parent)
    : QDialog(parent)
    , mShape(new QComboBox(this))
    , mLayers(new LayersField(this))
    , mPicture(new FramePicture(this))
    , mMessage(new HintLabel(this))
{
    setWindowTitle(tr("New Terrain"));
    setObjectName(QStringLiteral("newTerrainDialog"));
    for (const ReliefShape choice : model::io::EveryReliefShape)
        mShape->addItem(shapeTitle(choice), int(choice));
    mShape->setObjectName(QStringLiteral("shape"));
    mShape->setCurrentIndex(mShape->findData(int(ReliefShape::Dunes)));

    auto *form = new QFormLayout;
    form->addRow(tr("&Shape:"), mShape);
    const QString metres = tr("m");
    mWidth = addNumber(*form, "width", tr("&Width:"), tr("Width"), 0.1, 100'000, 2, 100, metres);
    mDepth = addNumber(*form, "depth", tr("&Depth:"), tr("Depth"), 0.1, 100'000, 2, 100, metres);
    mSpacing = addNumber(*form, "spacing", tr("&Resolution:"), tr("Resolution"), 0.001, 10'000, 3, 0.5,
                         tr("m between vertices"));
    mHeight = addNumber(*form, "height", tr("&Height:"), tr("Height"), 0.001, 10'000, 3, 6, metres);
    mWavelength =
        addNumber(*form, "wavelength", tr("Si&ze:"), tr("Size"), 0.01, 100'000, 2, 30, tr("m from crest to crest"));
    mSeed = addNumber(*form, "seed", tr("S&eed:"), tr("Seed"), 1, 999'999, 0, 1, tr("another number, another terrain"));
    form->addRow(tr("Layers:"), mLayers);
    mLayers->add(model::terrain::MaterialPreset::DrySand, 3);

    auto *buttons = new QDialogButtonBox(this);
    mCreate = buttons->addButton(tr("&Create"), QDialogButtonBox::AcceptRole);
    mCreate->setObjectName(QStringLiteral("create"));
    mCreate->setDefault(true);
    buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    mPicture->setMinimumSize(360, 280);
    auto *row = new QHBoxLayout;
    auto *left = new QVBoxLayout;
    left->addLayout(form);
    left->addStretch();
    row->addLayout(left);
    row->addWidget(mPicture, 1);
    auto *column = new QVBoxLayout(this);
    column->addLayout(row, 1);
    column->addWidget(mMessage);
    column->addWidget(buttons);

    connect(mShape, &QComboBox::currentIndexChanged, this, &NewTerrainDialog::refresh);
    connect(mLayers, &LayersField::changed, this, &NewTerrainDialog::refresh);
    for (const NumberField *field : {mWidth, mDepth, mSpacing, mHeight, mWavelength, mSeed})
        connect(field, &NumberField::changed, this, &NewTerrainDialog::refresh);
    refresh();
}

NumberField *NewTerrainDialog::addNumber(QFormLayout &form, const char *objectName, const QString &label,
                                         const QString &what, double min, double max, int decimals, double value,
                                         const QString &unit)
{
    auto *field = new NumberField(what, {min, max, decimals}, this);
    field->setObjectName(QLatin1String(objectName));
    field->setValue(value);
    field->setHint(unit);
    form.addRow(label, field);
    return field;
}

ReliefShape NewTerrainDialog::shape() const
{
    return ReliefShape(mShape->currentData().toInt());
}

QString NewTerrainDialog::name() const
{
    return shapeTitle(shape());
}

NewTerrain NewTerrainDialog::description() const
{
    NewTerrain result;
    result.width = mWidth->value().value_or(1);
    result.depth = mDepth->value().value_or(1);
    result.spacing = mSpacing->value().value_or(1);
    result.relief = {shape(), mHeight->value().value_or(1), mWavelength->value().value_or(1),
                     std::uint32_t(mSeed->value().value_or(1))};
    result.layers = mLayers->layers();
    return result;
}

QString NewTerrainDialog::problem() const
{
    for (const NumberField *field : {mWidth, mDepth, mSpacing})
        if (!field->value())
            return field->problem();
    if (shape() != ReliefShape::Flat)
        for (const NumberField *field : {mHeight, mWavelength, mSeed})
            if (!field->value())
                return field->problem();
    if (!mLayers->problem().isEmpty())
        return mLayers->problem();
    if (vertexCountOf(description()) > MostVertices)
        return tr("%1 vertices are too many; at most %2 can be made. Choose a larger distance between them.")
            .arg(QLocale().toString(vertexCountOf(description()), 'f', 0), QLocale().toString(MostVertices, 'f', 0));
    return {};
}

void NewTerrainDialog::refresh()
{
    const bool isFlat = shape() == ReliefShape::Flat;
    for (NumberField *field : {mHeight, mWavelength, mSeed})
        field->setEnabled(!isFlat);
    const QString reason = problem();
    mCreate->setEnabled(reason.isEmpty());
    if (!reason.isEmpty()) {
        mMessage->showHint(reason);
        return;
    }
    mMessage->showHint(tr("%1 vertices").arg(QLocale().toString(vertexCountOf(description()), 'f', 0)));
    drawPreview();
}

void NewTerrainDialog::drawPreview()
{
    mIsOutdated = mMaking.isRunning();
    if (mIsOutdated)
        return; // the newest wish is drawn when the one before is ready
    NewTerrain coarse = description();
    coarse.spacing = std::max(coarse.spacing, std::max(coarse.width, coarse.depth) / PreviewCells);
    coarse.layers.clear();
    mMaking.start(
        [coarse](const model::Progress &progress) -> model::Result<model::FrameSourcePtr> {
            const auto terrain = model::io::makeTerrain(coarse, progress);
            if (!terrain)
                return model::fail(terrain.error());
            return terrainPreview(*terrain, PreviewCells, progress);
        },
        [this](const model::Result<model::FrameSourcePtr> &made) {
            if (made && *made) // nothing: it was called off
                mPicture->setFrames(*made, model::boundingBox((*made)->frame(0)));
            if (mIsOutdated)
                drawPreview();
        });
}

} // namespace views
