// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/geometry/vec3d.h"
#include "model/io/parsedmesh.h"
#include "model/mesh/faces.h"

namespace model::io {

/// Parses OBJ text: `v` (columns after the third are ignored) and `f` (v, v/vt, v//vn, v/vt/vn; negative indices count
/// from the last vertex; polygons become fans). Everything else is skipped. `\` at a line's end continues `v` and `f`.
/// \param mesh   written; its memory is reused
/// \param known  if the faces are these, they are not parsed, and `mesh` gets no triangles
/// \param precise  where not null: gets the positions in double
/// \param faces  where not null: gets the faces as they are, `mesh` gets no triangles; then faces of one or two corners
///               and files without a vertex are fine too
/// \returns      true if the faces are those of `known`
/// \error SyntaxError, NonFinite, IndexOutOfRange, each with its line; NoVertices; Cancelled
/// Format: Wavefront, "Advanced Visualizer" appendix B1, 1992. Differs: the `w` of a vertex is ignored.
Result<bool> parseObj(std::string_view text, ParsedMesh &mesh, const Progress &progress = Progress(),
                      const KnownFaces &known = {}, std::vector<Vec3d> *precise = nullptr, Faces *faces = nullptr);

} // namespace model::io
