// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/slotmarks.h"
#include "model/terrain/tin/tinarrays.h"

#include <optional>
#include <vector>

namespace model::terrain {

/// Slots first, first + 1, ... of an array.
struct SlotRange
{
    std::uint32_t first = 0, count = 0;

    friend constexpr bool operator==(const SlotRange &, const SlotRange &) = default;
};

/// What of the TIN's memory is asked about.
enum class TinPart : std::uint8_t { Points, Heights, Triangles, Layers };

/// One finished change of a TIN, as a value: the bytes of every slot that it wrote, as they are on the other side of
/// the change. Tin::swap() exchanges the two sides: undo and redo are the same swap, and exact to the byte.
class Edit
{
public:
    /// Memory that the edit holds, for a history's budget.
    std::size_t byteSize() const;
    bool isEmpty() const;
    /// Nothing but heights and layers: no vertex, triangle or constraint is another.
    bool isValuesOnly() const;
    /// The slots of `part` that the edit wrote, ascending, neighbours joined: what to upload or save again.
    std::vector<SlotRange> dirtyRanges(TinPart part) const;

private:
    friend class Journal;
    friend class OtherSide;
    friend class EarlierSurface;
    friend class EditJoiner;

    template <class T>
    struct Saved
    {
        std::uint32_t slot;
        T value;
    };
    struct Links
    {
        Corner corner;
        std::uint32_t constraints;
    };
    struct Triangle
    {
        VertexId vertices[3];
        Corner opposites[3];
        std::uint8_t flags;
    };
    struct Slots
    {
        std::uint32_t vertices = 0, triangles = 0, records = 0;

        friend constexpr bool operator==(const Slots &, const Slots &) = default;
    };
    /// The layers of vertices, as many values for each as there are layers.
    struct Columns
    {
        std::vector<VertexId> vertices;
        std::vector<double> thicknesses;
        std::vector<float> humidities;
    };
    /// All layers of all vertices: what an edit keeps that changes the number of layers.
    struct AllColumns
    {
        FlatArray<double> thicknesses;
        FlatArray<float> humidities;
    };
    /// The slots that only the side after the edit has, while the TIN is on the other.
    struct Tail
    {
        std::vector<Point2> points;
        std::vector<double> heights, thicknesses;
        std::vector<float> humidities;
        std::vector<Links> links;
        std::vector<Triangle> triangles;
        std::vector<ConstraintRecord> records;
    };

    std::vector<Saved<Point2>> mPoints;
    std::vector<Saved<double>> mHeights;
    Columns mColumns;
    std::optional<AllColumns> mAllColumns; ///< instead of mColumns and the tail's
    std::vector<Saved<Links>> mLinks;
    std::vector<Saved<Triangle>> mTriangles;
    std::vector<Saved<ConstraintRecord>> mRecords;
    Tail mTail;
    TinTotals mTotals;
    Slots mBefore, mAfter;
    bool mChangesLayers = false; ///< how many there are, or what they are made of
    bool mIsUndone = false;
};

/// What an edit did to vertices and constraints, without the numbers of slots: by points, which tell vertices apart in
/// any copy of the TIN.
struct EditChanges
{
    struct Line
    {
        Point2 a, b;
        OwnerId owner = None;

        friend constexpr bool operator==(const Line &, const Line &) = default;
    };
    std::vector<Point2> removed;   ///< where there was a vertex, and is none
    std::vector<VertexId> present; ///< vertices that are new or have another height or other layers
    std::vector<Line> released;    ///< constraints that were, and are not; VoidOwner's too
    std::vector<Line> constrained; ///< constraints that are, and were not
    bool changesLayers = false;    ///< how many there are, or of what: `present` does not list what that changed
};

/// What led from the other side of `edit` to `tin`, which is on one of its sides. After an undo, that is what the undo
/// did. Cost: that of the edit.
EditChanges changesOf(const Edit &edit, const TinArrays &tin);

/// Saves slots before they are written for the first time in an edit.
class Journal
{
public:
    bool isRecording() const { return mIsRecording; }

    void begin(const TinArrays &tin);
    /// Ends recording; the edit holds what was before.
    Edit end(const TinArrays &tin);
    /// Exchanges the two sides of an edit. Precondition: the TIN is on one of them.
    static void swap(TinArrays &tin, Edit &edit);

    // Before each write. Slots that the edit itself added need no saving.
    void touchPoint(const TinArrays &tin, VertexId v)
    {
        if (v < mBase.vertices && mSeenPoints.set(v))
            mEdit.mPoints.push_back({v, tin.points[v]});
    }
    void touchHeight(const TinArrays &tin, VertexId v)
    {
        if (v < mBase.vertices && mSeenHeights.set(v))
            mEdit.mHeights.push_back({v, tin.heights[v]});
    }
    void touchColumn(const TinArrays &tin, VertexId v)
    {
        if (v < mBase.vertices && !mEdit.mAllColumns && mSeenColumns.set(v))
            saveColumn(tin, v);
    }
    /// Before the number of layers changes.
    void touchAllColumns(const TinArrays &tin);
    void touchLinks(const TinArrays &tin, VertexId v)
    {
        if (v < mBase.vertices && mSeenLinks.set(v))
            mEdit.mLinks.push_back({v, {tin.corners[v], tin.constraints[v]}});
    }
    void touchTriangle(const TinArrays &tin, TriangleId t)
    {
        if (t < mBase.triangles && mSeenTriangles.set(t))
            mEdit.mTriangles.push_back({t, read(tin, t)});
    }
    void touchRecord(const TinArrays &tin, std::uint32_t r)
    {
        if (r < mBase.records && mSeenRecords.set(r))
            mEdit.mRecords.push_back({r, tin.records[r]});
    }

    /// Notes that `v` was created or connected anew. True if that is news.
    bool noteReconnected(VertexId v)
    {
        mReconnected.resize(std::size_t(v) + 1);
        return mReconnected.set(v);
    }
    void forgetReconnected(VertexId v) { mReconnected.clear(v); }

    /// Vertex slots of an edit whose vertices may have come or gone.
    template <class Visit>
    static void forEachLinkedVertex(const Edit &edit, Visit visit)
    {
        for (const auto &saved : edit.mLinks)
            visit(saved.slot);
        for (VertexId v = edit.mBefore.vertices; v < edit.mAfter.vertices; ++v)
            visit(v);
    }

    std::size_t byteSize() const;

private:
    static Edit::Triangle read(const TinArrays &tin, TriangleId t);
    static void write(TinArrays &tin, TriangleId t, const Edit::Triangle &triangle);
    void saveColumn(const TinArrays &tin, VertexId v);
    static void swapColumns(TinArrays &tin, Edit &edit);
    static void takeTail(TinArrays &tin, Edit &edit);
    static void giveTail(TinArrays &tin, Edit &edit);

    bool mIsRecording = false;
    Edit::Slots mBase;
    Edit mEdit;
    SlotMarks mSeenPoints, mSeenHeights, mSeenColumns, mSeenLinks, mSeenTriangles, mSeenRecords, mReconnected;
};

} // namespace model::terrain
