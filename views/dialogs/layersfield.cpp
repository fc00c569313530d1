// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/layersfield.h"

#include "model/terrain/tin/layers.h"
#include "views/dialogs/numberfield.h"
#include "views/widgets/icons.h"

#include <QComboBox>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace views {

using model::terrain::MaterialPreset;

QString materialTitle(MaterialPreset preset)
{
    switch (preset) {
    case MaterialPreset::DrySand:
        return LayersField::tr("Dry Sand");
    case MaterialPreset::MoistSand:
        return LayersField::tr("Moist Sand");
    case MaterialPreset::Mud:
        return LayersField::tr("Mud");
    case MaterialPreset::Snow:
        return LayersField::tr("Snow");
    case MaterialPreset::Gravel:
        return LayersField::tr("Gravel");
    case MaterialPreset::Custom:
        break;
    }
    return LayersField::tr("Custom");
}

LayersField::LayersField(QWidget *parent)
    : QWidget(parent)
    , mColumn(new QVBoxLayout(this))
    , mAdd(new QPushButton(tr("&Add Layer"), this))
{
    mColumn->setContentsMargins(0, 0, 0, 0);
    mColumn->addWidget(mAdd, 0, Qt::AlignLeft);
    mAdd->setObjectName(QStringLiteral("addLayer"));
    mAdd->setAutoDefault(false);
    connect(mAdd, &QPushButton::clicked, this, [this] { add(MaterialPreset::DrySand, 1); });
}

void LayersField::add(MaterialPreset preset, double thickness)
{
    Row row{new QWidget(this), new QComboBox(this), new NumberField(tr("Thickness"), {0, 1000, 3}, this),
            new QToolButton(this)};
    for (const MaterialPreset choice : model::terrain::EveryMaterialPreset)
        if (choice != MaterialPreset::Custom)
            row.material->addItem(materialTitle(choice), int(choice));
    row.material->setCurrentIndex(row.material->findData(int(preset)));
    row.thickness->setValue(thickness);
    row.thickness->setStep(0.1);
    row.thickness->setHint(tr("m"));
    row.remove->setIcon(icon(QStringLiteral("close")));
    row.remove->setAutoRaise(true);
    auto *line = new QHBoxLayout(row.widget);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(row.material);
    line->addWidget(row.thickness, 1);
    line->addWidget(row.remove);
    connect(row.material, &QComboBox::currentIndexChanged, this, &LayersField::changed);
    connect(row.thickness, &NumberField::changed, this, &LayersField::changed);
    connect(row.remove, &QToolButton::clicked, this, [this, widget = row.widget] { remove(widget); });
    mColumn->insertWidget(0, row.widget);
    mRows.insert(mRows.begin(), row);
    numberRows();
    emit changed();
}

void LayersField::remove(const QWidget *widget)
{
    const auto row = std::find_if(mRows.begin(), mRows.end(), [widget](const Row &r) { return r.widget == widget; });
    row->widget->deleteLater();
    row->widget->hide();
    mColumn->removeWidget(row->widget);
    mRows.erase(row);
    numberRows();
    emit changed();
}

void LayersField::numberRows()
{
    int number = 0;
    for (const Row &row : mRows) {
        ++number;
        row.material->setAccessibleName(tr("Material of layer %1 from above").arg(number));
        row.material->setObjectName(QStringLiteral("material%1").arg(number));
        row.thickness->input().setAccessibleName(tr("Thickness of layer %1 from above").arg(number));
        row.remove->setAccessibleName(tr("Remove layer %1 from above").arg(number));
        row.remove->setToolTip(tr("Remove this layer"));
    }
    mAdd->setEnabled(mRows.size() < model::terrain::MaxLayers);
}

std::vector<model::io::NewLayer> LayersField::layers() const
{
    std::vector<model::io::NewLayer> result;
    for (auto row = mRows.rbegin(); row != mRows.rend(); ++row)
        result.push_back({model::terrain::material(MaterialPreset(row->material->currentData().toInt())),
                          row->thickness->value().value_or(0)});
    return result;
}

QString LayersField::problem() const
{
    for (const Row &row : mRows)
        if (!row.thickness->value())
            return row.thickness->problem();
    return {};
}

} // namespace views
