// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/terrain/materialdock.h"

#include "commands/terrain/changematerials.h"
#include "commands/terrain/layers.h"
#include "views/dialogs/jobpanel.h"
#include "views/dialogs/measuretext.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/quantitytext.h"
#include "views/docks/terrain/dockform.h"
#include "views/sculpt/materialtitles.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QFormLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace views {

using namespace model::terrain;

namespace {

constexpr int LaterMilliseconds = 300;

QString undoText(const char *text)
{
    return QCoreApplication::translate("Undo", text);
}

} // namespace

MaterialDock::MaterialDock(QWidget *parent)
    : QDockWidget(parent)
{
    setObjectName(QStringLiteral("materialDock"));
    mLater.setInterval(LaterMilliseconds);
    mLater.setSingleShot(true);
    connect(&mLater, &QTimer::timeout, this, &MaterialDock::showLayers);
    build();
}

MaterialDock::~MaterialDock() = default;

void MaterialDock::setContext(commands::TerrainContext *context)
{
    if (context == mContext)
        return;
    for (const QMetaObject::Connection &connection : mConnections)
        disconnect(connection);
    mConnections.clear();
    delete mPanel;
    mPanel = nullptr;
    mWork.reset();
    mContext = context;
    if (context) {
        mGesture = context->newGesture();
        mWork = std::make_unique<BackgroundEdit>(*context);
        mConnections << connect(&context->document(), &model::TerrainDocument::changed, this,
                                &MaterialDock::documentChanged)
                     << connect(context, &QObject::destroyed, this, [this] { setContext(nullptr); })
                     << connect(&mWork->job(), &Job::runningChanged, this, &MaterialDock::showLayers);
    }
    showMaterials();
    showLayers();
}

void MaterialDock::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        build();
    QDockWidget::changeEvent(event);
}

void MaterialDock::documentChanged(const model::TerrainChange &change)
{
    if (std::holds_alternative<model::MaterialsChanged>(change)) {
        showMaterials();
        showLayers();
    } else if (!mLater.isActive()) {
        mLater.start();
    }
}

void MaterialDock::build()
{
    setWindowTitle(tr("Materials"));
    mContent = new QWidget;
    mColumn = new QVBoxLayout(mContent);
    mPanel = nullptr;
    mColumn->addWidget(makeLayers(mContent));
    mColumn->addWidget(makeMaterials(mContent));
    mColumn->addStretch();
    setScrolledWidget(*this, mContent);
    showMaterials();
    showLayers();
}

