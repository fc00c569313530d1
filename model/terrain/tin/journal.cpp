// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/journal.h"

#include <algorithm>
#include <cassert>

namespace model::terrain {

namespace {

template <class T>
std::size_t bytesOf(const std::vector<T> &values)
{
    return values.capacity() * sizeof(T);
}

/// Exchanges a saved value with its slot.
template <class Saved, class Array>
void swapSlots(std::vector<Saved> &saved, Array &array)
{
    for (Saved &entry : saved)
        std::swap(entry.value, array[entry.slot]);
}

template <class T>
void moveTail(FlatArray<T> &array, std::size_t from, std::vector<T> &tail)
{
    tail.assign(array.data() + from, array.data() + array.size());
    array.resize(from);
}

template <class T>
void appendTail(FlatArray<T> &array, std::vector<T> &tail)
{
    const std::size_t from = array.size();
    array.resize(from + tail.size());
    std::copy(tail.begin(), tail.end(), array.data() + from);
    std::vector<T>().swap(tail);
}

} // namespace

std::size_t Edit::byteSize() const
{
    return sizeof(Edit) + bytesOf(mPoints) + bytesOf(mHeights) + bytesOf(mAreas) + bytesOf(mLinks) +
           bytesOf(mTriangles) + bytesOf(mRecords) + bytesOf(mTail.points) + bytesOf(mTail.heights) +
           bytesOf(mTail.areas) + bytesOf(mTail.links) + bytesOf(mTail.triangles) + bytesOf(mTail.records);
}

bool Edit::isEmpty() const
{
    return mPoints.empty() && mHeights.empty() && mAreas.empty() && mLinks.empty() && mTriangles.empty() &&
           mRecords.empty() && mBefore.vertices == mAfter.vertices && mBefore.triangles == mAfter.triangles &&
           mBefore.records == mAfter.records;
}

std::vector<SlotRange> Edit::dirtyRanges(TinPart part) const
{
    std::vector<std::uint32_t> slots;
    const auto collect = [&](const auto &saved) {
        slots.reserve(saved.size());
        for (const auto &entry : saved)
            slots.push_back(entry.slot);
    };
    switch (part) {
    case TinPart::Points:
        collect(mPoints);
        break;
    case TinPart::Heights:
        collect(mHeights);
        break;
    case TinPart::Areas:
        collect(mAreas);
        break;
    case TinPart::Triangles:
        collect(mTriangles);
        break;
    }
    std::sort(slots.begin(), slots.end());
    std::vector<SlotRange> ranges;
    for (const std::uint32_t slot : slots) {
        if (ranges.empty() || ranges.back().first + ranges.back().count != slot)
            ranges.push_back({slot, 0});
        ++ranges.back().count;
    }
    const bool isTriangles = part == TinPart::Triangles;
    const std::uint32_t added = isTriangles ? mBefore.triangles : mBefore.vertices;
    const std::uint32_t limit = isTriangles ? mAfter.triangles : mAfter.vertices;
    if (added < limit) {
        if (ranges.empty() || ranges.back().first + ranges.back().count != added)
            ranges.push_back({added, 0});
        ranges.back().count += limit - added;
    }
    return ranges;
}

void Journal::begin(const TinArrays &tin)
{
    assert(!mIsRecording && "an edit is open already");
    mIsRecording = true;
    mBase = {tin.vertexSlots(), tin.triangleSlots(), std::uint32_t(tin.records.size())};
    mEdit = {};
    mEdit.mTotals = tin.totals;
    mSeenPoints.resize(mBase.vertices);
    mSeenHeights.resize(mBase.vertices);
    mSeenAreas.resize(mBase.vertices);
    mSeenLinks.resize(mBase.vertices);
    mSeenTriangles.resize(mBase.triangles);
    mSeenRecords.resize(mBase.records);
}

Edit Journal::end(const TinArrays &tin)
{
    assert(mIsRecording);
    mIsRecording = false;
    mEdit.mBefore = mBase;
    mEdit.mAfter = {tin.vertexSlots(), tin.triangleSlots(), std::uint32_t(tin.records.size())};
    const auto clear = [](Bits &bits, const auto &saved) {
        for (const auto &entry : saved)
            bits.clear(entry.slot);
    };
    clear(mSeenPoints, mEdit.mPoints);
    clear(mSeenHeights, mEdit.mHeights);
    clear(mSeenAreas, mEdit.mAreas);
    clear(mSeenLinks, mEdit.mLinks);
    clear(mSeenTriangles, mEdit.mTriangles);
    clear(mSeenRecords, mEdit.mRecords);
    return std::exchange(mEdit, {});
}

Edit::Triangle Journal::read(const TinArrays &tin, TriangleId t)
{
    const VertexId *const v = tin.triangleVertices.data() + 3 * std::size_t(t);
    const Corner *const o = tin.opposites.data() + 3 * std::size_t(t);
    return {{v[0], v[1], v[2]}, {o[0], o[1], o[2]}, tin.triangleFlags[t]};
}

void Journal::write(TinArrays &tin, TriangleId t, const Edit::Triangle &triangle)
{
    std::copy(triangle.vertices, triangle.vertices + 3, tin.triangleVertices.data() + 3 * std::size_t(t));
    std::copy(triangle.opposites, triangle.opposites + 3, tin.opposites.data() + 3 * std::size_t(t));
    tin.triangleFlags[t] = triangle.flags;
}

void Journal::swap(TinArrays &tin, Edit &edit)
{
    [[maybe_unused]] const Edit::Slots &side = edit.mIsUndone ? edit.mBefore : edit.mAfter;
    assert(tin.vertexSlots() == side.vertices && tin.triangleSlots() == side.triangles &&
           tin.records.size() == side.records && "the TIN is on neither side of the edit");
    if (!edit.mIsUndone)
        takeTail(tin, edit);
    swapSlots(edit.mPoints, tin.points);
    swapSlots(edit.mHeights, tin.heights);
    swapSlots(edit.mAreas, tin.areas);
    for (auto &saved : edit.mLinks) {
        std::swap(saved.value.corner, tin.corners[saved.slot]);
        std::swap(saved.value.constraints, tin.constraints[saved.slot]);
    }
    for (auto &saved : edit.mTriangles) {
        const Edit::Triangle now = read(tin, saved.slot);
        write(tin, saved.slot, saved.value);
        saved.value = now;
    }
    swapSlots(edit.mRecords, tin.records);
    if (edit.mIsUndone)
        giveTail(tin, edit);
    std::swap(edit.mTotals, tin.totals);
    edit.mIsUndone = !edit.mIsUndone;
}

void Journal::takeTail(TinArrays &tin, Edit &edit)
{
    Edit::Tail &tail = edit.mTail;
    for (TriangleId t = edit.mBefore.triangles; t < edit.mAfter.triangles; ++t)
        tail.triangles.push_back(read(tin, t));
    for (VertexId v = edit.mBefore.vertices; v < edit.mAfter.vertices; ++v)
        tail.links.push_back({tin.corners[v], tin.constraints[v]});
    moveTail(tin.points, edit.mBefore.vertices, tail.points);
    moveTail(tin.heights, edit.mBefore.vertices, tail.heights);
    moveTail(tin.areas, edit.mBefore.vertices, tail.areas);
    moveTail(tin.records, edit.mBefore.records, tail.records);
    tin.resizeVertices(edit.mBefore.vertices);
    tin.resizeTriangles(edit.mBefore.triangles);
}

void Journal::giveTail(TinArrays &tin, Edit &edit)
{
    Edit::Tail &tail = edit.mTail;
    appendTail(tin.points, tail.points);
    appendTail(tin.heights, tail.heights);
    appendTail(tin.areas, tail.areas);
    appendTail(tin.records, tail.records);
    tin.resizeVertices(edit.mAfter.vertices);
    tin.resizeTriangles(edit.mAfter.triangles);
    for (std::size_t i = 0; i < tail.links.size(); ++i) {
        tin.corners[edit.mBefore.vertices + i] = tail.links[i].corner;
        tin.constraints[edit.mBefore.vertices + i] = tail.links[i].constraints;
    }
    for (std::size_t i = 0; i < tail.triangles.size(); ++i)
        write(tin, edit.mBefore.triangles + std::uint32_t(i), tail.triangles[i]);
    tail = {};
}

std::size_t Journal::byteSize() const
{
    return mSeenPoints.byteSize() + mSeenHeights.byteSize() + mSeenAreas.byteSize() + mSeenLinks.byteSize() +
           mSeenTriangles.byteSize() + mSeenRecords.byteSize() + mNotedAreas.byteSize();
}

} // namespace model::terrain
