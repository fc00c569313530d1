// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/journal/journal.h"
#include "model/terrain/tin/predicates.h"
#include "model/terrain/tin/query/surface.h"

#include <initializer_list>
#include <vector>

namespace model::terrain {

/// The steps that all changes of a TIN are made of. Each saves what it writes in the journal, where that is recording,
/// remembers what it connected anew if anybody wants to know, and adds up by how much it changed the volume under the
/// surface.
class TinWriter
{
public:
    TinWriter(TinArrays &arrays, Journal &journal)
        : tin(arrays)
        , mJournal(journal)
        , mIsRecording(journal.isRecording())
    {}

    TinArrays &tin; ///< for reading, and for writing what was touched before

    void touchTriangle(TriangleId t)
    {
        if (mIsRecording)
            mJournal.touchTriangle(tin, t);
    }
    void touchLinks(VertexId v)
    {
        if (mIsRecording)
            mJournal.touchLinks(tin, v);
    }
    void touchRecord(std::uint32_t r)
    {
        if (mIsRecording)
            mJournal.touchRecord(tin, r);
    }

    VertexId addVertex(Point2 point, double height);
    /// Precondition: no triangle and no record uses it.
    void freeVertex(VertexId v);
    TriangleId addTriangle(std::uint8_t flags);
    void freeTriangle(TriangleId t);
    void setHeight(VertexId v, double height)
    {
        if (mIsRecording)
            mJournal.touchHeight(tin, v);
        tin.heights[v] = height;
    }

    /// The layers at a vertex before they are written.
    void touchColumn(VertexId v)
    {
        if (mIsRecording)
            mJournal.touchColumn(tin, v);
    }
    /// The height of the surface with what it is made of: upwards the top layer grows, downwards layers go from the
    /// top, and below them all the bedrock.
    void moveSurface(VertexId v, double height)
    {
        if (tin.layerCount() > 0)
            moveLayers(v, height - tin.heights[v]);
        setHeight(v, height);
    }
    /// Gives `v` the layers of the point that these weights make.
    void setColumn(VertexId v, const Weights &weights);
    /// Inserts a layer, or takes one out. \see TinEdit
    void addLayer(std::uint32_t layer, std::uint8_t material);
    void removeLayer(std::uint32_t layer);

    /// Sets the three vertices of `t`. Whose corner it is from now on is the caller's: moveCorner().
    void setTriangle(TriangleId t, VertexId a, VertexId b, VertexId c);
    void setCornerOf(VertexId v, Corner c)
    {
        touchLinks(v);
        tin.corners[v] = c;
    }
    /// Where `before` was the corner of `v`, `after` becomes it.
    void moveCorner(VertexId v, Corner before, Corner after)
    {
        if (tin.corners[v] == before)
            setCornerOf(v, after);
    }
    /// Joins the edges of two corners. `opposite` carries the constrained bit; BorderOpposite ends at the border.
    void link(Corner c, Corner opposite)
    {
        touchTriangle(triangleOf(c));
        tin.opposites[slotOf(c)] = opposite;
        if (opposite == BorderOpposite)
            return;
        touchTriangle(triangleOf(opposite & ~ConstrainedBit));
        tin.opposites[slotOf(opposite & ~ConstrainedBit)] = c | (opposite & ConstrainedBit);
    }
    void setConstrained(Corner c, bool isConstrained);

    /// Replaces the edge of `c` by the other diagonal of its two triangles. Afterwards `c` has the same vertex, and the
    /// new edge belongs to next(c). Precondition: not constrained; the two triangles form a strictly convex
    /// quadrilateral.
    void flip(Corner c);
    /// Puts `v` into `t`, or onto the edge of `c`, whose constrained bit both halves keep. Afterwards every triangle of
    /// `v` has it at corner 0 and `edges` holds those corners.
    void splitTriangle(TriangleId t, VertexId v);
    void splitEdge(Corner c, VertexId v);

    /// The corners whose edges may have become illegal; restoreDelaunay() starts from them.
    std::vector<Corner> edges;
    /// Flips until no edge violates the empty-circle rule, ties broken as in isInsideCircle(). Empties `edges`.
    void restoreDelaunay();
    /// The same after `v` was put in by a split: faster.
    void restoreDelaunayAround(VertexId v);

    /// From now on takeReconnected() gives the vertices that were created or connected anew.
    void noteReconnected() { mDoesNote = true; }
    void noteVertex(VertexId v)
    {
        if (mDoesNote && mJournal.noteReconnected(v))
            mReconnected.push_back(v);
    }
    /// Those that are still there, ascending; and forgets them.
    std::vector<VertexId> takeReconnected();

    /// What the steps so far changed the volume under the surface by.
    CompensatedSum leak;
    double volumeOf(TriangleId t, double level) const;

private:
    /// Adds what is under these triangles, above the height of a vertex, to the leak. A vertex on the surface changes
    /// no volume where it splits a triangle, but for its rounded height, and that counts beside a needle with a large
    /// neighbour.
    void loseVolume(std::initializer_list<TriangleId> triangles, VertexId level);
    void gainVolume(std::initializer_list<TriangleId> triangles, VertexId level);

    void moveLayers(VertexId v, double up);

    Journal &mJournal;
    const bool mIsRecording;
    bool mDoesNote = false;
    std::vector<VertexId> mReconnected;
};

} // namespace model::terrain
