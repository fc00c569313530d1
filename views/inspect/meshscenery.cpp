// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspect/meshscenery.h"

#include "model/mesh/normals.h"

#include <QtGlobal>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>
#include <vtkTypeInt32Array.h>

namespace views {

namespace {

/// Meshes of more faces turn as a coarse one: llvmpipe draws some 5 million triangles a second.
constexpr std::uint32_t FacesThatTurn = 150'000;
/// Of the coarse one, along the diagonal. A closed surface becomes about 60 000 triangles.
constexpr std::uint32_t CoarseCells = 200;

vtkSmartPointer<vtkPoints> pointsOf(const std::vector<model::Vec3f> &positions)
{
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(vtkIdType(positions.size()));
    std::copy_n(reinterpret_cast<const float *>(positions.data()), 3 * positions.size(), coordinates->GetPointer(0));
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetData(coordinates);
    return points;
}

vtkSmartPointer<vtkCellArray> cellsOf(const model::Faces &faces)
{
    vtkNew<vtkTypeInt32Array> begins, corners;
    begins->SetNumberOfValues(vtkIdType(faces.faceCount()) + 1);
    for (std::uint32_t face = 0; face < faces.faceCount(); ++face)
        begins->SetValue(face, vtkTypeInt32(faces.begin(face)));
    begins->SetValue(faces.faceCount(), vtkTypeInt32(faces.cornerCount()));
    corners->SetNumberOfValues(faces.cornerCount());
    std::copy(faces.vertices().begin(), faces.vertices().end(), corners->GetPointer(0));
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(begins, corners);
    return cells;
}

vtkSmartPointer<vtkCellArray> cellsOf(const std::vector<model::Triangle> &triangles)
{
    vtkNew<vtkTypeInt32Array> corners;
    corners->SetNumberOfValues(vtkIdType(3 * triangles.size()));
    std::copy_n(reinterpret_cast<const std::uint32_t *>(triangles.data()), 3 * triangles.size(),
                corners->GetPointer(0));
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(3, corners);
    return cells;
}

vtkSmartPointer<vtkPolyData> polyData(vtkPoints *points, vtkCellArray *cells)
{
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    return data;
}

} // namespace

std::vector<model::Triangle> clusterTriangles(const model::PolygonMesh &mesh, std::uint32_t cells)
{
    const model::Box3f box = model::boundingBox(mesh.positions);
    const float size = box.diagonal() / float(std::max(cells, 1u));
    if (size <= 0)
        return {};
    struct Cell
    {
        std::uint32_t vertex;
        float distance; ///< of the vertex from the cell's middle
    };
    std::unordered_map<std::uint64_t, std::uint32_t> indexOf;
    std::vector<Cell> found;
    std::vector<std::uint32_t> cellOf(mesh.positions.size());
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        const model::Vec3f place = (mesh.positions[v] - box.min) * (1 / size);
        const model::Vec3f corner{std::floor(place.x), std::floor(place.y), std::floor(place.z)};
        const std::uint64_t key =
            std::uint64_t(corner.x) | std::uint64_t(corner.y) << 21 | std::uint64_t(corner.z) << 42;
        const float distance = model::length(place - corner - model::Vec3f{0.5f, 0.5f, 0.5f});
        const auto [at, isNew] = indexOf.try_emplace(key, std::uint32_t(found.size()));
        if (isNew)
            found.push_back({v, distance});
        else if (distance < found[at->second].distance)
            found[at->second] = {v, distance};
        cellOf[v] = at->second;
    }
    std::vector<model::Triangle> result;
    const auto standIn = [&](std::uint32_t vertex) { return found[cellOf[vertex]].vertex; };
    for (std::uint32_t f = 0; f < mesh.faces.faceCount(); ++f) {
        const std::span<const std::uint32_t> face = mesh.faces.face(f);
        for (std::size_t i = 2; i < face.size(); ++i) {
            const model::Triangle t{standIn(face[0]), standIn(face[i - 1]), standIn(face[i])};
            if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
                result.push_back(t);
        }
    }
    // Thin parts fall together: many triangles of the same three cells.
    const auto rotated = [](model::Triangle t) {
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        return t;
    };
    std::transform(result.begin(), result.end(), result.begin(), rotated);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

model::Result<MeshSceneryPtr> makeScenery(std::shared_ptr<const model::PolygonMesh> mesh,
                                          const model::Progress &progress)
{
    auto scenery = std::make_shared<MeshScenery>();
    scenery->box = model::boundingBox(mesh->positions);
    scenery->normals.resize(mesh->positions.size());
    model::computeVertexNormals(mesh->positions, model::fans(mesh->faces).triangles, scenery->normals);
    const vtkSmartPointer<vtkPoints> points = pointsOf(mesh->positions);
    scenery->faces = polyData(points, cellsOf(mesh->faces));
    progress.report(0.2);
    if (progress.isCancelled())
        return model::fail(model::ErrorCode::Cancelled);
    if (mesh->faces.faceCount() > FacesThatTurn)
        scenery->coarse = polyData(points, cellsOf(clusterTriangles(*mesh, CoarseCells)));
    progress.report(0.6);
    if (progress.isCancelled())
        return model::fail(model::ErrorCode::Cancelled);
    scenery->locator = vtkSmartPointer<vtkStaticCellLocator>::New();
    if (mesh->faces.faceCount() > 0) {
        scenery->locator->SetDataSet(scenery->faces);
        scenery->locator->BuildLocator();
    }
    scenery->mesh = std::move(mesh);
    return MeshSceneryPtr(std::move(scenery));
}

} // namespace views
