// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/terrain/table.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<double, Kernel>; // the height
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cgal = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                                        CGAL::No_constraint_intersection_requiring_constructions_tag>;

std::vector<Kernel::Point_2> cgalPoints(std::span<const Point3> points)
{
    std::vector<Kernel::Point_2> result;
    for (const Point3 &p : points)
        result.emplace_back(p.x, p.y);
    return result;
}

} // namespace

struct CgalTriangulation::Data
{
    Cgal cgal;
    std::vector<Cgal::Vertex_handle> hints, inserted;
};

CgalTriangulation::CgalTriangulation()
    : mData(std::make_unique<Data>())
{}
CgalTriangulation::~CgalTriangulation() = default;

double CgalTriangulation::build(std::span<const Point3> points)
{
    const auto all = cgalPoints(points);
    const Stopwatch stopwatch;
    mData->cgal.insert(all.begin(), all.end());
    return stopwatch.seconds();
}

void CgalTriangulation::findHints(std::span<const Point3> points)
{
    mData->hints.clear();
    for (const auto &p : cgalPoints(points)) {
        const Cgal::Face_handle face = mData->cgal.locate(p);
        mData->hints.push_back(mData->cgal.is_infinite(face->vertex(0)) ? face->vertex(1) : face->vertex(0));
    }
}

double CgalTriangulation::insert(std::span<const Point3> points)
{
    const auto all = cgalPoints(points);
    mData->inserted.resize(all.size());
    const Stopwatch stopwatch;
    for (std::size_t i = 0; i < all.size(); ++i)
        mData->inserted[i] = mData->cgal.insert(all[i], mData->hints[i]->face());
    return stopwatch.seconds();
}

double CgalTriangulation::remove()
{
    const Stopwatch stopwatch;
    for (const Cgal::Vertex_handle v : mData->inserted)
        mData->cgal.remove(v);
    return stopwatch.seconds();
}

double CgalTriangulation::locate(std::span<const Point3> points) const
{
    const auto all = cgalPoints(points);
    std::size_t odd = 0;
    const Stopwatch stopwatch;
    for (std::size_t i = 0; i < all.size(); ++i)
        odd += mData->cgal.locate(all[i], mData->hints[i]->face()) == Cgal::Face_handle();
    const double seconds = stopwatch.seconds();
    return odd ? -1 : seconds;
}

} // namespace bench
