// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/sequence.h"

#include <memory>
#include <string>
#include <vector>

namespace tests {

// The meshes under test. Small, each with one property that algorithms stumble over.

model::TriangleMesh cube();           ///< closed, 8 vertices, 12 triangles, (-1,-1,-1)..(1,1,1)
model::TriangleMesh tetrahedron();    ///< the smallest closed mesh
model::TriangleMesh torus();          ///< closed, genus 1, 12 x 8
model::TriangleMesh twoParts();       ///< a cube and a tetrahedron beside it
model::TriangleMesh degenerate();     ///< with a triangle of two equal indices, one without area, and one twice
model::TriangleMesh nonManifold();    ///< three triangles at one edge
model::TriangleMesh bowTie();         ///< two triangles that share only a vertex
model::TriangleMesh misoriented();    ///< two neighbours wound against each other
model::TriangleMesh oneTriangle();    ///< the smallest with a boundary
model::TriangleMesh isolatedVertex(); ///< a tetrahedron and a vertex without a triangle
model::TriangleMesh noTriangles();    ///< three vertices alone
model::TriangleMesh oneVertex();      ///< a single point
model::TriangleMesh none();           ///< nothing at all
/// With boundary: columns x rows squares of two triangles each, in the plane z = 0 over 0..1, row after row.
model::TriangleMesh grid(std::uint32_t columns = 6, std::uint32_t rows = 4);

struct NamedMesh
{
    std::string name;
    model::TriangleMesh mesh;
};
/// Every mesh above, once.
const std::vector<NamedMesh> &namedMeshes();

// Small animations. Precondition of all: the mesh has a vertex, frameCount > 0. Deterministic.

using SequencePtr = std::shared_ptr<const model::Sequence>;

/// One turn around the z axis over all frames: rank at most 4 with its mean, each distance kept.
SequencePtr rigidRotation(const model::TriangleMesh &mesh, std::uint32_t frameCount = 12);
/// Every vertex swings along z with a phase that depends on x and y.
SequencePtr wave(const model::TriangleMesh &mesh, std::uint32_t frameCount = 12);
/// Every coordinate of every frame moved at random by up to 0.1: of full rank.
SequencePtr noise(const model::TriangleMesh &mesh, std::uint32_t frameCount = 12, std::uint32_t seed = 1);
/// The same frame again and again.
SequencePtr constant(const model::TriangleMesh &mesh, std::uint32_t frameCount = 12);
SequencePtr oneFrame(const model::TriangleMesh &mesh);

struct NamedAnimation
{
    std::string name;
    SequencePtr sequence;
};
/// A wave over every mesh of the table that has a vertex, and every other kind of animation over some.
const std::vector<NamedAnimation> &namedAnimations();

} // namespace tests
