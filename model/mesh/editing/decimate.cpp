// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/editing/decimate.h"

#include "model/mesh/analysis/meshreport.h"
#include "model/mesh/editing/openmeshdecimate.h"

namespace model {

namespace {

std::vector<std::uint32_t> verticesOf(const Connectivity &mesh, ProblemKind kind, const std::vector<ProblemIds> &list)
{
    std::vector<std::uint32_t> vertices;
    for (const ProblemIds &ids : list) {
        if (kind == ProblemKind::DegenerateFace)
            vertices.insert(vertices.end(), mesh.triangles[ids[0]].begin(), mesh.triangles[ids[0]].end());
        else
            vertices.push_back(ids[0]);
        if (ids[1] != NoId)
            vertices.push_back(ids[1]);
    }
    return vertices;
}

} // namespace

EditResult decimate(const Faces &faces, std::span<const Vec3f> positions, std::uint32_t target,
                    const Progress &progress)
{
    const Connectivity mesh = fans(faces);
    const auto report = analyseMesh(Faces(mesh), positions, progress.part(0, 0.2));
    if (!report)
        return failEdit(EditError::Kind::Cancelled);
    for (const ProblemKind kind : {ProblemKind::NonManifoldEdge, ProblemKind::NonManifoldVertex,
                                   ProblemKind::InconsistentEdge, ProblemKind::DegenerateFace})
        if (const auto &list = report->of(kind); !list.empty())
            return failEdit(EditError::Kind::NotManifold, verticesOf(mesh, kind, list));
    const auto left = decimatedTriangles(positions, mesh.triangles, target, progress.part(0.2, 1));
    if (progress.isCancelled())
        return failEdit(EditError::Kind::Cancelled);
    if (!left)
        return failEdit(EditError::Kind::NotManifold);
    MeshBuilder builder(faces);
    for (const Triangle &triangle : *left)
        builder.addFace(triangle, EditedMesh::NewFace);
    return std::move(builder).finish();
}

} // namespace model
