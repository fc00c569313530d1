// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/build/restoretin.h"

#include "model/base/parallel.h"
#include "model/terrain/tin/constraints/constraintlists.h"
#include "model/terrain/tin/predicates.h"
#include "model/terrain/tin/validate.h"

#include <atomic>
#include <cmath>

namespace model::terrain {

namespace {

constexpr std::size_t Grain = 1 << 14;
/// Areas of a domain with shorter sides would underflow.
constexpr double SmallestExtent = 1e-100;

/// The first broken rule that any thread finds.
class Finding
{
public:
    void report(TinRule rule, std::uint32_t id)
    {
        std::uint64_t none = None;
        mFirst.compare_exchange_strong(none, std::uint64_t(rule) << 32 | id);
    }
    bool isEmpty() const { return mFirst == None; }
    tl::unexpected<Error> failure() const
    {
        return fail(ErrorCode::BrokenTerrain, nameOf(TinRule(mFirst >> 32)), std::to_string(std::uint32_t(mFirst)));
    }

private:
    std::atomic<std::uint64_t> mFirst = None;
};

void inspectSizes(const TinArrays &tin, const Rectangle &domain, Finding &finding)
{
    const std::size_t v = tin.points.size(), t = tin.triangleFlags.size();
    if (v < 4 || t < 2 || tin.heights.size() != v || tin.triangleVertices.size() != 3 * t ||
        tin.opposites.size() != 3 * t || v > (std::size_t(1) << 28) || t > (std::size_t(1) << 29))
        return finding.report(TinRule::FreeList, 0);
    const std::uint32_t layers = tin.layerCount();
    if (layers > MaxLayers || tin.thicknesses.size() != v * layers || tin.humidities.size() != v * layers)
        return finding.report(TinRule::Layers, 0);
    const Point2 corners[] = {domain.low, {domain.high.x, domain.low.y}, domain.high, {domain.low.x, domain.high.y}};
    if (!(domain.high.x - domain.low.x >= SmallestExtent && domain.high.y - domain.low.y >= SmallestExtent))
        return finding.report(TinRule::Border, 0);
    for (VertexId i = 0; i < 4; ++i)
        if (tin.points[i] != corners[i])
            return finding.report(TinRule::Border, i);
}

void inspectTriangles(const TinArrays &tin, const Rectangle &domain, Finding &finding,
                      std::atomic<std::uint32_t> &borderEdges)
{
    const std::uint32_t vertices = std::uint32_t(tin.points.size()), triangles = tin.triangleSlots();
    parallelRanges(vertices, Grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const Point2 p = tin.points[v];
            if (!domain.contains(p) || std::abs(p.x) > LargestCoordinate || std::abs(p.y) > LargestCoordinate)
                finding.report(TinRule::Border, std::uint32_t(v));
            if (!std::isfinite(tin.heights[v]))
                finding.report(TinRule::Height, std::uint32_t(v));
            for (std::uint32_t l = 0; l < tin.layerCount(); ++l) {
                const LayerSample sample = tin.sample(VertexId(v), l);
                if (!(sample.thickness >= 0) || !std::isfinite(sample.thickness))
                    finding.report(TinRule::Thickness, std::uint32_t(v));
                if (!(sample.humidity >= 0 && sample.humidity <= 1))
                    finding.report(TinRule::Humidity, std::uint32_t(v));
            }
        }
    });
    if (!finding.isEmpty())
        return;
    parallelRanges(triangles, Grain, [&](std::size_t begin, std::size_t end) {
        std::uint32_t atBorder = 0;
        for (TriangleId t = TriangleId(begin); t < end; ++t) {
            const VertexId *const v = tin.triangleVertices.data() + 3 * std::size_t(t);
            if (v[0] >= vertices || v[1] >= vertices || v[2] >= vertices) {
                finding.report(TinRule::VertexCorner, t);
                continue;
            }
            if (tin.triangleFlags[t] & ~VoidTriangle)
                finding.report(TinRule::FreeList, t);
            if (orientation(tin.points[v[0]], tin.points[v[1]], tin.points[v[2]]) <= 0)
                finding.report(TinRule::Orientation, t);
            for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
                const Corner o = tin.opposite(c);
                if (o == NoCorner) {
                    ++atBorder;
                    continue;
                }
                if ((o & 3) == 3 || triangleOf(o) >= triangles || triangleOf(o) == t || tin.opposite(o) != c ||
                    tin.vertex(next(c)) != tin.vertex(previous(o)) || tin.vertex(previous(c)) != tin.vertex(next(o)))
                    finding.report(TinRule::Links, t);
            }
        }
        borderEdges += atBorder;
    });
}

/// The border runs along the domain, once around.
void inspectBorder(const TinArrays &tin, const Rectangle &domain, Finding &finding)
{
    double length = 0;
    for (TriangleId t = 0; t < tin.triangleSlots(); ++t)
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
            if (tin.opposite(c) != NoCorner)
                continue;
            const Point2 a = tin.pointAt(next(c)), b = tin.pointAt(previous(c));
            const bool south = a.y == domain.low.y && b.y == domain.low.y && a.x < b.x;
            const bool east = a.x == domain.high.x && b.x == domain.high.x && a.y < b.y;
            const bool north = a.y == domain.high.y && b.y == domain.high.y && a.x > b.x;
            const bool west = a.x == domain.low.x && b.x == domain.low.x && a.y > b.y;
            if (!south && !east && !north && !west)
                return finding.report(TinRule::Border, t);
            length += std::abs(b.x - a.x) + std::abs(b.y - a.y);
        }
    const double around = 2 * (domain.high.x - domain.low.x + domain.high.y - domain.low.y);
    if (!(std::abs(length - around) <= 1e-9 * around))
        finding.report(TinRule::Border, 0);
}