QWidget *MaterialDock::makeLayers(QWidget *parent)
{
    auto *box = new QGroupBox(tr("Layers"), parent);
    auto *column = new QVBoxLayout(box);
    mLayers = new QTreeWidget(box);
    mLayers->setObjectName(QStringLiteral("layers"));
    mLayers->setAccessibleName(tr("Layers, the top one first"));
    mLayers->setHeaderLabels({tr("Material"), tr("Mean Thickness")});
    mLayers->headerItem()->setTextAlignment(1, Qt::AlignRight);
    mLayers->setRootIsDecorated(false);
    mLayers->setUniformRowHeights(true);
    mLayers->setMinimumHeight(96);
    mLayers->setMaximumHeight(140); // a few layers are usual; the materials below are to be seen
    mLayers->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    mLayers->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    mLayers->header()->setStretchLastSection(false);
    connect(mLayers, &QTreeWidget::currentItemChanged, this, [this] {
        if (!mIsShowing)
            showLayers();
    });
    column->addWidget(mLayers);
    auto *form = new QFormLayout;
    mLayerMaterial = new QComboBox(box);
    mLayerMaterial->setObjectName(QStringLiteral("layerMaterial"));
    connect(mLayerMaterial, &QComboBox::activated, this, &MaterialDock::setLayerMaterial);
    addRow(*form, tr("Material:"), mLayerMaterial);
    mThickness = new NumberField(tr("Thickness"), {0, 1e6, 4}, box);
    mThickness->setValue(0.1);
    mThickness->setStep(0.01);
    addRow(*form, tr("Thickness:"), mThickness, QStringLiteral("m"));
    mHumidity = new NumberField(tr("Humidity"), {0, 1, 2}, box);
    mHumidity->setStep(0.05);
    addRow(*form, tr("Humidity:"), mHumidity);
    column->addLayout(form);
    auto *grid = new QGridLayout;
    mAdd = new QPushButton(tr("&Add on Top"), box);
    mAdd->setObjectName(QStringLiteral("addLayer"));
    mFill = new QPushButton(tr("&Fill Layer"), box);
    mFill->setObjectName(QStringLiteral("fillLayer"));
    mFill->setToolTip(tr("Give the layer this thickness and humidity everywhere; the bedrock gives way"));
    mRemove = new QPushButton(tr("&Remove Layer"), box);
    mRemove->setObjectName(QStringLiteral("removeLayer"));
    mRemove->setToolTip(tr("What it held becomes bedrock"));
    connect(mAdd, &QPushButton::clicked, this, &MaterialDock::addLayer);
    connect(mFill, &QPushButton::clicked, this, &MaterialDock::fillLayer);
    connect(mRemove, &QPushButton::clicked, this, [this] {
        run(undoText(QT_TRANSLATE_NOOP("Undo", "Remove Layer")), commands::removeLayer(std::uint32_t(chosenLayer())));
    });
    grid->addWidget(mAdd, 0, 0);
    grid->addWidget(mFill, 0, 1);
    grid->addWidget(mRemove, 1, 0, 1, 2);
    column->addLayout(grid);
    return box;
}

QWidget *MaterialDock::makeMaterials(QWidget *parent)
{
    auto *box = new QGroupBox(tr("Materials"), parent);
    mForm = new QFormLayout(box);
    mMaterials = new QComboBox(box);
    mMaterials->setObjectName(QStringLiteral("materials"));
    connect(mMaterials, &QComboBox::activated, this, &MaterialDock::showMaterial);
    addRow(*mForm, tr("Material:"), mMaterials);
    mPreset = new QComboBox(box);
    mPreset->setObjectName(QStringLiteral("materialPreset"));
    for (const MaterialPreset preset : EveryMaterialPreset)
        mPreset->addItem(titleOf(preset));
    connect(mPreset, &QComboBox::activated, this, &MaterialDock::choosePreset);
    addRow(*mForm, tr("Preset:"), mPreset);
    const auto number = [&](const QString &label, const NumberRange &range, double step, const QString &unit) {
        auto *field = new NumberField(QString(label).remove(QLatin1Char(':')), range, box);
        field->setStep(step);
        connect(field, &NumberField::changed, this, &MaterialDock::editMaterial);
        connect(&field->input(), &QLineEdit::editingFinished, this, [this] {
            if (mContext)
                mGesture = mContext->newGesture();
        });
        addRow(*mForm, label, field, unit);
        return field;
    };
    mDensity = number(tr("Density:"), {1, 1e5, 1}, 10, tr("kg/m³"));
    mPoured = number(tr("Poured humidity:"), {0, 1, 2}, 0.05, {});
    mCompressibility = number(tr("Compressibility:"), {0, 0.99, 2}, 0.05, {});
    mCurve.clear();
    mCurveForm = new QFormLayout;
    mForm->addRow(mCurveForm);
    auto *row = new QHBoxLayout;
    mAddMaterial = new QPushButton(tr("A&dd Material"), box);
    mAddMaterial->setObjectName(QStringLiteral("addMaterial"));
    connect(mAddMaterial, &QPushButton::clicked, this, [this] {
        mContext->push<commands::AddMaterial>(material(MaterialPreset::DrySand));
        mMaterials->setCurrentIndex(mMaterials->count() - 1);
        showMaterial();
    });
    mRemoveMaterial = new QPushButton(tr("R&emove Material"), box);
    mRemoveMaterial->setObjectName(QStringLiteral("removeMaterial"));
    connect(mRemoveMaterial, &QPushButton::clicked, this,
            [this] { mContext->push<commands::RemoveMaterial>(std::uint8_t(mMaterials->currentIndex())); });
    row->addWidget(mAddMaterial);
    row->addWidget(mRemoveMaterial);
    mForm->addRow(row);
    return box;
}

