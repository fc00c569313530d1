// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/terrain/changematerials.h"

#include <QCoreApplication>

#include <algorithm>

namespace commands {

using namespace model::terrain;

namespace {

std::vector<Material> with(std::vector<Material> materials, const Material &material)
{
    if (materials.size() < LargestMaterialList)
        materials.push_back(material);
    return materials;
}

std::vector<Material> replaced(std::vector<Material> materials, std::uint8_t index, const Material &material)
{
    materials[index] = material;
    return materials;
}

bool isUsed(const Tin &tin, std::uint8_t index)
{
    const LayerTable &layers = tin.arrays().totals.layers;
    return std::find(layers.materials, layers.materials + layers.count, index) != layers.materials + layers.count;
}

std::vector<Material> without(const Terrain &terrain, std::uint8_t index)
{
    std::vector<Material> materials = terrain.materials;
    if (!isUsed(terrain.tin, index))
        materials.erase(materials.begin() + index);
    return materials;
}

QString nameIn(const std::vector<Material> &materials, std::uint8_t index)
{
    return QString::fromStdString(materials[index].name);
}

} // namespace

ChangeMaterials::ChangeMaterials(model::TerrainDocument &document, const QString &text, std::vector<Material> materials,
                                 GestureId gesture)
    : WeightedCommand(text)
    , mDocument(document)
    , mOther(std::move(materials))
    , mGesture(gesture)
{
    setObsolete(mOther == mDocument.terrain().materials);
}

void ChangeMaterials::redo()
{
    // In an order in which every layer has a material at every step.
    if (mLayers)
        mDocument.swap(*mLayers);
    else if (mRemoved >= 0)
        mLayers = mDocument.edit([this](TinEdit &edit) {
            const LayerTable layers = edit.tin().arrays().totals.layers;
            for (std::uint32_t l = 0; l < layers.count; ++l)
                if (layers.materials[l] > mRemoved)
                    edit.setLayerMaterial(l, std::uint8_t(layers.materials[l] - 1));
        });
    mOther = mDocument.setMaterials(std::move(mOther));
}

void ChangeMaterials::undo()
{
    mOther = mDocument.setMaterials(std::move(mOther));
    if (mLayers)
        mDocument.swap(*mLayers);
}

bool ChangeMaterials::mergeWith(const QUndoCommand *newer)
{
    if (static_cast<const ChangeMaterials *>(newer)->mGesture != mGesture)
        return false;
    setText(newer->text());
    setObsolete(mDocument.terrain().materials == mOther);
    return true;
}

std::size_t ChangeMaterials::byteSize() const
{
    std::size_t bytes = sizeof(*this) + mOther.size() * sizeof(Material);
    for (const Material &material : mOther)
        bytes += material.name.size() + material.criticalAngles.size() * sizeof(CriticalAngle);
    return bytes + (mLayers ? mLayers->byteSize() : 0);
}

AddMaterial::AddMaterial(model::TerrainDocument &document, const Material &material)
    : ChangeMaterials(document, QCoreApplication::translate("Undo", "Add Material"),
                      with(document.terrain().materials, material))
{}

RemoveMaterial::RemoveMaterial(model::TerrainDocument &document, std::uint8_t index)
    : ChangeMaterials(
          document,
          QCoreApplication::translate("Undo", "Remove Material %1").arg(nameIn(document.terrain().materials, index)),
          without(document.terrain(), index))
{
    mRemoved = index;
}

EditMaterial::EditMaterial(model::TerrainDocument &document, std::uint8_t index, const Material &material,
                           GestureId gesture)
    : ChangeMaterials(
          document,
          QCoreApplication::translate("Undo", "Change Material %1").arg(QString::fromStdString(material.name)),
          replaced(document.terrain().materials, index, material), gesture)
{}

} // namespace commands