/// Sets a corner for each vertex; checks that its triangles are one fan.
void setCorners(TinArrays &tin, Finding &finding)
{
    std::vector<std::uint32_t> cornersOf(tin.points.size());
    for (std::size_t v = 0; v < tin.points.size(); ++v)
        tin.corners[v] = NoCorner;
    for (TriangleId t = 0; t < tin.triangleSlots(); ++t)
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
            const VertexId v = tin.vertex(c);
            ++cornersOf[v];
            if (tin.corners[v] == NoCorner)
                tin.corners[v] = c;
        }
    parallelRanges(cornersOf.size(), Grain, [&](std::size_t begin, std::size_t end) {
        for (VertexId v = VertexId(begin); v < end; ++v) {
            if (tin.corners[v] == NoCorner) {
                finding.report(TinRule::VertexCorner, v);
                continue;
            }
            std::uint32_t around = 0;
            forEachCornerAround(tin, v, [&](Corner) { ++around; });
            if (around != cornersOf[v])
                finding.report(TinRule::VertexCorner, v);
        }
    });
}

void inspectCircles(const TinArrays &tin, Finding &finding)
{
    parallelRanges(tin.triangleSlots(), Grain, [&](std::size_t begin, std::size_t end) {
        for (TriangleId t = TriangleId(begin); t < end; ++t)
            for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
                const Corner o = tin.opposite(c);
                if (c < o && o != NoCorner && !tin.isConstrained(c) &&
                    isInsideCircle(tin.pointAt(c), tin.pointAt(next(c)), tin.pointAt(previous(c)), tin.pointAt(o)))
                    finding.report(TinRule::EmptyCircle, t);
            }
    });
}

} // namespace

struct TinRestorer
{
    static Result<Tin> restore(TinArrays arrays, const Rectangle &domain, std::span<const ConstrainedEdge> constraints,
                               LedgerStart start)
    {
        Finding finding;
        inspectSizes(arrays, domain, finding);
        if (!finding.isEmpty())
            return finding.failure();
        const std::size_t vertices = arrays.points.size();
        arrays.resizeVertices(vertices);
        arrays.records = {};
        arrays.totals.records = 0;
        arrays.totals.freeVertex = NoFreeVertex;
        arrays.totals.freeTriangle = arrays.totals.freeRecord = None;
        arrays.totals.vertices = std::uint32_t(vertices);
        arrays.totals.triangles = arrays.triangleSlots();
        for (std::size_t v = 0; v < vertices; ++v)
            arrays.constraints[v] = None;
        for (std::size_t i = 0; i < arrays.opposites.size(); ++i)
            arrays.opposites[i] = (arrays.opposites[i] & ~ConstrainedBit) == NoCorner
                                      ? BorderOpposite
                                      : arrays.opposites[i] & ~ConstrainedBit;

        std::atomic<std::uint32_t> borderEdges = 0;
        inspectTriangles(arrays, domain, finding, borderEdges);
        if (!finding.isEmpty())
            return finding.failure();
        inspectBorder(arrays, domain, finding);
        if (std::uint64_t(arrays.totals.triangles) + borderEdges + 2 != 2 * std::uint64_t(vertices))
            finding.report(TinRule::Euler, arrays.totals.vertices);
        setCorners(arrays, finding);
        if (!finding.isEmpty())
            return finding.failure();
        addConstraints(arrays, constraints, finding);
        inspectCircles(arrays, finding);
        if (!finding.isEmpty())
            return finding.failure();

        Tin tin{domain};
        tin.mArrays = std::move(arrays);
        if (start == LedgerStart::Anew) {
            tin.mArrays.totals.ledger = {};
            tin.mArrays.totals.ledger.start = tin.volume();
        }
        tin.mHints.build(tin.mArrays, domain);
        return tin;
    }

    static void addConstraints(TinArrays &tin, std::span<const ConstrainedEdge> constraints, Finding &finding)
    {
        Journal journal;
        TinWriter writer(tin, journal);
        const auto constrain = [&](Corner c, OwnerId owner) {
            writer.setConstrained(c, true);
            addRecord(writer, tin.vertex(next(c)), tin.vertex(previous(c)), owner);
        };
        for (const ConstrainedEdge &edge : constraints) {
            if (edge.owner == VoidOwner)
                continue;
            const bool isUsable = edge.a < tin.points.size() && edge.b < tin.points.size() && edge.owner != None;
            const Corner c = isUsable ? cornerOfEdge(tin, edge.a, edge.b) : NoCorner;
            if (c == NoCorner) {
                finding.report(TinRule::Constraint, edge.a);
                continue;
            }
            // An edge of the border is constrained as it is; its record says by whom else.
            if (tin.opposite(c) == NoCorner)
                addRecord(writer, edge.a, edge.b, edge.owner);
            else
                constrain(c, edge.owner);
        }
        for (TriangleId t = 0; t < tin.triangleSlots(); ++t) {
            if (!tin.isVoid(t))
                continue;
            for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c)
                if (const Corner o = tin.opposite(c); o != NoCorner && !tin.isVoid(triangleOf(o)))
                    constrain(c, VoidOwner);
        }
    }
};

Result<Tin> restoreTin(TinArrays arrays, const Rectangle &domain, std::span<const ConstrainedEdge> constraints,
                       LedgerStart start)
{
    return TinRestorer::restore(std::move(arrays), domain, constraints, start);
}

std::vector<ConstrainedEdge> constrainedEdges(const TinArrays &tin)
{
    std::vector<ConstrainedEdge> edges;
    for (const ConstraintRecord &record : tin.records.values())
        if (record.a != None && record.owner != VoidOwner)
            edges.push_back({record.a, record.b, record.owner});
    return edges;
}

} // namespace model::terrain
