// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/simplify/simplifytin.h"

#include "model/terrain/tin/build/restoretin.h"
#include "model/terrain/tin/predicates.h"
#include "model/terrain/tin/tinedit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

namespace model::terrain {

namespace {

class TinSimplifier
{
public:
    TinSimplifier(const Tin &from, double maxError, OwnerId loose)
        : mFrom(from)
        , mLoose(loose)
    {
        double largest = 0;
        for (VertexId v = 0; v < from.arrays().vertexSlots(); ++v)
            if (from.arrays().isVertex(v))
                largest = std::max(largest, std::abs(from.arrays().heights[v]));
        // The surface that is asked later is computed in another order than here.
        mLimit = std::max(0.0, maxError - 64 * largest * 0x1p-53);
    }

    Result<Tin> run(const Progress &progress)
    {
        Result<Tin> start = makeStart();
        if (!start)
            return start;
        mEdit.emplace(*start, VolumeRule::Keep);
        distribute();
        if (!insertAll(progress))
            return fail(ErrorCode::Cancelled);
        while (mendCrossings(progress))
            if (!insertAll(progress))
                return fail(ErrorCode::Cancelled);
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        mEdit->commit();
        TinArrays arrays = start->arrays();
        const std::vector<ConstrainedEdge> edges = constrainedEdges(arrays);
        takeLayers(arrays);
        return restoreTin(std::move(arrays), mFrom.domain(), edges);
    }

private:
    struct Entry
    {
        double error;
        VertexId vertex;
        TriangleId triangle;
        friend bool operator<(const Entry &a, const Entry &b)
        {
            return a.error != b.error ? a.error < b.error : a.vertex > b.vertex;
        }
    };

    const TinArrays &from() const { return mFrom.arrays(); }
    const TinArrays &to() const { return mEdit->tin().arrays(); }

