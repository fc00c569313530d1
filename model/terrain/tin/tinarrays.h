// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/flatarray.h"
#include "model/terrain/tin/ids.h"
#include "model/terrain/tin/layers.h"
#include "model/terrain/tin/ledger.h"

namespace model::terrain {

/// The edge a-b, a < b, is constrained by `owner`. Each record hangs in the lists of both its vertices.
struct ConstraintRecord
{
    VertexId a = None; ///< None: the record is free
    VertexId b = None;
    OwnerId owner = None;
    std::uint32_t nextOfA = None; ///< the next record in a's list; of a free record, the next free one
    std::uint32_t nextOfB = None;

    friend constexpr bool operator==(const ConstraintRecord &, const ConstraintRecord &) = default;
};

/// What a slot of TinArrays::opposites holds: the corner across the edge, and in the top bit whether it is constrained.
inline constexpr Corner ConstrainedBit = 0x80000000;
inline constexpr Corner BorderOpposite = NoCorner | ConstrainedBit;

/// Bits of TinArrays::triangleFlags.
enum TriangleFlag : std::uint8_t { VoidTriangle = 1, FreeTriangle = 2 };

/// A free vertex has this bit in its corner, and below it the next free vertex (31 bits; all set: none).
inline constexpr Corner FreeVertexBit = 0x80000000;
inline constexpr std::uint32_t NoFreeVertex = 0x7fffffff;

/// Everything that belongs to the state of a TIN but is no array.
struct TinTotals
{
    std::uint32_t vertices = 0;  ///< in use
    std::uint32_t triangles = 0; ///< in use, void ones too
    std::uint32_t records = 0;   ///< in use
    std::uint32_t freeVertex = NoFreeVertex;
    std::uint32_t freeTriangle = None;
    std::uint32_t freeRecord = None;
    LayerTable layers;
    Ledger ledger;
    /// By how much tools pressed each layer together, in cubic metres: its volume and this make up its mass.
    CompensatedSum compacted[MaxLayers];
};
static_assert(sizeof(TinTotals) == 40 + sizeof(Ledger) + sizeof(TinTotals::compacted), "digests read every byte");

/// The memory of a TIN. Ids are slots of these arrays; a slot that is free keeps its id for the next one.
struct TinArrays
{
    // For each vertex.
    FlatArray<Point2> points;
    FlatArray<double> heights;
    FlatArray<Corner> corners;            ///< one corner at the vertex
    FlatArray<std::uint32_t> constraints; ///< its first constraint record
    // For each vertex and layer: layerCount() values of a vertex side by side, from the bedrock up. Empty without
    // layers.
    FlatArray<double> thicknesses; ///< metres, at least 0
    FlatArray<float> humidities;   ///< 0 ... 1
    // For each triangle, three at a time; a free triangle has vertices 0, 0, 0 and its first opposite is the next free
    // one.
    FlatArray<VertexId> triangleVertices;
    FlatArray<Corner> opposites;
    FlatArray<std::uint8_t> triangleFlags;

    FlatArray<ConstraintRecord> records;
    TinTotals totals;

    std::uint32_t vertexSlots() const { return std::uint32_t(corners.size()); }
    std::uint32_t triangleSlots() const { return std::uint32_t(triangleFlags.size()); }

    std::uint32_t layerCount() const { return totals.layers.count; }
    /// Where the values of a layer at a vertex lie in `thicknesses` and `humidities`.
    std::size_t layerSlot(VertexId v, std::uint32_t layer) const { return std::size_t(v) * layerCount() + layer; }
    LayerSample sample(VertexId v, std::uint32_t layer) const
    {
        return {thicknesses[layerSlot(v, layer)], humidities[layerSlot(v, layer)]};
    }
    /// What lies on the bedrock at `v`: the thickness of all its layers.
    double cover(VertexId v) const
    {
        double sum = 0;
        for (std::uint32_t l = 0; l < layerCount(); ++l)
            sum += thicknesses[layerSlot(v, l)];
        return sum;
    }
    /// The height of what never moves. Without layers that is the surface.
    double bedrock(VertexId v) const { return heights[v] - cover(v); }

    bool isVertex(VertexId v) const { return v < corners.size() && !(corners[v] & FreeVertexBit); }
    bool isTriangle(TriangleId t) const { return t < triangleFlags.size() && !(triangleFlags[t] & FreeTriangle); }
    bool isVoid(TriangleId t) const { return triangleFlags[t] & VoidTriangle; }

    VertexId vertex(Corner c) const { return triangleVertices[slotOf(c)]; }
    /// NoCorner at the border.
    Corner opposite(Corner c) const { return opposites[slotOf(c)] & ~ConstrainedBit; }
    bool isConstrained(Corner c) const { return opposites[slotOf(c)] & ConstrainedBit; }
    Point2 pointAt(Corner c) const { return points[vertex(c)]; }

    /// The corner of the same vertex in the next triangle around it; NoCorner beyond the border.
    Corner counterClockwise(Corner c) const
    {
        const Corner o = opposite(next(c));
        return o == NoCorner ? NoCorner : next(o);
    }
    Corner clockwise(Corner c) const
    {
        const Corner o = opposite(previous(c));
        return o == NoCorner ? NoCorner : previous(o);
    }
    /// The first corner at `v` counter-clockwise: at the border where its fan begins, inside any.
    Corner firstAround(VertexId v) const
    {
        const Corner start = corners[v];
        Corner c = start;
        for (Corner before = clockwise(c); before != NoCorner && before != start; before = clockwise(c))
            c = before;
        return clockwise(c) == NoCorner ? c : start;
    }

    void resizeVertices(std::size_t count)
    {
        points.resize(count);
        heights.resize(count);
        corners.resize(count);
        constraints.resize(count);
        thicknesses.resize(count * layerCount());
        humidities.resize(count * layerCount());
    }
    void resizeTriangles(std::size_t count)
    {
        triangleVertices.resize(3 * count);
        opposites.resize(3 * count);
        triangleFlags.resize(count);
    }
    void reserve(std::size_t vertices, std::size_t triangles)
    {
        points.reserve(vertices);
        heights.reserve(vertices);
        corners.reserve(vertices);
        constraints.reserve(vertices);
        triangleVertices.reserve(3 * triangles);
        opposites.reserve(3 * triangles);
        triangleFlags.reserve(triangles);
    }
    std::size_t byteSize() const
    {
        return points.byteSize() + heights.byteSize() + corners.byteSize() + constraints.byteSize() +
               thicknesses.byteSize() + humidities.byteSize() + triangleVertices.byteSize() + opposites.byteSize() +
               triangleFlags.byteSize() + records.byteSize();
    }
};

/// Says that this will be read soon.
inline void prefetch([[maybe_unused]] const void *address)
{
#if defined(__GNUC__)
    __builtin_prefetch(address);
#endif
}

/// Calls `visit(corner)` for each corner at `v`: counter-clockwise from its own, and at the border clockwise for the
/// rest.
template <class Visit>
void forEachCornerAround(const TinArrays &tin, VertexId v, Visit visit)
{
    const Corner start = tin.corners[v];
    Corner c = start;
    do {
        visit(c);
        c = tin.counterClockwise(c);
        if (c == start)
            return;
    } while (c != NoCorner);
    for (c = tin.clockwise(start); c != NoCorner; c = tin.clockwise(c))
        visit(c);
}

/// The corner whose edge is a-b, in the triangle on the left of a to b if there is one; NoCorner if a-b is no edge.
Corner cornerOfEdge(const TinArrays &tin, VertexId a, VertexId b);

} // namespace model::terrain
