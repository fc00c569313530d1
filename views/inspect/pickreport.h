// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/inspect/inspection.h"

#include <optional>

namespace views {

/// What a click picks.
enum class PickMode : std::uint8_t { Face, Edge, Vertex };

/// A face, an edge or a vertex of a mesh.
struct Picked
{
    PickMode mode = PickMode::Face;
    std::uint32_t face = 0; ///< that was hit
    /// Of an edge both ends, of a vertex itself twice.
    std::uint32_t vertices[2] = {0, 0};
};

/// What of a face is nearest to a place on it. Nothing of faces with fewer than two corners.
std::optional<Picked> pickedAt(const model::PolygonMesh &mesh, std::uint32_t face, const model::Vec3f &place,
                               PickMode mode);

/// Everything about it, a line each: what, and the value. The first line is its name. All numbers count from 0, as in
/// files and on the command line. Cost: one look at each face.
std::vector<std::pair<QString, QString>> describe(const Picked &picked, Inspection &inspection);

} // namespace views
