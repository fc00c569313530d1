// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/terrain/historybudget.h"
#include "model/document/meshdocument.h"

namespace commands {

/// Puts what an operation made of the mesh in its place. Operations take long: they run on the immutable mesh in the
/// background, and come back as this one step. Obsolete if the mesh is the same.
class ChangeMesh final : public WeightedCommand
{
public:
    /// \param text  of the step: "Fill 3 Holes"
    ChangeMesh(model::MeshDocument &document, const QString &text, model::PolygonMeshPtr mesh);

    void redo() override { swap(); }
    void undo() override { swap(); }
    std::size_t byteSize() const override;

private:
    void swap() { mOther = mDocument.setMesh(std::move(mOther)); }

    model::MeshDocument &mDocument;
    model::PolygonMeshPtr mOther; ///< the mesh that the document does not have now
};

} // namespace commands
