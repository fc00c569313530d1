// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: P. Liepa: Filling Holes in Meshes, 2003, as CGAL 5.5 has it (Polygon Mesh Processing)
#include "model/mesh/editing/cgalholes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/refine.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/utility.h>

namespace model {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
namespace processing = CGAL::Polygon_mesh_processing;

} // namespace

HolePatch triangulateLoop(std::span<const Vec3d> loop, bool refine)
{
    std::vector<Kernel::Point_3> points;
    for (const Vec3d &p : loop)
        points.emplace_back(p.x, p.y, p.z);
    HolePatch patch;
    using Indices = CGAL::Triple<int, int, int>;
    std::vector<Indices> triangles;
    // CGAL throws where its preconditions on the points fail; no lid is the answer then.
    try {
        processing::triangulate_hole_polyline(points, std::back_inserter(triangles));
        for (const Indices &t : triangles)
            patch.triangles.push_back({std::uint32_t(t.first), std::uint32_t(t.second), std::uint32_t(t.third)});
        if (!refine || triangles.empty())
            return patch;
        Surface surface;
        for (const Kernel::Point_3 &point : points)
            surface.add_vertex(point);
        for (const Indices &t : triangles) {
            const auto vertex = [](int i) { return Surface::Vertex_index(std::uint32_t(i)); };
            if (surface.add_face(vertex(t.first), vertex(t.second), vertex(t.third)) == Surface::null_face())
                return patch; // no surface can have these: the coarse lid will do
        }
        std::vector<Surface::Face_index> faces(surface.faces().begin(), surface.faces().end()), addedFaces;
        std::vector<Surface::Vertex_index> added;
        processing::refine(surface, faces, std::back_inserter(addedFaces), std::back_inserter(added));
        patch.triangles.clear();
        for (const Surface::Face_index face : surface.faces()) {
            Triangle triangle;
            std::size_t i = 0;
            for (const Surface::Vertex_index vertex : surface.vertices_around_face(surface.halfedge(face)))
                triangle[i++] = std::uint32_t(vertex);
            patch.triangles.push_back(triangle);
        }
        for (auto v = std::uint32_t(loop.size()); v < surface.number_of_vertices(); ++v) {
            const Kernel::Point_3 &p = surface.point(Surface::Vertex_index(v));
            patch.added.push_back({p.x(), p.y(), p.z()});
        }
    } catch (const std::exception &) {
        return {};
    }
    return patch;
}

} // namespace model
