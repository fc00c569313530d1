// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/journal/journal.h"

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

/// Appends a slot that comes after those in `ranges`.
void append(std::vector<SlotRange> &ranges, std::uint32_t slot)
{
    if (ranges.empty() || ranges.back().first + ranges.back().count != slot)
        ranges.push_back({slot, 0});
    ++ranges.back().count;
}

/// Ascending, of slots below `end`, each there once.
std::vector<SlotRange> rangesOf(std::vector<std::uint32_t> slots, std::uint32_t end)
{
    // From here on going over marks is faster than sorting.
    constexpr std::size_t SlotsForMarks = 4096, ShareForMarks = 64;
    std::vector<SlotRange> ranges;
    if (slots.size() < SlotsForMarks || slots.size() < end / ShareForMarks) {
        std::sort(slots.begin(), slots.end());
        for (const std::uint32_t slot : slots)
            append(ranges, slot);
        return ranges;
    }
    SlotMarks marks;
    marks.resize(end);
    for (const std::uint32_t slot : slots)
        marks.set(slot);
    marks.forEachSet([&](std::size_t slot) { append(ranges, std::uint32_t(slot)); });
    return ranges;
}

} // namespace

std::size_t Edit::byteSize() const
{
    return sizeof(Edit) + bytesOf(mPoints) + bytesOf(mHeights) + bytesOf(mLinks) + bytesOf(mTriangles) +
           bytesOf(mRecords) + bytesOf(mTail.points) + bytesOf(mTail.heights) + bytesOf(mTail.thicknesses) +
           bytesOf(mTail.humidities) + bytesOf(mColumns.vertices) + bytesOf(mColumns.thicknesses) +
           bytesOf(mColumns.humidities) +
           (mAllColumns ? mAllColumns->thicknesses.byteSize() + mAllColumns->humidities.byteSize() : 0) +
           bytesOf(mTail.links) + bytesOf(mTail.triangles) + bytesOf(mTail.records);
}

bool Edit::isEmpty() const
{
    return mPoints.empty() && mHeights.empty() && mLinks.empty() && mTriangles.empty() && mRecords.empty() &&
           mColumns.vertices.empty() && !mChangesLayers && mBefore == mAfter;
}

bool Edit::isValuesOnly() const
{
    return mPoints.empty() && mLinks.empty() && mTriangles.empty() && mRecords.empty() && !mChangesLayers &&
           mBefore == mAfter;
}