    /// The corners of the domain, what is constrained, and the voids.
    Result<Tin> makeStart()
    {
        mNewOf.assign(from().vertexSlots(), None);
        std::vector<VertexId> kept{0, 1, 2, 3};
        std::vector<bool> isKept(from().vertexSlots());
        const auto keep = [&](VertexId v) {
            if (v >= 4 && !isKept[v])
                kept.push_back(v);
            isKept[v] = true;
        };
        std::vector<ConstraintRecord> edges;
        for (const ConstraintRecord &record : from().records.values())
            if (record.a != None && record.owner != mLoose) {
                edges.push_back(record);
                keep(record.a);
                keep(record.b);
            }
        std::vector<Point3> points;
        for (const VertexId v : kept)
            points.push_back({from().points[v].x, from().points[v].y, from().heights[v]});
        Result<BuiltTin> built = buildTin(points, mFrom.domain());
        if (!built)
            return fail(built.error());
        mOldOf.resize(kept.size());
        for (std::size_t i = 0; i < kept.size(); ++i) {
            mNewOf[kept[i]] = built->vertexOf[i];
            mOldOf[built->vertexOf[i]] = kept[i];
        }
        TinEdit edit(built->tin, VolumeRule::Keep);
        for (const ConstraintRecord &edge : edges)
            if (auto done = edit.constrain(mNewOf[edge.a], mNewOf[edge.b], edge.owner); !done)
                return fail(done.error());
        // The borders of voids are edges now: one place in a triangle says what all of it is.
        std::vector<TriangleId> voids;
        const TinArrays &tin = built->tin.arrays();
        for (TriangleId t = 0; t < tin.triangleSlots(); ++t) {
            const Point2 a = tin.pointAt(cornerOf(t, 0)), b = tin.pointAt(cornerOf(t, 1)),
                         c = tin.pointAt(cornerOf(t, 2));
            const Point2 centre{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
            if (from().isVoid(mFrom.triangleAt(centre, mOldOf[tin.vertex(cornerOf(t, 0))])))
                voids.push_back(t);
        }
        edit.setVoid(voids, true);
        edit.commit();
        return std::move(built->tin);
    }

    bool isOnGround(VertexId old) const
    {
        bool isGround = false;
        forEachCornerAround(from(), old, [&](Corner c) { isGround = isGround || !from().isVoid(triangleOf(c)); });
        return isGround;
    }

    /// Gives every vertex that is left out to the triangle it lies in.
    void distribute()
    {
        mNextOf.assign(from().vertexSlots(), None);
        mFirstOf.assign(to().triangleSlots(), None);
        mWorstOf.assign(to().triangleSlots(), {0, None, None});
        VertexId near = 0;
        for (VertexId v = 0; v < from().vertexSlots(); ++v) {
            if (!from().isVertex(v) || mNewOf[v] != None || !isOnGround(v))
                continue;
            const Location location = mEdit->tin().locate(from().points[v], near);
            near = to().vertex(location.corner);
            give(v, triangleOf(location.corner));
        }
        for (TriangleId t = 0; t < to().triangleSlots(); ++t)
            findWorst(t);
    }
    void give(VertexId v, TriangleId t)
    {
        mNextOf[v] = mFirstOf[t];
        mFirstOf[t] = v;
    }

    void findWorst(TriangleId t)
    {
        Entry worst{mLimit, None, t};
        for (VertexId v = mFirstOf[t]; v != None; v = mNextOf[v]) {
            const double error = std::abs(from().heights[v] - heightIn(to(), t, from().points[v]));
            if (error > worst.error || (error == worst.error && worst.vertex != None && v < worst.vertex))
                worst = {error, v, t};
        }
        mWorstOf[t] = worst;
        if (worst.vertex != None)
            mHeap.push(worst);
    }

    bool insertAll(const Progress &progress)
    {
        for (std::uint32_t step = 0; !mHeap.empty(); ++step) {
            if (step % 256 == 0 && progress.isCancelled())
                return false;
            const Entry entry = mHeap.top();
            mHeap.pop();
            if (mWorstOf[entry.triangle].vertex == entry.vertex && mWorstOf[entry.triangle].error == entry.error)
                insert(entry.vertex, to().vertex(cornerOf(entry.triangle, 0)));
        }
        return true;
    }

    void insert(VertexId old, VertexId near)
    {
        const VertexId v = mEdit->insert(from().points[old], from().heights[old], near);
        mNewOf[old] = v;
        mOldOf.resize(to().vertexSlots(), None);
        mOldOf[v] = old;
        redistributeAround(v);
    }

    /// What the triangles of `v` were given they may hold in other hands now: every triangle that its coming changed
    /// is one of them.
    void redistributeAround(VertexId v)
    {
        mFirstOf.resize(to().triangleSlots(), None);
        mWorstOf.resize(to().triangleSlots(), {0, None, None});
        std::vector<VertexId> loose;
        forEachCornerAround(to(), v, [&](Corner c) {
            VertexId &first = mFirstOf[triangleOf(c)];
            for (VertexId w = first; w != None; w = mNextOf[w])
                if (mNewOf[w] == None)
                    loose.push_back(w);
            first = None;
        });
        for (const VertexId w : loose)
            give(w, mEdit->tin().triangleAt(from().points[w], v));
        forEachCornerAround(to(), v, [&](Corner c) { findWorst(triangleOf(c)); });
    }

    /// Looks along every edge at what it crosses. \returns true if something was mended, and has to be looked at again
    bool mendCrossings(const Progress &progress)
    {
        std::vector<std::pair<VertexId, VertexId>> missing; // ends of old edges
        for (TriangleId t = 0; t < to().triangleSlots(); ++t) {
            if (t % 1024 == 0 && progress.isCancelled())
                return false;
            for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
                const Corner o = to().opposite(c);
                if (o != NoCorner && c < o && !(to().isVoid(t) && to().isVoid(triangleOf(o))))
                    lookAlong(mOldOf[to().vertex(next(c))], mOldOf[to().vertex(previous(c))], missing);
            }
        }
        for (const auto &[u, w] : missing) {
            if (mNewOf[u] == None)
                insert(u, None);
            else if (mNewOf[w] == None)
                insert(w, None);
            else if (cornerOfEdge(to(), mNewOf[u], mNewOf[w]) == NoCorner)
                constrain(u, w);
        }
        return !missing.empty();
    }

