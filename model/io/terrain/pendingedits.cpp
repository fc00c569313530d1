// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/pendingedits.h"

#include <algorithm>
#include <tuple>

namespace model::io {

using namespace terrain;

bool PendingEdits::LineOrder::operator()(const Line &a, const Line &b) const
{
    const auto key = [](const Line &line) {
        const std::pair p(line.a.x, line.a.y), q(line.b.x, line.b.y);
        return std::tuple(std::min(p, q), std::max(p, q), line.owner);
    };
    return key(a) < key(b);
}

void PendingEdits::add(const Edit &edit, const TinArrays &tin)
{
    if (mNeedsSnapshot || edit.isEmpty())
        return;
    mMarks.resize(tin.vertexSlots());
    if (addValues(edit, tin))
        return;
    const EditChanges changes = changesOf(edit, tin);
    mNeedsSnapshot = changes.changesLayers;
    for (const VertexId v : changes.present)
        if (mMarks.set(v))
            mVertices.push_back(v);
    mRemoved.insert(mRemoved.end(), changes.removed.begin(), changes.removed.end());
    for (const Line &line : changes.released)
        mLines.insert_or_assign(line, false);
    for (const Line &line : changes.constrained)
        mLines.insert_or_assign(line, true);
}

/// Heights and layers alone, as when sand slides: there is nothing to find out about vertices and constraints, which
/// takes ten times as long. \returns false if the edit did something else, too
bool PendingEdits::addValues(const Edit &edit, const TinArrays &tin)
{
    if (!edit.isValuesOnly())
        return false;
    const std::vector<SlotRange> layers = edit.dirtyRanges(TinPart::Layers);
    if (layers.size() == 1 && layers[0].count == tin.vertexSlots())
        return false; // perhaps another number of them
    for (const std::vector<SlotRange> &ranges : {edit.dirtyRanges(TinPart::Heights), layers})
        for (const SlotRange range : ranges)
            for (VertexId v = range.first; v < range.first + range.count; ++v)
                if (mMarks.set(v))
                    mVertices.push_back(v);
    return true;
}

JournalFrame PendingEdits::take(const TinArrays &tin)
{
    EditChanges changes;
    changes.removed = std::move(mRemoved);
    // A slot that is free now, or another vertex': the vertex that it was is among the removed. Those that are said to
    // be removed and present are present: that is read later.
    for (const VertexId v : mVertices)
        if (tin.isVertex(v))
            changes.present.push_back(v);
    for (const auto &[line, isThere] : mLines)
        (isThere ? changes.constrained : changes.released).push_back(line);
    clear();
    return frameOfChanges(changes, tin);
}

void PendingEdits::clear()
{
    for (const VertexId v : mVertices)
        mMarks.clear(v);
    mVertices.clear();
    mRemoved.clear();
    mLines.clear();
    mNeedsSnapshot = false;
}

} // namespace model::io
