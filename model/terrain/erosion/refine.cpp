// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/erosion/refine.h"

#include "model/terrain/tin/journal/slotmap.h"

#include <algorithm>
#include <cmath>

namespace model::terrain {

namespace {

double squaredLength(const TinArrays &tin, Corner c)
{
    const Point2 a = tin.pointAt(next(c)), b = tin.pointAt(previous(c));
    return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

Corner longestEdgeOf(const TinArrays &tin, TriangleId t)
{
    Corner longest = cornerOf(t, 0);
    for (Corner c = cornerOf(t, 1); c <= cornerOf(t, 2); ++c)
        if (squaredLength(tin, c) > squaredLength(tin, longest))
            longest = c;
    return longest;
}

class Removal
{
public:
    Removal(TinEdit &edit, double error, double flatAngle)
        : mEdit(edit)
        , mTin(edit.tin().arrays())
        , mTolerance(error / 2)
        , mFlat(std::cos(flatAngle * M_PI / 180))
    {}

    bool remove(VertexId v)
    {
        if (!mTin.isVertex(v) || !mEdit.canRemove(v) || !look(v) || !isFlat())
            return false;
        double bound = deviation(v);
        double before = 0;
        for (const TriangleId t : mStar)
            if (const double *const found = mBounds.find(t))
                before = std::max(before, *found);
        bound += before;
        if (!(bound <= mTolerance))
            return false;
        mEdit.remove(v);
        // The hole is filled with triangles that were there, and flips do not leave it.
        for (const TriangleId t : mStar)
            if (mTin.isTriangle(t)) {
                mBounds.set(t, bound);
                mChanged.push_back(t);
            }
        return true;
    }

    /// All vertices of triangles that are not what they were, ascending.
    std::vector<VertexId> changed() const
    {
        std::vector<VertexId> vertices;
        for (const TriangleId t : mChanged)
            if (mTin.isTriangle(t)) // not gone with a later vertex
                for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c)
                    vertices.push_back(mTin.vertex(c));
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        return vertices;
    }

private:
    /// The triangles around `v`, and their mean gradient. False beside a void.
    bool look(VertexId v)
    {
        mStar.clear();
        bool isVoid = false;
        double area = 0;
        mMean = {};
        forEachCornerAround(mTin, v, [&](Corner c) {
            const TriangleId t = triangleOf(c);
            isVoid |= mTin.isVoid(t);
            mStar.push_back(t);
            const Gradient g = gradientOf(mTin, t);
            const double weight = terrain::areaOf(mTin, t);
            mMean.x += weight * g.x;
            mMean.y += weight * g.y;
            area += weight;
        });
        mMean = {mMean.x / area, mMean.y / area};
        return !isVoid;
    }
    bool isFlat() const
    {
        const double meanLength = std::sqrt(1 + mMean.x * mMean.x + mMean.y * mMean.y);
        for (const TriangleId t : mStar) {
            const Gradient g = gradientOf(mTin, t);
            const double length = std::sqrt(1 + g.x * g.x + g.y * g.y);
            if (!((1 + g.x * mMean.x + g.y * mMean.y) >= mFlat * length * meanLength))
                return false;
        }
        return true;
    }
    /// How far the surface around `v` reaches above and below its mean plane together.
    double deviation(VertexId v) const
    {
        const Point2 p = mTin.points[v];
        double low = 0, high = 0;
        for (const TriangleId t : mStar)
            for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
                const Point2 q = mTin.pointAt(c);
                const double above =
                    mTin.heights[mTin.vertex(c)] - mTin.heights[v] - mMean.x * (q.x - p.x) - mMean.y * (q.y - p.y);
                low = std::min(low, above);
                high = std::max(high, above);
            }
        return high - low;
    }

    TinEdit &mEdit;
    const TinArrays &mTin;
    const double mTolerance;
    const double mFlat; ///< cosine
    std::vector<TriangleId> mStar;
    Gradient mMean;
    SlotMap<double> mBounds; ///< what removals did to a triangle, at most
    std::vector<TriangleId> mChanged;
};

} // namespace

bool hasLongEdge(const TinArrays &tin, TriangleId t, double longest)
{
    return squaredLength(tin, longestEdgeOf(tin, t)) > longest * longest;
}

std::vector<TriangleId> splitLongEdges(TinEdit &edit, std::span<const TriangleId> triangles, double longest,
                                       std::uint32_t limit, std::uint32_t &added, const Progress &progress)
{
    const TinArrays &tin = edit.tin().arrays();
    std::vector<TriangleId> queue(triangles.begin(), triangles.end()), around;
    for (std::size_t i = 0; i < queue.size() && added < limit && !progress.isCancelled(); ++i) {
        const TriangleId t = queue[i];
        if (!tin.isTriangle(t) || tin.isVoid(t) || !hasLongEdge(tin, t, longest))
            continue;
        const Corner c = longestEdgeOf(tin, t);
        const Corner o = tin.opposite(c);
        if (o != NoCorner && tin.isVoid(triangleOf(o)))
            continue;
        const Point2 a = tin.pointAt(next(c)), b = tin.pointAt(previous(c));
        const std::uint32_t before = tin.totals.vertices;
        const VertexId v = edit.insert({a.x + 0.5 * (b.x - a.x), a.y + 0.5 * (b.y - a.y)}, tin.vertex(next(c)));
        if (tin.totals.vertices == before)
            continue; // so short that its middle is one of its ends
        ++added;
        forEachCornerAround(tin, v, [&](Corner corner) {
            queue.push_back(triangleOf(corner));
            around.push_back(triangleOf(corner));
        });
        queue.push_back(t);
    }
    return around;
}

std::uint32_t removeRedundant(TinEdit &edit, std::span<const VertexId> candidates, double error, double flatAngle,
                              const Progress &progress)
{
    Removal removal(edit, error, flatAngle);
    const double leak = edit.leak();
    std::uint32_t removed = 0;
    for (const VertexId v : candidates) {
        if (progress.isCancelled())
            return removed;
        removed += removal.remove(v);
    }
    if (removed > 0)
        edit.giveBackVolume(removal.changed(), leak - edit.leak());
    return removed;
}

} // namespace model::terrain
