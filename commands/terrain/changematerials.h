// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/base/mergeid.h"
#include "commands/terrain/historybudget.h"
#include "model/document/terraindocument.h"

#include <optional>

namespace commands {

/// Gives a terrain another list of materials, and its layers their places in it. Concrete commands are constructors.
class ChangeMaterials : public WeightedCommand
{
public:
    void redo() final;
    void undo() final;
    std::size_t byteSize() const final;
    int id() const final { return mGesture == NoGesture ? -1 : int(MergeId::EditMaterial); }
    bool mergeWith(const QUndoCommand *newer) final;

protected:
    ChangeMaterials(model::TerrainDocument &document, const QString &text,
                    std::vector<model::terrain::Material> materials, GestureId gesture = NoGesture);

    model::TerrainDocument &mDocument;
    /// Layers of materials behind this one move up by one place. -1: none do.
    int mRemoved = -1;

private:
    std::vector<model::terrain::Material> mOther; ///< the list that the document does not have now
    std::optional<model::terrain::Edit> mLayers;
    const GestureId mGesture;
};

/// Puts a material at the end of the list. Nothing happens to a list that is full.
class AddMaterial final : public ChangeMaterials
{
public:
    /// Precondition: check(material) finds nothing.
    AddMaterial(model::TerrainDocument &document, const model::terrain::Material &material);
};

/// Takes a material off the list. Obsolete if a layer is made of it.
class RemoveMaterial final : public ChangeMaterials
{
public:
    RemoveMaterial(model::TerrainDocument &document, std::uint8_t index);
};

/// Gives a material of the list other parameters.
class EditMaterial final : public ChangeMaterials
{
public:
    /// Precondition: check(material) finds nothing.
    EditMaterial(model::TerrainDocument &document, std::uint8_t index, const model::terrain::Material &material,
                 GestureId gesture = NoGesture);
};

} // namespace commands
