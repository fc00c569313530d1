// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/faces.h"

#include <QObject>

#include <memory>

namespace model {

using PolygonMeshPtr = std::shared_ptr<const PolygonMesh>;

/// A mesh being edited. The mesh itself is immutable, so that workers and views keep what they have; an edit puts
/// another one in its place. Knows nothing of undo, files or views.
class MeshDocument final : public QObject
{
    Q_OBJECT

public:
    /// Precondition: not null.
    explicit MeshDocument(PolygonMeshPtr mesh, QObject *parent = nullptr);

    const PolygonMeshPtr &mesh() const { return mMesh; }
    /// Precondition: not null. \returns the mesh before
    PolygonMeshPtr setMesh(PolygonMeshPtr mesh);

    /// A digest of everything that is saved: equal fingerprints mean that the same file would be written.
    std::uint64_t fingerprint() const;

signals:
    /// It has another mesh; not sent for the same one.
    void changed();

private:
    PolygonMeshPtr mMesh;
};

} // namespace model
