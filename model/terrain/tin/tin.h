// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/terrain/tin/journal/journal.h"
#include "model/terrain/tin/query/hintgrid.h"
#include "model/terrain/tin/query/locate.h"
#include "model/terrain/tin/query/surface.h"

#include <span>
#include <vector>

namespace model::terrain {

/// A terrain's surface: heights over a constrained Delaunay triangulation of a rectangle. README.md says how it is
/// kept.
///
/// Const functions may be called from several threads at once while nobody changes it. A copy is a snapshot.
class Tin
{
public:
    /// An empty one over `domain`, at height 0: two triangles.
    /// Precondition: the domain has an inside, and no coordinate above LargestCoordinate.
    explicit Tin(const Rectangle &domain);

    const Rectangle &domain() const { return mDomain; }
    std::uint32_t vertexCount() const { return mArrays.totals.vertices; }
    std::uint32_t triangleCount() const { return mArrays.totals.triangles; }
    /// The memory itself, for whoever draws, saves, erodes or feels it.
    const TinArrays &arrays() const { return mArrays; }

    /// Where `p` lies. `near` is a vertex close to it, if one is known: None searches the hint grid.
    /// Precondition: `p` lies in the domain.
    Location locate(Point2 p, VertexId near = None) const;
    double heightAt(Point2 p, VertexId near = None) const;
    /// Of the triangle at `p`; on an edge of the one with the smaller number.
    Gradient gradientAt(Point2 p, VertexId near = None) const;
    /// The triangle at `p`, as for gradientAt().
    TriangleId triangleAt(Point2 p, VertexId near = None) const;

    bool isConstrained(VertexId a, VertexId b) const;
    /// Who constrained the edge a-b; empty for the border of the domain itself and what is not constrained.
    std::vector<OwnerId> ownersOf(VertexId a, VertexId b) const;

    const Ledger &ledger() const { return mArrays.totals.ledger; }
    /// The volume between the surface and height 0, void triangles left out. Cost: O(n).
    double volume() const;
    /// The volume of a mobile layer. Cost: O(n).
    double layerVolume(std::uint32_t layer) const;

    /// Undoes an edit that is done, or does one that is undone: exact to the byte of every array.
    /// Precondition: the edits since it have been undone, in order; no edit is open.
    void swap(Edit &edit);

    /// A digest of all that is state.
    std::uint64_t fingerprint() const;
    /// All memory in use: arrays, hint grid, and the journal's marks.
    std::size_t byteSize() const;

private:
    friend class TinEdit;
    friend struct TinBuilder;
    friend struct TinRestorer;

    TinArrays mArrays;
    Journal mJournal;
    HintGrid mHints;
    Rectangle mDomain;
};

/// A terrain made of points.
struct BuiltTin
{
    Tin tin;
    std::vector<VertexId> vertexOf; ///< of each point; points at the same place share the vertex of the first
    std::uint32_t duplicates = 0;   ///< points that did
};

/// The Delaunay triangulation of `points` over `domain`. The domain's corners become vertices 0 to 3, counter-clockwise
/// from the lowest x and y, at the height of the point nearest to them, if none lies there. \error NonFinite      a
/// coordinate that is no number (its point in the error) \error BadValue       a point outside the domain, or a domain
/// without an inside or too far from the origin \error LimitExceeded  more points than ids
Result<BuiltTin> buildTin(std::span<const Point3> points, const Rectangle &domain);

/// The smallest rectangle that holds all points.
Rectangle boundsOf(std::span<const Point3> points);

} // namespace model::terrain
