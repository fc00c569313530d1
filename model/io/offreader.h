// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/io/parsedmesh.h"
#include "model/mesh/faces.h"

namespace model::io {

/// Parses OFF text, also with colours, normals or texture coordinates (COFF, NOFF, STOFF and their combinations), which
/// are skipped: a vertex is the first three numbers of its line. Comments start with `#`. Polygons become fans.
/// \param mesh   written; its memory is reused
/// \param known  if the faces are these, they are not parsed, and `mesh` gets no triangles
/// \param faces  where not null: gets the faces as they are, `mesh` gets no triangles; then faces of one or two corners
///               and files without a vertex are fine too
/// \returns      true if the faces are those of `known`
/// \error BadMagic, UnsupportedFeature (binary, other than 3 dimensions), BadValue, Truncated, SyntaxError, NonFinite,
///        IndexOutOfRange, each with its line; NoVertices; Cancelled
/// Format: Geomview manual, "OFF Files". Differs: what follows the last face is ignored.
Result<bool> parseOff(std::string_view text, ParsedMesh &mesh, const Progress &progress = Progress(),
                      const KnownFaces &known = {}, Faces *faces = nullptr);

} // namespace model::io
