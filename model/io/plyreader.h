// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/geometry/vec3d.h"
#include "model/mesh/faces.h"

#include <string_view>

namespace model::io {

/// Parses PLY: text and binary of both byte orders; elements and properties in any order and of any type, of which the
/// x, y, z of `vertex` and the vertex_indices (or vertex_index) of `face` are taken. Polygons become fans.
/// \param mesh  written; its memory is reused
/// \error BadMagic, SyntaxError, UnsupportedVersion, UnsupportedFeature (triangle strips, elements without the
///        properties above), DuplicateChunk (an element twice), BadValue, Truncated, TrailingBytes (binary), NonFinite,
///        IndexOutOfRange, each with its line (header and text) or byte (binary); NoVertices; Cancelled
/// Format: Turk, "The PLY Polygon File Format", 1994, with the type names of later writers (int8 ... float64).
/// \param precise  where not null: gets the positions in double
/// \param faces  where not null: gets the faces as they are, `mesh` gets no triangles; then faces of one or two corners
///               and files without a vertex are fine too
Result<void> parsePly(std::string_view bytes, TriangleMesh &mesh, const Progress &progress = Progress(),
                      std::vector<Vec3d> *precise = nullptr, Faces *faces = nullptr);

} // namespace model::io
