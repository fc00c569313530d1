// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/mesh/analysis/borderloops.h"

#include <array>
#include <optional>

namespace model {

/// Faces that hang together by edges, whatever number of faces an edge has.
struct ComponentReport
{
    std::uint32_t vertices = 0; ///< a vertex where components touch counts in each of them
    std::uint32_t edges = 0, faces = 0;
    std::uint32_t boundaryLoops = 0, boundaryEdges = 0;
    /// Looking at edges of two faces only. Not: it is one-sided, as a Moebius strip.
    bool isOrientable = true;
    /// Every edge has one face or two, no vertex has faces in more than one fan, no face a vertex twice.
    bool isManifold = true;
    std::uint32_t inconsistentEdges = 0; ///< along which its two faces run the same way
    /// Of an orientable manifold the number of its handles: euler() = 2 - 2 genus - boundaryLoops. Of a one-sided one
    /// the number of its cross-caps (non-orientable genus): euler() = 2 - genus - boundaryLoops, so that a Moebius
    /// strip and a projective plane have 1, a Klein bottle 2. None for what is no manifold.
    std::optional<std::uint32_t> genus;
    double area = 0;
    /// Of a closed, orientable manifold: above zero if most faces are wound counter-clockwise seen from outside.
    std::optional<double> volume;
    std::uint32_t firstFace = 0;
    Box3f box;

    std::int64_t euler() const { return std::int64_t(vertices) - edges + faces; }
};

/// A boundary loop.
struct HoleReport
{
    std::uint32_t component = 0;
    BorderLoop loop;
    double length = 0;
    /// Of a flat lid: what the loop encloses seen along its mean normal. Exact for flat loops, convex or not; no lid
    /// is smaller.
    double area = 0;
};

/// What can be wrong with a mesh. \see problemKey()
enum class ProblemKind : std::uint8_t {
    NonManifoldEdge,    ///< three faces or more meet at it (two sides of one face count twice)
    NonManifoldVertex,  ///< its faces make more than one fan
    InconsistentEdge,   ///< its two faces run along it in the same direction
    DegenerateFace,     ///< a vertex twice, or fewer than three
    ZeroAreaFace,       ///< three vertices or more, on a line
    DuplicateFace,      ///< the corners of an earlier face, whichever way round
    IsolatedVertex,     ///< no face uses it
    CoincidentVertex,   ///< exactly where an earlier vertex is
    InsideOutComponent, ///< closed, with a volume below zero
    SelfIntersection,   ///< two faces that meet where they should not; found by findSelfIntersections() alone
};
inline constexpr std::size_t ProblemKindCount = 10;
/// "non_manifold_edges", ...: names in files and in the JSON of the command line.
const char *problemKey(ProblemKind kind);

/// Which vertices or faces are at fault: one number, or two (an edge's vertices, the smaller first; two faces; a vertex
/// or face and the earlier one that it repeats).
using ProblemIds = std::array<std::uint32_t, 2>;
inline constexpr std::uint32_t NoId = ~std::uint32_t(0); ///< in place of the second

struct MeshReport
{
    std::uint32_t vertices = 0; ///< with those that no face uses
    std::uint32_t edges = 0, faces = 0;
    std::vector<ComponentReport> components;
    std::vector<std::uint32_t> componentOfFace; ///< #F
    std::vector<HoleReport> holes;              ///< by their first sides
    /// Of each kind, ascending.
    std::array<std::vector<ProblemIds>, ProblemKindCount> problems;

    const std::vector<ProblemIds> &of(ProblemKind kind) const { return problems[std::size_t(kind)]; }
    std::int64_t euler() const
    {
        return std::int64_t(vertices - of(ProblemKind::IsolatedVertex).size()) - edges + faces;
    }
    bool isManifold() const;
    bool isOrientable() const;
    /// Of all components together, if each has one and all are orientable.
    std::optional<std::uint32_t> genus() const;
};

/// A face counts as one without area where its area is below this share of its longest side's square: what rounding of
/// floats leaves of a line.
inline constexpr double ZeroAreaShare = 1e-7;

/// Looks at a mesh as it is: nothing is repaired or left out before it is counted.
/// \param positions  #V
/// \error Cancelled
/// Cost: linear but for vertices of very many faces; about 60 bytes for a triangle.
/// Definitions, and how they follow from one another: README of this folder.
Result<MeshReport> analyseMesh(const Faces &faces, std::span<const Vec3f> positions,
                               const Progress &progress = Progress());

} // namespace model
