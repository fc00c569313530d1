// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/journal/editjoiner.h"

#include <cassert>

namespace model::terrain {

namespace {

/// Takes over what was saved of slots that the first edit neither added nor saved itself: there `next` saw what lay
/// there before both.
template <class Saved>
void takeOver(std::vector<Saved> &into, const std::vector<Saved> &next, SlotMarks &marks, std::uint32_t before)
{
    for (const Saved &saved : next)
        if (saved.slot < before && marks.set(saved.slot))
            into.push_back(saved);
}

} // namespace

EditJoiner::EditJoiner(const Edit &first)
{
    const auto mark = [](SlotMarks &marks, const auto &saved, std::uint32_t before) {
        marks.resize(before);
        for (const auto &entry : saved)
            marks.set(entry.slot);
    };
    mark(mPoints, first.mPoints, first.mBefore.vertices);
    mark(mHeights, first.mHeights, first.mBefore.vertices);
    mark(mLinks, first.mLinks, first.mBefore.vertices);
    mark(mTriangles, first.mTriangles, first.mBefore.triangles);
    mark(mRecords, first.mRecords, first.mBefore.records);
    mColumns.resize(first.mBefore.vertices);
    for (const VertexId v : first.mColumns.vertices)
        mColumns.set(v);
}

bool EditJoiner::join(Edit &edit, const Edit &next)
{
    assert(!edit.mIsUndone && !next.mIsUndone);
    assert(edit.mAfter == next.mBefore && "the edits do not follow each other");
    if (edit.mChangesLayers || next.mChangesLayers || edit.mAllColumns || next.mAllColumns)
        return false;
    const Edit::Slots before = edit.mBefore;
    takeOver(edit.mPoints, next.mPoints, mPoints, before.vertices);
    takeOver(edit.mHeights, next.mHeights, mHeights, before.vertices);
    takeOver(edit.mLinks, next.mLinks, mLinks, before.vertices);
    takeOver(edit.mTriangles, next.mTriangles, mTriangles, before.triangles);
    takeOver(edit.mRecords, next.mRecords, mRecords, before.records);
    Edit::Columns &columns = edit.mColumns;
    const Edit::Columns &more = next.mColumns;
    const std::size_t count = more.vertices.empty() ? 0 : more.thicknesses.size() / more.vertices.size();
    for (std::size_t i = 0; i < more.vertices.size(); ++i)
        if (more.vertices[i] < before.vertices && mColumns.set(more.vertices[i])) {
            columns.vertices.push_back(more.vertices[i]);
            const auto from = std::ptrdiff_t(i * count), to = from + std::ptrdiff_t(count);
            columns.thicknesses.insert(columns.thicknesses.end(), more.thicknesses.begin() + from,
                                       more.thicknesses.begin() + to);
            columns.humidities.insert(columns.humidities.end(), more.humidities.begin() + from,
                                      more.humidities.begin() + to);
        }
    edit.mAfter = next.mAfter;
    return true;
}

} // namespace model::terrain
