// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/trianglemesh.h"

#include <functional>

namespace samples {

/// A rotation followed by a move: p -> x*p.x + y*p.y + z*p.z + origin, the axes being orthonormal.
struct Pose
{
    model::Vec3f x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    model::Vec3f origin;

    model::Vec3f operator()(model::Vec3f p) const { return x * p.x + y * p.y + z * p.z + origin; }
    /// This pose given in the frame of `parent`.
    Pose in(const Pose &parent) const;
};

Pose moved(model::Vec3f by);
/// Turned about an axis through the origin, counter-clockwise seen from its tip; radians.
Pose turnedX(float angle);
Pose turnedY(float angle);
Pose turnedZ(float angle);

/// A closed surface with two poles: `point(u, v)` with u in 0..1 from pole to pole and v in 0..1 around, periodic. The
/// surface must turn counter-clockwise in v seen from the first pole, for triangles that face outwards.
/// \param rings     #rings of vertices between the poles
/// \param segments  vertices in each ring
model::TriangleMesh closedSurface(int rings, int segments, const std::function<model::Vec3f(float u, float v)> &point);

model::TriangleMesh ellipsoid(model::Vec3f radii, int rings, int segments);
/// A limb with round ends from the origin down to (0, -length, 0), its radius going from `top` to `bottom`.
model::TriangleMesh limb(float length, float top, float bottom, int segments);
/// An icosahedron subdivided `levels` times, all vertices on the sphere.
model::TriangleMesh icosphere(float radius, int levels);

/// Adds a part to a mesh as a component of its own.
void append(model::TriangleMesh &mesh, const model::TriangleMesh &part);

} // namespace samples
