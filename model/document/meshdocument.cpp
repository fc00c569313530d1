// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/meshdocument.h"

#include "model/base/digest.h"

#include <utility>

namespace model {

MeshDocument::MeshDocument(PolygonMeshPtr mesh, QObject *parent)
    : QObject(parent)
    , mMesh(std::move(mesh))
{
    Q_ASSERT(mMesh);
}

PolygonMeshPtr MeshDocument::setMesh(PolygonMeshPtr mesh)
{
    Q_ASSERT(mesh);
    if (mesh == mMesh)
        return mesh;
    PolygonMeshPtr before = std::exchange(mMesh, std::move(mesh));
    emit changed();
    return before;
}

std::uint64_t MeshDocument::fingerprint() const
{
    std::uint64_t digest = digestOfArray(std::span<const Vec3f>(mMesh->positions));
    for (std::uint32_t face = 0; face < mMesh->faces.faceCount(); ++face)
        digest = digestOfArray(mMesh->faces.face(face), digest);
    return digest;
}

} // namespace model
