// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/contours.h"

#include <algorithm>
#include <cmath>

namespace model::io {

using namespace terrain;

namespace {

/// Follows the lines of one level.
class LevelTracer
{
public:
    LevelTracer(const TinArrays &tin, std::vector<double> &seenAt, double level, std::vector<Contour> &out)
        : mTin(tin)
        , mSeenAt(seenAt)
        , mLevel(level)
        , mOut(out)
    {}

    void traceFrom(TriangleId t)
    {
        if (mSeenAt[t] == mLevel || !isCrossed(t))
            return;
        // Back to where the line begins, or once around.
        Corner first = entryOf(t);
        for (Corner o = mTin.opposite(first); o != NoCorner && !mTin.isVoid(triangleOf(o)); o = mTin.opposite(first)) {
            first = entryOf(triangleOf(o));
            if (triangleOf(first) == t)
                break;
        }
        Contour contour{mLevel, false, {pointOn(first)}};
        for (Corner c = first;;) {
            mSeenAt[triangleOf(c)] = mLevel;
            const Corner exit = exitOf(triangleOf(c));
            add(contour, pointOn(exit));
            const Corner o = mTin.opposite(exit);
            if (o == NoCorner || mTin.isVoid(triangleOf(o)))
                break;
            if (o == first) {
                contour.isClosed = true;
                break;
            }
            c = o;
        }
        if (contour.isClosed && contour.points.back() != contour.points.front())
            contour.points.push_back(contour.points.front());
        if (contour.points.size() > (contour.isClosed ? 3u : 1u))
            mOut.push_back(std::move(contour));
    }

private:
    bool isAbove(Corner c) const { return mTin.heights[mTin.vertex(c)] >= mLevel; }
    bool isCrossed(TriangleId t) const
    {
        const int above = isAbove(cornerOf(t, 0)) + isAbove(cornerOf(t, 1)) + isAbove(cornerOf(t, 2));
        return above == 1 || above == 2;
    }
    /// With the high ground on its left the line comes in over the edge that, counter-clockwise, begins above and ends
    /// below, and leaves over the one that begins below.
    Corner entryOf(TriangleId t) const { return edgeFrom(t, true); }
    Corner exitOf(TriangleId t) const { return edgeFrom(t, false); }
    Corner edgeFrom(TriangleId t, bool beginsAbove) const
    {
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c)
            if (isAbove(next(c)) == beginsAbove && isAbove(previous(c)) != beginsAbove)
                return c;
        return NoCorner;
    }
    Point2 pointOn(Corner c) const
    {
        // From the lower number, so that both triangles of an edge say the same point.
        VertexId u = mTin.vertex(next(c)), w = mTin.vertex(previous(c));
        if (u > w)
            std::swap(u, w);
        const double zu = mTin.heights[u], zw = mTin.heights[w], s = std::clamp((mLevel - zu) / (zw - zu), 0.0, 1.0);
        const Point2 a = mTin.points[u], b = mTin.points[w];
        return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
    }
    static void add(Contour &contour, Point2 p)
    {
        if (contour.points.back() != p)
            contour.points.push_back(p);
    }

    const TinArrays &mTin;
    std::vector<double> &mSeenAt; ///< of each triangle, the level whose line went through it last
    const double mLevel;
    std::vector<Contour> &mOut;
};

} // namespace

Result<std::vector<Contour>> contoursOf(const Tin &tin, double interval, double base, const Progress &progress)
{
    const TinArrays &arrays = tin.arrays();
    double lowest = INFINITY, highest = -INFINITY;
    const auto isGround = [&](TriangleId t) { return arrays.isTriangle(t) && !arrays.isVoid(t); };
    const auto rangeOf = [&](TriangleId t) {
        const double a = arrays.heights[arrays.vertex(cornerOf(t, 0))],
                     b = arrays.heights[arrays.vertex(cornerOf(t, 1))],
                     c = arrays.heights[arrays.vertex(cornerOf(t, 2))];
        return std::pair(std::min({a, b, c}), std::max({a, b, c}));
    };
    for (TriangleId t = 0; t < arrays.triangleSlots(); ++t)
        if (isGround(t)) {
            const auto [low, high] = rangeOf(t);
            lowest = std::min(lowest, low);
            highest = std::max(highest, high);
        }
    std::vector<Contour> contours;
    if (!(lowest <= highest))
        return contours;
    constexpr double MaxLevels = 1e6;
    const double first = std::ceil((lowest - base) / interval), last = std::floor((highest - base) / interval);
    if (last - first > MaxLevels)
        return fail(ErrorCode::LimitExceeded, "number of levels", std::to_string(std::uint64_t(last - first)),
                    "1000000");
    // The triangles of each level: those that lie across it.
    const auto levels = std::size_t(std::max(0.0, last - first + 1));
    std::vector<std::vector<TriangleId>> trianglesAt(levels);
    for (TriangleId t = 0; t < arrays.triangleSlots(); ++t) {
        if (!isGround(t))
            continue;
        const auto [low, high] = rangeOf(t);
        const double from = std::max(first, std::ceil((low - base) / interval)),
                     to = std::min(last, std::floor((high - base) / interval));
        for (double k = from; k <= to; ++k)
            trianglesAt[std::size_t(k - first)].push_back(t);
    }
    std::vector<double> seenAt(arrays.triangleSlots(), NAN);
    for (std::size_t k = 0; k < levels; ++k) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        LevelTracer tracer(arrays, seenAt, base + (first + double(k)) * interval, contours);
        for (const TriangleId t : trianglesAt[k])
            tracer.traceFrom(t);
        progress.report(double(k + 1) / double(levels));
    }
    return contours;
}

} // namespace model::io
