// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/journal/journal.h"

#include <algorithm>
#include <unordered_map>

namespace model::terrain {

/// The TIN as it is on the side of an edit that it is not on, where the edit knows it to be different.
class OtherSide
{
public:
    OtherSide(const Edit &edit, const TinArrays &tin)
        : mEdit(edit)
        , mTin(tin)
        , mSlots(edit.mIsUndone ? edit.mAfter : edit.mBefore)
        , mShared{std::min(edit.mBefore.vertices, edit.mAfter.vertices),
                  std::min(edit.mBefore.triangles, edit.mAfter.triangles),
                  std::min(edit.mBefore.records, edit.mAfter.records)}
    {
        for (const auto &saved : edit.mPoints)
            mPoints.emplace(saved.slot, saved.value);
        for (const auto &saved : edit.mLinks)
            mCorners.emplace(saved.slot, saved.value.corner);
    }

    /// Slots whose vertex may differ, ascending.
    std::vector<VertexId> vertices() const
    {
        std::vector<VertexId> slots = mEdit.mColumns.vertices;
        for (const auto &saved : mEdit.mPoints)
            slots.push_back(saved.slot);
        for (const auto &saved : mEdit.mHeights)
            slots.push_back(saved.slot);
        for (const auto &saved : mEdit.mLinks)
            if (isVertex(saved.slot) != mTin.isVertex(saved.slot))
                slots.push_back(saved.slot);
        for (VertexId v = mShared.vertices; v < std::max(mSlots.vertices, mTin.vertexSlots()); ++v)
            slots.push_back(v);
        std::sort(slots.begin(), slots.end());
        slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
        return slots;
    }
    bool isVertex(VertexId v) const
    {
        if (v >= mSlots.vertices)
            return false;
        if (v >= mShared.vertices)
            return !(mEdit.mTail.links[v - mShared.vertices].corner & FreeVertexBit);
        const auto found = mCorners.find(v);
        return !((found == mCorners.end() ? mTin.corners[v] : found->second) & FreeVertexBit);
    }
    Point2 point(VertexId v) const
    {
        if (v >= mShared.vertices)
            return mEdit.mTail.points[v - mShared.vertices];
        const auto found = mPoints.find(v);
        return found == mPoints.end() ? mTin.points[v] : found->second;
    }

    /// Calls `visit(record on the other side, record now)` for each slot that may differ.
    template <class Visit>
    void forEachRecord(Visit visit) const
    {
        const auto now = [&](std::uint32_t r) {
            return r < mTin.records.size() ? mTin.records[r] : ConstraintRecord{};
        };
        for (const auto &saved : mEdit.mRecords)
            visit(saved.value, now(saved.slot));
        for (std::uint32_t r = mShared.records; r < std::max<std::size_t>(mSlots.records, mTin.records.size()); ++r)
            visit(r < mSlots.records ? mEdit.mTail.records[r - mShared.records] : ConstraintRecord{}, now(r));
    }

    bool changesLayers() const { return mEdit.mChangesLayers; }

private:
    const Edit &mEdit;
    const TinArrays &mTin;
    const Edit::Slots mSlots, mShared;
    std::unordered_map<VertexId, Point2> mPoints;
    std::unordered_map<VertexId, Corner> mCorners;
};

EditChanges changesOf(const Edit &edit, const TinArrays &tin)
{
    const OtherSide before(edit, tin);
    EditChanges changes;
    changes.changesLayers = before.changesLayers();
    for (const VertexId v : before.vertices()) {
        const bool isThere = tin.isVertex(v);
        if (before.isVertex(v) && !(isThere && before.point(v) == tin.points[v]))
            changes.removed.push_back(before.point(v));
        if (isThere)
            changes.present.push_back(v);
    }
    before.forEachRecord([&](const ConstraintRecord &then, const ConstraintRecord &now) {
        const bool was = then.a != None, is = now.a != None;
        const EditChanges::Line old =
            was ? EditChanges::Line{before.point(then.a), before.point(then.b), then.owner} : EditChanges::Line{};
        const EditChanges::Line line =
            is ? EditChanges::Line{tin.points[now.a], tin.points[now.b], now.owner} : EditChanges::Line{};
        if (was && is && old == line)
            return;
        if (was)
            changes.released.push_back(old);
        if (is)
            changes.constrained.push_back(line);
    });
    return changes;
}

} // namespace model::terrain
