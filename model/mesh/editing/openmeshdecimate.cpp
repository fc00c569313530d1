// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/editing/openmeshdecimate.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

namespace model {

namespace {

struct Traits : OpenMesh::DefaultTraits
{
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::Status);
    EdgeAttributes(OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
    FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// Ends the work on a cancel.
class Watch final : public OpenMesh::Decimater::Observer
{
public:
    Watch(const Progress &progress, std::size_t collapses)
        : Observer(1000)
        , mProgress(progress)
        , mCollapses(double(std::max<std::size_t>(collapses, 1)))
    {}
    void notify(std::size_t step) override { mProgress.report(double(step) / mCollapses); }
    bool abort() const override { return mProgress.isCancelled(); }

private:
    const Progress &mProgress;
    const double mCollapses;
};

} // namespace

std::optional<std::vector<Triangle>> decimatedTriangles(std::span<const Vec3f> positions,
                                                        std::span<const Triangle> triangles, std::uint32_t target,
                                                        const Progress &progress)
{
    HalfEdgeMesh mesh;
    std::vector<OpenMesh::VertexHandle> vertices;
    for (const Vec3f &p : positions)
        vertices.push_back(mesh.add_vertex({double(p.x), double(p.y), double(p.z)}));
    for (const Triangle &t : triangles)
        if (!mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]).is_valid())
            return std::nullopt;
    mesh.update_face_normals();

    OpenMesh::Decimater::DecimaterT<HalfEdgeMesh> decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<HalfEdgeMesh>::Handle quadric;
    decimater.add(quadric);
    decimater.module(quadric).unset_max_err();
    Watch watch(progress, (triangles.size() - std::min<std::size_t>(target, triangles.size())) / 2);
    decimater.set_observer(&watch);
    if (!decimater.initialize())
        return std::nullopt;
    decimater.decimate_to_faces(0, target);
    if (progress.isCancelled())
        return std::nullopt;
    std::vector<Triangle> result;
    for (const OpenMesh::FaceHandle face : mesh.faces()) { // those deleted are skipped
        Triangle triangle;
        std::size_t i = 0;
        for (const OpenMesh::VertexHandle vertex : mesh.fv_range(face))
            triangle[i++] = std::uint32_t(vertex.idx());
        result.push_back(triangle);
    }
    return result;
}

} // namespace model
