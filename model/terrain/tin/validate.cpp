// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/validate.h"

#include "model/terrain/tin/constraints/constraintlists.h"
#include "model/terrain/tin/predicates.h"
#include "model/terrain/tin/tinwriter.h"

#include <cmath>

namespace model::terrain {

namespace {

/// Of the length of the border, added up edge by edge: what differs is rounding.
constexpr double LengthTolerance = 1e-9;

class Inspection
{
public:
    Inspection(const TinArrays &tin, const Rectangle &domain, std::size_t limit)
        : mTin(tin)
        , mDomain(domain)
        , mLimit(limit)
    {}

    std::vector<TinDefect> run()
    {
        // What comes later follows links that the earlier ones have found sound.
        inspectSizes();
        if (mDefects.empty())
            inspectFreeLists();
        if (mDefects.empty())
            inspectLinks();
        if (mDefects.empty())
            inspectVertices();
        if (mDefects.empty()) {
            inspectTriangles();
            inspectBorder();
            inspectLayers();
            if (inspectRecords())
                inspectConstraints();
        }
        return std::move(mDefects);
    }

private:
    void report(TinRule rule, std::uint32_t a = None, std::uint32_t b = None, std::uint32_t c = None)
    {
        if (mDefects.size() < mLimit)
            mDefects.push_back({rule, {a, b, c}});
    }

    void inspectSizes()
    {
        const std::size_t v = mTin.corners.size(), t = mTin.triangleFlags.size();
        if (mTin.points.size() != v || mTin.heights.size() != v || mTin.constraints.size() != v ||
            mTin.triangleVertices.size() != 3 * t || mTin.opposites.size() != 3 * t)
            report(TinRule::FreeList);
        const std::uint32_t layers = mTin.layerCount();
        if (layers > MaxLayers || mTin.thicknesses.size() != v * layers || mTin.humidities.size() != v * layers)
            report(TinRule::Layers);
    }

    void inspectFreeLists()
    {
        std::uint32_t used = 0;
        for (VertexId v = 0; v < mTin.vertexSlots(); ++v)
            used += mTin.isVertex(v);
        std::uint32_t left = mTin.vertexSlots() - used;
        VertexId v = mTin.totals.freeVertex;
        for (; v != NoFreeVertex && left > 0; --left) {
            if (v >= mTin.vertexSlots() || mTin.isVertex(v) || mTin.constraints[v] != None)
                return report(TinRule::FreeList, v);
            v = mTin.corners[v] & ~FreeVertexBit;
        }
        if (left > 0 || v != NoFreeVertex || used != mTin.totals.vertices)
            report(TinRule::FreeList, v);

        used = 0;
        for (TriangleId t = 0; t < mTin.triangleSlots(); ++t)
            used += mTin.isTriangle(t);
        left = mTin.triangleSlots() - used;
        TriangleId t = mTin.totals.freeTriangle;
        for (; t != None && left > 0; --left) {
            if (t >= mTin.triangleSlots() || mTin.isTriangle(t))
                return report(TinRule::FreeList, t);
            for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c)
                if (mTin.vertex(c) != 0)
                    return report(TinRule::FreeList, t);
            t = mTin.opposites[slotOf(cornerOf(t, 0))];
        }
        if (left > 0 || t != None || used != mTin.totals.triangles)
            report(TinRule::FreeList, t);

        used = 0;
        for (std::uint32_t r = 0; r < mTin.records.size(); ++r)
            used += mTin.records[r].a != None;
        left = std::uint32_t(mTin.records.size()) - used;
        std::uint32_t r = mTin.totals.freeRecord;
        for (; r != None && left > 0; --left) {
            if (r >= mTin.records.size() || mTin.records[r].a != None)
                return report(TinRule::FreeList, r);
            r = mTin.records[r].nextOfA;
        }
        if (left > 0 || r != None || used != mTin.totals.records)
            report(TinRule::FreeList, r);
    }

    template <class Visit>
    void forEachCorner(Visit visit) const
    {
        for (TriangleId t = 0; t < mTin.triangleSlots(); ++t)
            if (mTin.isTriangle(t))
                for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c)
                    visit(t, c);
    }

