// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/mesh/trianglemesh.h"

#include <string_view>

namespace model::io {

/// A parsed OBJ file, and what lets the next frame of its animation skip the faces.
struct ObjMesh
{
    TriangleMesh mesh;
    /// Where the first `f` line starts; the length of the text without one.
    std::size_t facesBegin = 0;
    /// No `v` line follows the first `f` line.
    bool facesLast = true;
};

/// The faces of a frame that was parsed before: the same bytes after as many vertices mean the same faces.
struct ObjFaces
{
    std::string_view text; ///< from facesBegin to the end; empty: nothing to compare with
    std::uint32_t vertexCount = 0;
};

/// Parses OBJ text: `v` (columns after the third are ignored) and `f` (v, v/vt, v//vn, v/vt/vn; negative indices count
/// from the last vertex; polygons become fans). Everything else is skipped. `\` at a line's end continues `v` and `f`.
/// \param mesh   written; its memory is reused
/// \param known  if the faces are these, `mesh.connectivity.triangles` stays empty and true is returned
/// \returns      true if the faces are those of `known`
/// \error SyntaxError, NonFinite, IndexOutOfRange, each with its line; NoVertices; Cancelled
/// Format: Wavefront, "Advanced Visualizer" appendix B1, 1992. Differs: the `w` of a vertex is ignored.
Result<bool> parseObj(std::string_view text, ObjMesh &mesh, const Progress &progress = Progress(),
                      const ObjFaces &known = {});

} // namespace model::io
