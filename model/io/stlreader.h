// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/geometry/vec3d.h"
#include "model/mesh/trianglemesh.h"

#include <string_view>

namespace model::io {

/// Parses STL, text or binary, into the corners of its triangles: three positions each. STL has no vertices; see
/// weldCorners().
/// \param corners  #T*3, written; its memory is reused
/// \error BadMagic, SyntaxError, Truncated, TrailingBytes, NonFinite, each with its line or byte; NoVertices; Cancelled
/// Format: 3D Systems, "StereoLithography Interface Specification", 1989. Normals and attributes are skipped.
/// \param precise  where not null: gets the corners in double
Result<void> parseStl(std::string_view bytes, std::vector<Vec3f> &corners, const Progress &progress = Progress(),
                      std::vector<Vec3d> *precise = nullptr);

/// Corners at exactly the same place become one vertex; vertices are in the order of their first corner.
/// \param corners  #T*3
TriangleMesh weldCorners(std::span<const Vec3f> corners);
/// \param connectivity  empty; written
std::vector<Vec3d> weldCorners(std::span<const Vec3d> corners, Connectivity &connectivity);

/// The positions of the vertices that weldCorners() made of another frame.
/// \param corners    #T*3
/// \param positions  #V, written
/// \returns          #T if each vertex is in one place, else the first triangle with a corner torn from its vertex
std::size_t gatherVertices(std::span<const Vec3f> corners, std::span<const Triangle> triangles,
                           std::span<Vec3f> positions);

} // namespace model::io