    void inspectLinks()
    {
        forEachCorner([&](TriangleId t, Corner c) {
            if (!mTin.isVertex(mTin.vertex(c)))
                return report(TinRule::VertexCorner, t, mTin.vertex(c));
            const Corner o = mTin.opposites[slotOf(c)];
            if (o == BorderOpposite)
                return;
            const Corner back = o & ~ConstrainedBit;
            if ((back & 3) == 3 || !mTin.isTriangle(triangleOf(back)) || triangleOf(back) == t ||
                mTin.opposites[slotOf(back)] != (c | (o & ConstrainedBit)) ||
                mTin.vertex(next(c)) != mTin.vertex(previous(back)) ||
                mTin.vertex(previous(c)) != mTin.vertex(next(back)))
                report(TinRule::Links, t, triangleOf(back));
        });
    }

    void inspectVertices()
    {
        std::vector<std::uint32_t> cornersOf(mTin.vertexSlots());
        forEachCorner([&](TriangleId, Corner c) { ++cornersOf[mTin.vertex(c)]; });
        for (VertexId v = 0; v < mTin.vertexSlots(); ++v) {
            if (!mTin.isVertex(v))
                continue;
            const Corner c = mTin.corners[v];
            if ((c & 3) == 3 || !mTin.isTriangle(triangleOf(c)) || mTin.vertex(c) != v) {
                report(TinRule::VertexCorner, v);
                continue;
            }
            // One fan: two that touch at a point only would leave corners over.
            std::uint32_t around = 0;
            forEachCornerAround(mTin, v, [&](Corner) { ++around; });
            if (around != cornersOf[v])
                report(TinRule::VertexCorner, v);
            if (!std::isfinite(mTin.heights[v]))
                report(TinRule::Height, v);
        }
    }

    void inspectTriangles()
    {
        for (TriangleId t = 0; t < mTin.triangleSlots(); ++t)
            if (mTin.isTriangle(t) && orientation(mTin.pointAt(cornerOf(t, 0)), mTin.pointAt(cornerOf(t, 1)),
                                                  mTin.pointAt(cornerOf(t, 2))) <= 0)
                report(TinRule::Orientation, t);
        if (!mDefects.empty())
            return;
        forEachCorner([&](TriangleId t, Corner c) {
            const Corner o = mTin.opposite(c);
            if (c < o && !mTin.isConstrained(c) &&
                isInsideCircle(mTin.pointAt(c), mTin.pointAt(next(c)), mTin.pointAt(previous(c)), mTin.pointAt(o)))
                report(TinRule::EmptyCircle, t, triangleOf(o));
        });
    }

    void inspectBorder()
    {
        std::uint32_t borderEdges = 0;
        double length = 0;
        bool hasCorner[4] = {};
        forEachCorner([&](TriangleId t, Corner c) {
            if (mTin.opposite(c) != NoCorner)
                return;
            ++borderEdges;
            const Point2 a = mTin.pointAt(next(c)), b = mTin.pointAt(previous(c));
            // With the terrain on the left: along the south to the east, and so on around.
            const bool south = a.y == mDomain.low.y && b.y == mDomain.low.y && a.x < b.x;
            const bool east = a.x == mDomain.high.x && b.x == mDomain.high.x && a.y < b.y;
            const bool north = a.y == mDomain.high.y && b.y == mDomain.high.y && a.x > b.x;
            const bool west = a.x == mDomain.low.x && b.x == mDomain.low.x && a.y > b.y;
            if (!south && !east && !north && !west)
                report(TinRule::Border, t, mTin.vertex(next(c)), mTin.vertex(previous(c)));
            length += std::abs(b.x - a.x) + std::abs(b.y - a.y);
            hasCorner[0] |= a == mDomain.low;
            hasCorner[1] |= a == Point2{mDomain.high.x, mDomain.low.y};
            hasCorner[2] |= a == mDomain.high;
            hasCorner[3] |= a == Point2{mDomain.low.x, mDomain.high.y};
        });
        const double around = 2 * (mDomain.high.x - mDomain.low.x + mDomain.high.y - mDomain.low.y);
        if (std::abs(length - around) > LengthTolerance * around || !hasCorner[0] || !hasCorner[1] || !hasCorner[2] ||
            !hasCorner[3])
            report(TinRule::Border);
        if (std::uint64_t(mTin.totals.triangles) + borderEdges + 2 != 2 * std::uint64_t(mTin.totals.vertices))
            report(TinRule::Euler, mTin.totals.vertices, mTin.totals.triangles, borderEdges);
    }