    void constrain(VertexId u, VertexId w)
    {
        // Old edges do not cross one another: neither does this one what is constrained.
        (void)mEdit->constrain(mNewOf[u], mNewOf[w], mLoose == None ? 0 : mLoose);
        // Triangles far from its ends may be others now.
        mHeap = {};
        distribute();
    }

    /// Finds the worst crossing of the new edge from `a` to `b` (old vertices) with an old edge.
    void lookAlong(VertexId a, VertexId b, std::vector<std::pair<VertexId, VertexId>> &missing) const
    {
        const Point2 end = from().points[b];
        double worst = mLimit;
        std::optional<std::pair<VertexId, VertexId>> edge;
        for (VertexId v = a; v != b;) {
            const Wedge wedge = wedgeTowards(from(), v, end);
            Corner c = wedge.corner;
            if (wedge.isAlongBorder) {
                v = from().vertex(previous(c));
                continue;
            }
            if (orientation(from().points[v], end, from().pointAt(next(c))) == 0) {
                v = from().vertex(next(c));
                continue;
            }
            const Point2 begin = from().points[v];
            for (;;) {
                const VertexId right = from().vertex(next(c)), left = from().vertex(previous(c));
                const double error = errorAt(a, b, right, left);
                if (error > worst) {
                    worst = error;
                    edge = {right, left};
                }
                const Corner o = from().opposite(c);
                const int side = orientation(begin, end, from().pointAt(o));
                if (side == 0) {
                    v = from().vertex(o);
                    break;
                }
                c = side > 0 ? next(o) : previous(o);
            }
        }
        if (edge)
            missing.push_back(*edge);
    }

    double errorAt(VertexId a, VertexId b, VertexId u, VertexId w) const
    {
        const auto cross = [&](VertexId p, VertexId q, VertexId r) {
            const Point2 A = from().points[p], B = from().points[q], C = from().points[r];
            return (B.x - A.x) * (C.y - A.y) - (B.y - A.y) * (C.x - A.x);
        };
        const double du = cross(a, b, u), dw = cross(a, b, w), da = cross(u, w, a), db = cross(u, w, b);
        if (du == dw || da == db)
            return 0;
        const double alongOld = std::clamp(du / (du - dw), 0.0, 1.0), alongNew = std::clamp(da / (da - db), 0.0, 1.0);
        const auto mix = [&](VertexId p, VertexId q, double s) {
            return from().heights[p] + s * (from().heights[q] - from().heights[p]);
        };
        return std::abs(mix(u, w, alongOld) - mix(a, b, alongNew));
    }

    void takeLayers(TinArrays &arrays) const
    {
        arrays.totals.layers = from().totals.layers;
        for (std::uint32_t l = 0; l < MaxLayers; ++l)
            arrays.totals.compacted[l] = from().totals.compacted[l];
        arrays.resizeVertices(arrays.vertexSlots());
        for (VertexId v = 0; v < arrays.vertexSlots(); ++v)
            for (std::uint32_t l = 0; l < arrays.layerCount(); ++l) {
                const LayerSample sample = from().sample(mOldOf[v], l);
                arrays.thicknesses[arrays.layerSlot(v, l)] = sample.thickness;
                arrays.humidities[arrays.layerSlot(v, l)] = sample.humidity;
            }
    }

    const Tin &mFrom;
    const OwnerId mLoose;
    double mLimit = 0;
    std::optional<TinEdit> mEdit;
    std::vector<VertexId> mNewOf;  ///< of each old vertex; None: left out
    std::vector<VertexId> mOldOf;  ///< of each new vertex
    std::vector<VertexId> mNextOf; ///< lists of the old vertices that lie in a triangle
    std::vector<VertexId> mFirstOf;
    std::vector<Entry> mWorstOf; ///< of each triangle
    std::priority_queue<Entry> mHeap;
};

} // namespace

Result<Tin> simplifyTin(const Tin &tin, double maxError, OwnerId loose, const Progress &progress)
{
    return TinSimplifier(tin, maxError, loose).run(progress);
}

} // namespace model::terrain