int MaterialDock::chosenLayer() const
{
    QTreeWidgetItem *const item = mLayers->currentItem();
    return item ? mLayers->topLevelItemCount() - 1 - mLayers->indexOfTopLevelItem(item) : -1;
}

void MaterialDock::showLayers()
{
    mIsShowing = true;
    const int chosen = chosenLayer();
    mLayers->clear();
    const bool isBusy = mWork && mWork->job().isRunning();
    const Terrain *const terrain = mContext ? &mContext->document().terrain() : nullptr;
    const std::uint32_t count = terrain ? terrain->tin.arrays().layerCount() : 0;
    if (terrain) {
        const Rectangle &domain = terrain->tin.domain();
        const double area = (domain.high.x - domain.low.x) * (domain.high.y - domain.low.y);
        for (std::uint32_t l = count; l-- > 0;) {
            auto *item = new QTreeWidgetItem(
                mLayers, {titleOf(terrain->materialOf(l)), lengthText(terrain->tin.layerVolume(l) / area)});
            item->setTextAlignment(1, Qt::AlignRight);
        }
    }
    const int layer = chosen >= 0 && chosen < int(count) ? chosen : int(count) - 1;
    if (layer >= 0) {
        mLayers->setCurrentItem(mLayers->topLevelItem(int(count) - 1 - layer));
        mLayerMaterial->setCurrentIndex(terrain->tin.arrays().totals.layers.materials[layer]);
    }
    mAdd->setEnabled(terrain && !isBusy && count < MaxLayers && !terrain->materials.empty());
    mFill->setEnabled(layer >= 0 && !isBusy);
    mRemove->setEnabled(layer >= 0 && !isBusy);
    mLayerMaterial->setEnabled(terrain && !isBusy);
    if (mPanel)
        mPanel->setVisible(isBusy);
    mIsShowing = false;
}

void MaterialDock::showMaterials()
{
    mIsShowing = true;
    const int chosen = mMaterials->currentIndex();
    mMaterials->clear();
    mLayerMaterial->clear();
    if (mContext)
        for (const Material &material : mContext->document().terrain().materials) {
            mMaterials->addItem(titleOf(material));
            mLayerMaterial->addItem(titleOf(material));
        }
    mMaterials->setCurrentIndex(std::clamp(chosen, std::min(0, mMaterials->count() - 1), mMaterials->count() - 1));
    mIsShowing = false;
    showMaterial();
}

/// An angle for each humidity of the material's curve.
void MaterialDock::makeCurve()
{
    const Material &material = mContext->document().terrain().materials[std::size_t(mMaterials->currentIndex())];
    if (mCurve.size() != material.criticalAngles.size()) {
        mCurve.clear();
        clearForm(*mCurveForm);
        for (std::size_t i = 0; i < material.criticalAngles.size(); ++i) {
            auto *field = new NumberField(tr("Critical angle"), {SmallestCriticalAngle, LargestCriticalAngle, 1});
            connect(field, &NumberField::changed, this, &MaterialDock::editMaterial);
            addRow(*mCurveForm, QStringLiteral(" "), field, QStringLiteral("°"));
            mCurve.push_back(field);
        }
    }
    for (std::size_t i = 0; i < mCurve.size(); ++i) {
        const QString label = tr("Angle at humidity %1:").arg(numberText(material.criticalAngles[i].humidity, 2));
        static_cast<QLabel *>(mCurveForm->labelForField(mCurve[i]))->setText(label);
        mCurve[i]->input().setAccessibleName(label);
        showNumber(*mCurve[i], material.criticalAngles[i].degrees);
    }
}

