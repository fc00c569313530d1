// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/mesh/faces.h"

#include <memory>

#include <vtkSmartPointer.h>

class vtkPolyData;
class vtkStaticCellLocator;

namespace views {

/// A mesh as VTK takes it, made in a worker and shared by every view of the mesh; the views add colours to copies that
/// share all else. Private to views/inspect.
struct MeshScenery
{
    std::shared_ptr<const model::PolygonMesh> mesh;
    model::Box3f box;
    std::vector<model::Vec3f> normals; ///< #V, of length 1
    /// All vertices, and the faces: cell f is face f.
    vtkSmartPointer<vtkPolyData> faces;
    /// The same vertices, and few triangles between some of them, for when the picture turns; null for a mesh that is
    /// quick to draw.
    vtkSmartPointer<vtkPolyData> coarse;
    vtkSmartPointer<vtkStaticCellLocator> locator; ///< of `faces`
};
using MeshSceneryPtr = std::shared_ptr<const MeshScenery>;

/// \error Cancelled
model::Result<MeshSceneryPtr> makeScenery(std::shared_ptr<const model::PolygonMesh> mesh,
                                          const model::Progress &progress = model::Progress());

/// Triangles between one vertex of each cell of a grid, in place of those of the mesh: \param cells  along the
/// diagonal of the box. Vertices keep their numbers, so colours stay. Source: J. Rossignac, P. Borrel, Multi-resolution
/// 3D approximations for rendering complex scenes, 1993. Differs: the vertex nearest to the cell's middle stands for
/// it.
std::vector<model::Triangle> clusterTriangles(const model::PolygonMesh &mesh, std::uint32_t cells);

} // namespace views