    /// False if the lists cannot be followed.
    bool inspectRecords()
    {
        std::uint32_t hanging = 0;
        for (VertexId v = 0; v < mTin.vertexSlots(); ++v) {
            if (!mTin.isVertex(v))
                continue;
            for (std::uint32_t r = mTin.constraints[v]; r != None; r = nextRecord(mTin, r, v)) {
                if (r >= mTin.records.size() || (mTin.records[r].a != v && mTin.records[r].b != v) ||
                    ++hanging > 2 * mTin.totals.records) {
                    report(TinRule::RecordList, v, r);
                    return false;
                }
            }
        }
        if (hanging != 2 * mTin.totals.records)
            report(TinRule::RecordList);
        return hanging == 2 * mTin.totals.records;
    }

    void inspectConstraints()
    {
        for (std::uint32_t r = 0; r < mTin.records.size(); ++r) {
            const ConstraintRecord &record = mTin.records[r];
            if (record.a == None)
                continue;
            if (record.a >= record.b || !mTin.isVertex(record.a) || !mTin.isVertex(record.b)) {
                report(TinRule::RecordList, r);
                continue;
            }
            const Corner c = cornerOfEdge(mTin, record.a, record.b);
            if (c == NoCorner || !mTin.isConstrained(c) || findRecord(mTin, record.a, record.b, record.owner) != r)
                report(TinRule::Constraint, record.a, record.b, record.owner);
        }
        forEachCorner([&](TriangleId t, Corner c) {
            const Corner o = mTin.opposite(c);
            if (o == NoCorner || o < c)
                return;
            const VertexId a = mTin.vertex(next(c)), b = mTin.vertex(previous(c));
            if (mTin.isConstrained(c) != hasRecord(mTin, a, b))
                report(TinRule::Constraint, a, b);
            const bool bounds = mTin.isVoid(t) != mTin.isVoid(triangleOf(o));
            if (bounds != (findRecord(mTin, a, b, VoidOwner) != None))
                report(TinRule::VoidBorder, a, b);
        });
    }

    void inspectLayers()
    {
        for (VertexId v = 0; v < mTin.vertexSlots(); ++v) {
            if (!mTin.isVertex(v))
                continue;
            for (std::uint32_t l = 0; l < mTin.layerCount(); ++l) {
                const LayerSample sample = mTin.sample(v, l);
                if (!(sample.thickness >= 0) || !std::isfinite(sample.thickness))
                    report(TinRule::Thickness, v, l);
                if (!(sample.humidity >= 0 && sample.humidity <= 1))
                    report(TinRule::Humidity, v, l);
            }
        }
    }

    const TinArrays &mTin;
    const Rectangle mDomain;
    const std::size_t mLimit;
    std::vector<TinDefect> mDefects;
};

} // namespace

const char *nameOf(TinRule rule)
{
    switch (rule) {
    case TinRule::Links:
        return "links";
    case TinRule::Orientation:
        return "orientation";
    case TinRule::VertexCorner:
        return "vertex corner";
    case TinRule::EmptyCircle:
        return "empty circle";
    case TinRule::Border:
        return "border";
    case TinRule::Euler:
        return "Euler";
    case TinRule::Constraint:
        return "constraint";
    case TinRule::RecordList:
        return "record list";
    case TinRule::VoidBorder:
        return "void border";
    case TinRule::FreeList:
        return "free list";
    case TinRule::Height:
        return "height";
    case TinRule::Layers:
        return "layers";
    case TinRule::Thickness:
        return "thickness";
    case TinRule::Humidity:
        return "humidity";
    }
    return "";
}

std::vector<TinDefect> findDefects(const TinArrays &tin, const Rectangle &domain, std::size_t limit)
{
    return Inspection(tin, domain, limit).run();
}

std::vector<TinDefect> findDefects(const Tin &tin, std::size_t limit)
{
    return findDefects(tin.arrays(), tin.domain(), limit);
}

Result<void> validate(const Tin &tin)
{
    const std::vector<TinDefect> defects = findDefects(tin, 1);
    if (defects.empty())
        return {};
    std::string ids;
    for (const std::uint32_t id : defects[0].ids)
        if (id != None)
            ids += (ids.empty() ? "" : ", ") + std::to_string(id);
    return fail(ErrorCode::BrokenTerrain, nameOf(defects[0].rule), ids);
}

} // namespace model::terrain
