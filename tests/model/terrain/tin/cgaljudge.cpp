// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/terrain/tin/cgaljudge.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <tuple>

namespace tests {

namespace {

using namespace model::terrain;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexId, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Judge = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                                         CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Edge = std::tuple<VertexId, VertexId, bool>;

Edge edgeOf(VertexId a, VertexId b, bool isConstrained)
{
    return {std::min(a, b), std::max(a, b), isConstrained};
}

} // namespace

std::string differenceFromCgal(const Tin &tin)
{
    const TinArrays &arrays = tin.arrays();
    Judge judge;
    std::vector<std::pair<Kernel::Point_2, VertexId>> points;
    for (VertexId v = 0; v < arrays.vertexSlots(); ++v)
        if (arrays.isVertex(v))
            points.push_back({{arrays.points[v].x, arrays.points[v].y}, v});
    judge.insert(points.begin(), points.end());
    if (judge.number_of_vertices() != points.size())
        return "two vertices at one place";
    std::vector<Judge::Vertex_handle> handles(arrays.vertexSlots());
    for (auto v = judge.finite_vertices_begin(); v != judge.finite_vertices_end(); ++v)
        handles[v->info()] = v;
    std::vector<Edge> ours;
    for (TriangleId t = 0; t < arrays.triangleSlots(); ++t) {
        if (!arrays.isTriangle(t))
            continue;
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
            if (arrays.opposite(c) < c)
                continue;
            const VertexId a = arrays.vertex(next(c)), b = arrays.vertex(previous(c));
            ours.push_back(edgeOf(a, b, arrays.isConstrained(c)));
            if (arrays.isConstrained(c))
                judge.insert_constraint(handles[a], handles[b]);
        }
    }
    std::vector<Edge> theirs;
    for (auto e = judge.finite_edges_begin(); e != judge.finite_edges_end(); ++e)
        theirs.push_back(edgeOf(e->first->vertex(Judge::cw(e->second))->info(),
                                e->first->vertex(Judge::ccw(e->second))->info(), judge.is_constrained(*e)));
    std::sort(ours.begin(), ours.end());
    std::sort(theirs.begin(), theirs.end());
    if (ours == theirs)
        return {};
    const auto [our, their] = std::mismatch(ours.begin(), ours.end(), theirs.begin(), theirs.end());
    const auto text = [](const auto &list, const auto &at) -> std::string {
        return at == list.end() ? "none"
                                : std::to_string(std::get<0>(*at)) + "-" + std::to_string(std::get<1>(*at)) +
                                      (std::get<2>(*at) ? " constrained" : "");
    };
    return "ours " + text(ours, our) + ", CGAL's " + text(theirs, their) + ", of " + std::to_string(ours.size()) +
           " and " + std::to_string(theirs.size());
}

} // namespace tests
