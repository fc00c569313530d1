// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/mesh/changemesh.h"

namespace commands {

ChangeMesh::ChangeMesh(model::MeshDocument &document, const QString &text, model::PolygonMeshPtr mesh)
    : WeightedCommand(text)
    , mDocument(document)
    , mOther(std::move(mesh))
{
    setObsolete(mOther == document.mesh() ||
                (mOther->positions == document.mesh()->positions && mOther->faces == document.mesh()->faces));
}

std::size_t ChangeMesh::byteSize() const
{
    return mOther->positions.size() * sizeof(model::Vec3f) +
           mOther->faces.cornerCount() * sizeof(std::uint32_t) * (mOther->faces.areTriangles() ? 1 : 2);
}

} // namespace commands