std::vector<SlotRange> Edit::dirtyRanges(TinPart part) const
{
    const bool isTriangles = part == TinPart::Triangles;
    std::vector<std::uint32_t> slots;
    const auto collect = [&](const auto &saved) {
        slots.reserve(saved.size());
        for (const auto &entry : saved)
            slots.push_back(entry.slot);
    };
    if (part == TinPart::Layers && mAllColumns)
        return mAfter.vertices ? std::vector<SlotRange>{{0, mAfter.vertices}} : std::vector<SlotRange>{};
    switch (part) {
    case TinPart::Points:
        collect(mPoints);
        break;
    case TinPart::Heights:
        collect(mHeights);
        break;
    case TinPart::Triangles:
        collect(mTriangles);
        break;
    case TinPart::Layers:
        slots = mColumns.vertices;
        break;
    }
    std::vector<SlotRange> ranges = rangesOf(std::move(slots), isTriangles ? mBefore.triangles : mBefore.vertices);
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
    mSeenColumns.resize(tin.layerCount() ? mBase.vertices : 0);
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
    const auto clear = [](SlotMarks &bits, const auto &saved) {
        for (const auto &entry : saved)
            bits.clear(entry.slot);
    };
    clear(mSeenPoints, mEdit.mPoints);
    clear(mSeenHeights, mEdit.mHeights);
    for (const VertexId v : mEdit.mColumns.vertices)
        mSeenColumns.clear(v);
    mEdit.mChangesLayers = !(mEdit.mTotals.layers == tin.totals.layers);
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

void Journal::saveColumn(const TinArrays &tin, VertexId v)
{
    Edit::Columns &columns = mEdit.mColumns;
    columns.vertices.push_back(v);
    const std::size_t from = tin.layerSlot(v, 0), to = tin.layerSlot(v + 1, 0);
    columns.thicknesses.insert(columns.thicknesses.end(), tin.thicknesses.data() + from, tin.thicknesses.data() + to);
    columns.humidities.insert(columns.humidities.end(), tin.humidities.data() + from, tin.humidities.data() + to);
}

void Journal::touchAllColumns(const TinArrays &tin)
{
    if (mEdit.mAllColumns)
        return;
    // As they were before the edit: with what it saved put back, and without what it added.
    Edit::AllColumns all{tin.thicknesses, tin.humidities};
    const std::uint32_t count = tin.layerCount();
    all.thicknesses.resize(std::size_t(mBase.vertices) * count);
    all.humidities.resize(std::size_t(mBase.vertices) * count);
    Edit::Columns &columns = mEdit.mColumns;
    for (std::size_t i = 0; i < columns.vertices.size(); ++i) {
        std::copy_n(columns.thicknesses.data() + i * count, count,
                    all.thicknesses.data() + tin.layerSlot(columns.vertices[i], 0));
        std::copy_n(columns.humidities.data() + i * count, count,
                    all.humidities.data() + tin.layerSlot(columns.vertices[i], 0));
        mSeenColumns.clear(columns.vertices[i]);
    }
    columns = {};
    mEdit.mAllColumns = std::move(all);
}

void Journal::swapColumns(TinArrays &tin, Edit &edit)
{
    if (edit.mAllColumns) {
        std::swap(edit.mAllColumns->thicknesses, tin.thicknesses);
        std::swap(edit.mAllColumns->humidities, tin.humidities);
        return;
    }
    const std::uint32_t count = tin.layerCount();
    for (std::size_t i = 0; i < edit.mColumns.vertices.size(); ++i) {
        const std::size_t at = tin.layerSlot(edit.mColumns.vertices[i], 0);
        std::swap_ranges(tin.thicknesses.data() + at, tin.thicknesses.data() + at + count,
                         edit.mColumns.thicknesses.data() + i * count);
        std::swap_ranges(tin.humidities.data() + at, tin.humidities.data() + at + count,
                         edit.mColumns.humidities.data() + i * count);
    }
}

void Journal::swap(TinArrays &tin, Edit &edit)
{
    [[maybe_unused]] const Edit::Slots &side = edit.mIsUndone ? edit.mBefore : edit.mAfter;
    assert(tin.vertexSlots() == side.vertices && tin.triangleSlots() == side.triangles &&
           tin.records.size() == side.records && "the TIN is on neither side of the edit");
    // The number of layers first: what follows resizes columns by it.
    std::swap(edit.mTotals, tin.totals);
    swapColumns(tin, edit);
    if (!edit.mIsUndone)
        takeTail(tin, edit);
    swapSlots(edit.mPoints, tin.points);
    swapSlots(edit.mHeights, tin.heights);
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
    moveTail(tin.records, edit.mBefore.records, tail.records);
    if (!edit.mAllColumns) {
        moveTail(tin.thicknesses, tin.layerSlot(edit.mBefore.vertices, 0), tail.thicknesses);
        moveTail(tin.humidities, tin.layerSlot(edit.mBefore.vertices, 0), tail.humidities);
    }
    tin.resizeVertices(edit.mBefore.vertices);
    tin.resizeTriangles(edit.mBefore.triangles);
}

void Journal::giveTail(TinArrays &tin, Edit &edit)
{
    Edit::Tail &tail = edit.mTail;
    appendTail(tin.points, tail.points);
    appendTail(tin.heights, tail.heights);
    appendTail(tin.records, tail.records);
    appendTail(tin.thicknesses, tail.thicknesses);
    appendTail(tin.humidities, tail.humidities);
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
    return mSeenPoints.byteSize() + mSeenColumns.byteSize() + mSeenHeights.byteSize() + mSeenLinks.byteSize() +
           mSeenTriangles.byteSize() + mSeenRecords.byteSize() + mReconnected.byteSize();
}

} // namespace model::terrain
