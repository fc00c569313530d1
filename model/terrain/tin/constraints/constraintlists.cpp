// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/constraints/constraintlists.h"

#include <algorithm>
#include <cassert>

namespace model::terrain {

namespace {

void setNext(TinArrays &tin, std::uint32_t r, VertexId v, std::uint32_t after)
{
    (tin.records[r].a == v ? tin.records[r].nextOfA : tin.records[r].nextOfB) = after;
}

void unhang(TinWriter &writer, std::uint32_t r, VertexId v)
{
    TinArrays &tin = writer.tin;
    const std::uint32_t after = nextRecord(tin, r, v);
    if (tin.constraints[v] == r) {
        writer.touchLinks(v);
        tin.constraints[v] = after;
        return;
    }
    std::uint32_t before = tin.constraints[v];
    while (nextRecord(tin, before, v) != r)
        before = nextRecord(tin, before, v);
    writer.touchRecord(before);
    setNext(tin, before, v, after);
}

} // namespace

std::uint32_t findRecord(const TinArrays &tin, VertexId a, VertexId b, OwnerId owner)
{
    std::uint32_t found = None;
    forEachRecord(tin, a, b, [&](std::uint32_t r) {
        if (tin.records[r].owner == owner)
            found = r;
    });
    return found;
}

bool hasRecord(const TinArrays &tin, VertexId a, VertexId b)
{
    bool isThere = false;
    forEachRecord(tin, a, b, [&](std::uint32_t) { isThere = true; });
    return isThere;
}

std::vector<OwnerId> ownersOf(const TinArrays &tin, VertexId a, VertexId b)
{
    std::vector<OwnerId> owners;
    forEachRecord(tin, a, b, [&](std::uint32_t r) { owners.push_back(tin.records[r].owner); });
    return owners;
}

void addRecord(TinWriter &writer, VertexId a, VertexId b, OwnerId owner)
{
    TinArrays &tin = writer.tin;
    if (findRecord(tin, a, b, owner) != None)
        return;
    std::uint32_t r = tin.totals.freeRecord;
    if (r != None) {
        writer.touchRecord(r);
        tin.totals.freeRecord = tin.records[r].nextOfA;
    } else {
        r = std::uint32_t(tin.records.size());
        tin.records.resize(r + std::size_t(1));
    }
    if (a > b)
        std::swap(a, b);
    writer.touchLinks(a);
    writer.touchLinks(b);
    tin.records[r] = {a, b, owner, tin.constraints[a], tin.constraints[b]};
    tin.constraints[a] = r;
    tin.constraints[b] = r;
    ++tin.totals.records;
}

void removeRecord(TinWriter &writer, std::uint32_t r)
{
    TinArrays &tin = writer.tin;
    writer.touchRecord(r);
    unhang(writer, r, tin.records[r].a);
    unhang(writer, r, tin.records[r].b);
    tin.records[r] = {};
    tin.records[r].nextOfA = tin.totals.freeRecord;
    tin.totals.freeRecord = r;
    --tin.totals.records;
}

void splitRecords(TinWriter &writer, VertexId a, VertexId b, VertexId v)
{
    forEachRecord(writer.tin, a, b, [&](std::uint32_t r) {
        const OwnerId owner = writer.tin.records[r].owner;
        removeRecord(writer, r);
        addRecord(writer, a, v, owner);
        addRecord(writer, v, b, owner);
    });
}

} // namespace model::terrain
