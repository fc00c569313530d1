// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/io/meshfile.h"
#include "model/mesh/faces.h"

#include <QString>

namespace model::io {

/// Parses a mesh file, its faces exactly as they are: polygons stay whole, and faces of one or two corners stay too. A
/// text file without a vertex is a mesh of nothing. What no structure can hold is an error all the same, such as an
/// index out of range. Errors as parseMesh().
Result<PolygonMesh> parsePolygonMesh(MeshKind kind, std::string_view bytes, const Progress &progress = Progress());

/// One mesh as parsePolygonMesh() has it: OBJ, OFF, PLY, STL. Of anything else that
/// readAnimation() reads (glTF among it) the triangles of the first frame.
/// Errors as readAnimation(), but a text file without a vertex is a mesh of nothing.
Result<PolygonMesh> readPolygonMesh(const QString &path, const Progress &progress = Progress());

} // namespace model::io