void MaterialDock::showMaterial()
{
    const bool hasMaterial = mContext && mMaterials->currentIndex() >= 0;
    mAddMaterial->setEnabled(mContext && mContext->document().terrain().materials.size() < LargestMaterialList);
    for (QWidget *widget :
         std::initializer_list<QWidget *>{mPreset, mDensity, mPoured, mCompressibility, mRemoveMaterial})
        widget->setEnabled(hasMaterial);
    if (!hasMaterial)
        return;
    mIsShowing = true;
    const Terrain &terrain = mContext->document().terrain();
    const auto index = std::uint8_t(mMaterials->currentIndex());
    const Material &material = terrain.materials[index];
    mPreset->setCurrentIndex(int(presetOf(material)));
    showNumber(*mDensity, material.bulkDensity);
    showNumber(*mPoured, material.humidity);
    showNumber(*mCompressibility, material.compressibility);
    makeCurve();
    const LayerTable &layers = terrain.tin.arrays().totals.layers;
    mRemoveMaterial->setEnabled(std::find(layers.materials, layers.materials + layers.count, index) ==
                                layers.materials + layers.count);
    mIsShowing = false;
}

void MaterialDock::editMaterial()
{
    if (mIsShowing || !mContext || mMaterials->currentIndex() < 0)
        return;
    const auto index = std::uint8_t(mMaterials->currentIndex());
    Material material = mContext->document().terrain().materials[index];
    material.bulkDensity = mDensity->value().value_or(material.bulkDensity);
    material.humidity = mPoured->value().value_or(material.humidity);
    material.compressibility = mCompressibility->value().value_or(material.compressibility);
    for (std::size_t i = 0; i < std::min(mCurve.size(), material.criticalAngles.size()); ++i)
        material.criticalAngles[i].degrees = mCurve[i]->value().value_or(material.criticalAngles[i].degrees);
    if (check(material))
        mContext->push<commands::EditMaterial>(index, material, mGesture);
}

void MaterialDock::choosePreset(int row)
{
    const MaterialPreset preset = EveryMaterialPreset[row];
    if (preset == MaterialPreset::Custom)
        return showMaterial(); // what the others are not
    mContext->push<commands::EditMaterial>(std::uint8_t(mMaterials->currentIndex()), material(preset));
}

void MaterialDock::run(const QString &text, commands::EditSurface::Work work)
{
    delete mPanel;
    auto *panel = new JobPanel(mWork->job(), mContent);
    panel->setActivity(text);
    mPanel = panel;
    mColumn->insertWidget(0, panel);
    mWork->start(text, [work = std::move(work)](TinEdit &edit, const model::Progress &) -> model::Result<void> {
        work(edit);
        return {};
    });
}

void MaterialDock::addLayer()
{
    if (!mThickness->value() || !mHumidity->value())
        return;
    const auto material = std::uint8_t(std::max(0, mLayerMaterial->currentIndex()));
    run(undoText(QT_TRANSLATE_NOOP("Undo", "Add Layer")),
        commands::addLayer(mContext->document().tin().arrays().layerCount(), material,
                           {*mThickness->value(), float(*mHumidity->value())}));
}

void MaterialDock::fillLayer()
{
    if (!mThickness->value() || !mHumidity->value())
        return;
    run(undoText(QT_TRANSLATE_NOOP("Undo", "Fill Layer")),
        commands::fillLayer(std::uint32_t(chosenLayer()), {*mThickness->value(), float(*mHumidity->value())}));
}

/// Of the layer that is chosen; without one, of the next that is added.
void MaterialDock::setLayerMaterial(int material)
{
    const int layer = chosenLayer();
    if (mIsShowing || layer < 0 || mContext->document().tin().arrays().totals.layers.materials[layer] == material)
        return;
    mContext->push<commands::EditSurface>(undoText(QT_TRANSLATE_NOOP("Undo", "Change Layer's Material")),
                                          commands::setLayerMaterial(std::uint32_t(layer), std::uint8_t(material)));
}

} // namespace views
