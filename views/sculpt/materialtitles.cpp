// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sculpt/materialtitles.h"

#include <QCoreApplication>

namespace views {

using namespace model::terrain;

namespace {

struct MaterialTitles
{
    Q_DECLARE_TR_FUNCTIONS(views::MaterialTitles)
};

} // namespace

QString titleOf(MaterialPreset preset)
{
    switch (preset) {
    case MaterialPreset::DrySand:
        return MaterialTitles::tr("Dry Sand");
    case MaterialPreset::MoistSand:
        return MaterialTitles::tr("Moist Sand");
    case MaterialPreset::Mud:
        return MaterialTitles::tr("Mud");
    case MaterialPreset::Snow:
        return MaterialTitles::tr("Snow");
    case MaterialPreset::Gravel:
        return MaterialTitles::tr("Gravel");
    case MaterialPreset::Custom:
        return MaterialTitles::tr("Custom");
    }
    return {};
}

QString titleOf(const Material &material)
{
    for (const MaterialPreset preset : EveryMaterialPreset)
        if (preset != MaterialPreset::Custom && material.name == nameOf(preset))
            return titleOf(preset);
    return QString::fromStdString(material.name);
}

} // namespace views
