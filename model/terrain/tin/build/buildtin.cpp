// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/tin.h"

#include "model/base/numbertext.h"
#include "model/terrain/tin/build/hilbert.h"
#include "model/terrain/tin/tinwriter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace model::terrain {

namespace {

/// Ids are 31 bits, and there are two triangles, of four corners each, for a vertex.
constexpr std::size_t LargestPointCount = (std::size_t(1) << 28) - 1;

bool isUsable(Point2 p)
{
    return std::abs(p.x) <= LargestCoordinate && std::abs(p.y) <= LargestCoordinate;
}

Result<void> check(std::span<const Point3> points, const Rectangle &domain)
{
    if (!isUsable(domain.low) || !isUsable(domain.high) || !(domain.low.x < domain.high.x) ||
        !(domain.low.y < domain.high.y))
        return fail(ErrorCode::BadValue, "extent of the terrain",
                    numberText(domain.high.x - domain.low.x) + " x " + numberText(domain.high.y - domain.low.y),
                    "more than nothing in both directions");
    if (points.size() > LargestPointCount)
        return fail(ErrorCode::LimitExceeded, "number of points", std::to_string(points.size()),
                    std::to_string(LargestPointCount));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point3 &p = points[i];
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            return fail(ErrorCode::NonFinite, "point " + std::to_string(i));
        if (!domain.contains({p.x, p.y}))
            return fail(ErrorCode::BadValue, "point " + std::to_string(i), numberText(p.x) + ", " + numberText(p.y),
                        numberText(domain.low.x) + " ... " + numberText(domain.high.x) + ", " +
                            numberText(domain.low.y) + " ... " + numberText(domain.high.y));
    }
    return {};
}

double nearestHeight(std::span<const Point3> points, Point2 p)
{
    double nearest = INFINITY, height = 0;
    for (const Point3 &point : points) {
        const double distance = (point.x - p.x) * (point.x - p.x) + (point.y - p.y) * (point.y - p.y);
        if (distance < nearest) {
            nearest = distance;
            height = point.z;
        }
    }
    return height;
}

} // namespace

struct TinBuilder
{
    TinBuilder(std::span<const Point3> points, const Rectangle &domain)
        : mPoints(points)
        , mBuilt{Tin(domain), std::vector<VertexId>(points.size(), None), 0}
    {}

    /// Numbers the points along the Hilbert curve, and puts them in along it too.
    BuiltTin build()
    {
        TinArrays &tin = mBuilt.tin.mArrays;
        tin.reserve(mPoints.size() + 4, 2 * (mPoints.size() + 4));
        for (VertexId v = 0; v < 4; ++v)
            tin.heights[v] = nearestHeight(mPoints, tin.points[v]);
        numberVertices();
        insertVertices();
        tin.totals.vertices = tin.vertexSlots();
        tin.totals.ledger.start = mBuilt.tin.volume();
        mBuilt.tin.mHints.build(tin, mBuilt.tin.domain());
        return std::move(mBuilt);
    }

private:
    /// A vertex for each point that is not where one before it is.
    void numberVertices()
    {
        constexpr std::size_t Ahead = 12; // what is read here and there is asked for that early
        TinArrays &tin = mBuilt.tin.mArrays;
        const std::vector<std::uint32_t> order = hilbertOrder(mPoints, mBuilt.tin.domain());
        bool isCornerTaken[4] = {}; // by a point that lies there
        VertexId last = None;
        tin.resizeVertices(mPoints.size() + 4);
        VertexId end = 4;
        for (std::size_t k = 0; k < order.size(); ++k) {
            if (k + Ahead < order.size()) {
                prefetch(&mPoints[order[k + Ahead]]);
                prefetch(&mBuilt.vertexOf[order[k + Ahead]]);
            }
            const Point3 &point = mPoints[order[k]];
            const Point2 p{point.x, point.y};
            const auto corner = VertexId(std::find(tin.points.data(), tin.points.data() + 4, p) - tin.points.data());
            if (corner < 4) {
                mBuilt.duplicates += std::exchange(isCornerTaken[corner], true);
                last = corner;
            } else if (last != None && tin.points[last] == p) {
                ++mBuilt.duplicates;
            } else {
                last = end++;
                tin.points[last] = p;
                tin.heights[last] = point.z;
                tin.corners[last] = NoCorner;
                tin.constraints[last] = None;
            }
            mBuilt.vertexOf[order[k]] = last;
        }
        tin.resizeVertices(end);
    }

    /// Coarsely first, and then between those: where all come one after the other, each new one lies beside long thin
    /// triangles that reach over all of the ground still empty. 3.0 flips for a point instead of 4.7, and a fifth of
    /// the time.
    void insertVertices()
    {
        constexpr VertexId Steps[] = {64, 8, 1};
        TinArrays &tin = mBuilt.tin.mArrays;
        TinWriter writer(tin, mBuilt.tin.mJournal);
        VertexId near = 0, before = 0;
        for (const VertexId step : Steps) {
            for (VertexId v = 4; v < tin.vertexSlots(); v += step) {
                if (before != 0 && (v - 4) % before == 0)
                    continue;
                const Location location = locate(tin, tin.points[v], near);
                assert(location.kind != Location::Kind::Vertex && "points at one place are neighbours in the order");
                if (location.kind == Location::Kind::Edge)
                    writer.splitEdge(location.corner, v);
                else
                    writer.splitTriangle(triangleOf(location.corner), v);
                writer.restoreDelaunayAround(v);
                near = v;
            }
            before = step;
        }
    }

    const std::span<const Point3> mPoints;
    BuiltTin mBuilt;
};

Result<BuiltTin> buildTin(std::span<const Point3> points, const Rectangle &domain)
{
    if (const Result<void> checked = check(points, domain); !checked)
        return fail(checked.error());
    return TinBuilder(points, domain).build();
}

Rectangle boundsOf(std::span<const Point3> points)
{
    assert(!points.empty());
    Rectangle bounds{{points[0].x, points[0].y}, {points[0].x, points[0].y}};
    for (const Point3 &p : points) {
        bounds.low = {std::min(bounds.low.x, p.x), std::min(bounds.low.y, p.y)};
        bounds.high = {std::max(bounds.high.x, p.x), std::max(bounds.high.y, p.y)};
    }
    return bounds;
}

} // namespace model::terrain
