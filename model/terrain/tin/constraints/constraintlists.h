// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tinwriter.h"

namespace model::terrain {

/// The record after `r` in the list of `v`.
inline std::uint32_t nextRecord(const TinArrays &tin, std::uint32_t r, VertexId v)
{
    return tin.records[r].a == v ? tin.records[r].nextOfA : tin.records[r].nextOfB;
}

/// Calls `visit(record number)` for each constraint of the edge a-b. `visit` may remove that record.
template <class Visit>
void forEachRecord(const TinArrays &tin, VertexId a, VertexId b, Visit visit)
{
    for (std::uint32_t r = tin.constraints[a], after; r != None; r = after) {
        after = nextRecord(tin, r, a);
        if (tin.records[r].a == b || tin.records[r].b == b)
            visit(r);
    }
}

/// The record of `owner` on the edge a-b, or None.
std::uint32_t findRecord(const TinArrays &tin, VertexId a, VertexId b, OwnerId owner);
bool hasRecord(const TinArrays &tin, VertexId a, VertexId b);
/// The owners of the edge a-b, in the order of its list.
std::vector<OwnerId> ownersOf(const TinArrays &tin, VertexId a, VertexId b);

// These keep the records alone; the constrained bits of the triangles are the caller's.

/// Adds the record, unless it is there.
void addRecord(TinWriter &writer, VertexId a, VertexId b, OwnerId owner);
void removeRecord(TinWriter &writer, std::uint32_t r);
/// Where `v` was put onto the edge a-b: gives its records to a-v and v-b.
void splitRecords(TinWriter &writer, VertexId a, VertexId b, VertexId v);

} // namespace model::terrain
