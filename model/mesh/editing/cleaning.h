// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/editing/editedmesh.h"

namespace model {

// Repairs that only take away, name anew or turn: every vertex that stays is where it was. None changes its argument;
// isUnchanged() tells where there was nothing to do. Linear time unless said.

/// Without the faces of these components, as analyseMesh() numbers them.
EditedMesh deleteComponents(const Faces &faces, std::span<const std::uint32_t> components);
/// Without faces of fewer than three corners. A face that has a vertex several times loses what lies between: what is
/// left of three corners or more stays.
EditedMesh removeDegenerateFaces(const Faces &faces);
/// Of the faces with the same corners, whichever way round, the first one stays.
EditedMesh removeDuplicateFaces(const Faces &faces);
/// Without the vertices that no face uses.
EditedMesh removeIsolatedVertices(const Faces &faces);
/// Turns faces until neighbours are wound alike, the fewer of each component. What is closed comes to have its volume
/// above zero. One-sided components stay as they are.
EditedMesh orientFaces(const Faces &faces, std::span<const Vec3f> positions);
/// Gives each fan of a vertex a vertex of its own, and each sheet at an edge of more than two sides its own edge. Sides
/// that run in opposite directions stay together in pairs, in the order of their faces. Where such pairs hang together
/// over other faces at both ends of the edge, as in random soups, the edge stays what it was.
EditedMesh splitNonManifold(const Faces &faces);
/// Makes vertices that are at one place, in every frame, one: the first of them. Corners of a face that fall together
/// become one; faces that keep fewer than three corners go.
/// \param frames     each #V
/// \param tolerance  0: exactly the same place. Else vertices are joined whose coordinates all differ by at most this,
///                   also through others between them.
EditedMesh weldVertices(const Faces &faces, std::span<const std::span<const Vec3f>> frames, float tolerance = 0);

} // namespace model
