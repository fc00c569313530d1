// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/tin.h"

#include "model/base/numbertext.h"
#include "model/terrain/tin/hilbert.h"
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
    /// Puts the points in one after the other, along the Hilbert curve.
    static BuiltTin build(std::span<const Point3> points, const Rectangle &domain)
    {
        BuiltTin built{Tin(domain), std::vector<VertexId>(points.size(), None), 0};
        TinArrays &tin = built.tin.mArrays;
        tin.reserve(points.size() + 4, 2 * (points.size() + 4));
        for (VertexId v = 0; v < 4; ++v)
            tin.heights[v] = nearestHeight(points, tin.points[v]);
        TinWriter writer(tin, built.tin.mJournal);
        VertexId near = 0;
        bool isCornerTaken[4] = {}; // by a point that lies there
        for (const std::uint32_t i : hilbertOrder(points, domain)) {
            const Point2 p{points[i].x, points[i].y};
            const Location location = locate(tin, p, near);
            if (location.kind == Location::Kind::Vertex) {
                near = tin.vertex(location.corner);
                built.duplicates += near >= 4 || std::exchange(isCornerTaken[near], true);
            } else {
                near = writer.addVertex(p, points[i].z);
                if (location.kind == Location::Kind::Edge)
                    writer.splitEdge(location.corner, near);
                else
                    writer.splitTriangle(triangleOf(location.corner), near);
                writer.restoreDelaunayAround(near);
            }
            built.vertexOf[i] = near;
        }
        tin.totals.ledger.start = built.tin.volume();
        built.tin.mHints.build(tin, domain);
        return built;
    }
};

Result<BuiltTin> buildTin(std::span<const Point3> points, const Rectangle &domain)
{
    if (const Result<void> checked = check(points, domain); !checked)
        return fail(checked.error());
    return TinBuilder::build(points, domain);
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
