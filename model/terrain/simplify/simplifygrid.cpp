// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: M. Garland, P. S. Heckbert, Fast Polygonal Approximation of Terrains and Height Fields, CMU-CS-95-181,
// 1995. Differs: borders of voids are constrained; triangles are scanned by rows in integers.
#include "model/terrain/simplify/simplifygrid.h"

#include "model/terrain/tin/build/restoretin.h"
#include "model/terrain/tin/constraints/constraintlists.h"
#include "model/terrain/tin/query/locate.h"
#include "model/terrain/tin/query/surface.h"
#include "model/terrain/tin/tinedit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <queue>
#include <unordered_map>

namespace model::terrain {

namespace {

constexpr std::uint64_t NoNode = ~std::uint64_t(0);
/// Whom the borders of voids belong to until the voids are marked.
constexpr OwnerId BorderOwner = 0;

struct Node
{
    std::int64_t i, j;
};

/// Floor and ceiling of a / b, for b > 0.
std::int64_t floorDivide(std::int64_t a, std::int64_t b)
{
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}
std::int64_t ceilDivide(std::int64_t a, std::int64_t b)
{
    return -floorDivide(-a, b);
}

class GridSimplifier
{
public:
    GridSimplifier(const HeightGrid &grid, const SimplifySettings &settings)
        : mGrid(grid)
        , mSettings(settings)
    {
        // The surface that is asked later is computed in another order than here.
        double largest = 0;
        for (const double height : grid.heights)
            if (!std::isnan(height))
                largest = std::max(largest, std::abs(height));
        mLimit = std::max(0.0, settings.maxError - 32 * RoundingUnitOf(largest));
    }

    Result<Tin> run(const Progress &progress)
    {
        Result<Tin> start = makeStart();
        if (!start)
            return start;
        mArrays = start->arrays();
        mCandidates.resize(mArrays.triangleSlots());
        for (TriangleId t = 0; t < mArrays.triangleSlots(); ++t) {
            scan(t);
            if (progress.isCancelled())
                return fail(ErrorCode::Cancelled);
        }
        if (const Result<void> done = insertAll(progress); !done)
            return fail(done.error());
        return restoreTin(std::move(mArrays), mGrid.domain(), constrainedEdges(mArrays));
    }

private:
    struct Candidate
    {
        double error = 0;
        std::uint64_t node = NoNode;
    };
    struct Entry
    {
        double error;
        std::uint64_t node;
        TriangleId triangle;
        /// The larger error first; at equal ones the earlier node, so that the result depends on nothing else.
        friend bool operator<(const Entry &a, const Entry &b)
        {
            return a.error != b.error ? a.error < b.error : a.node > b.node;
        }
    };

    static double RoundingUnitOf(double value) { return value * 0x1p-53; }

    double vertexHeight(double height) const
    {
        return mSettings.heightQuantum > 0 ? std::nearbyint(height / mSettings.heightQuantum) * mSettings.heightQuantum
                                           : height;
    }
    double heightOfNode(std::uint64_t node) const { return vertexHeight(mGrid.heights[node]); }

    /// The corners of the domain, the border of the voids, the voids themselves.
    Result<Tin> makeStart()
    {
        const std::uint32_t right = mGrid.columns - 1, top = mGrid.rows - 1;
        double lowest = INFINITY;
        for (const double height : mGrid.heights)
            if (height < lowest)
                lowest = height;
        if (lowest == INFINITY)
            return fail(ErrorCode::NoSurface);
        std::vector<Point3> points;
        std::unordered_map<std::uint64_t, std::uint32_t> pointOf;
        const auto addNode = [&](std::uint32_t i, std::uint32_t j) {
            const auto [found, isNew] = pointOf.try_emplace(mGrid.index(i, j), std::uint32_t(points.size()));
            if (isNew) {
                const Point2 p = mGrid.point(i, j);
                const double height = mGrid.height(i, j);
                points.push_back({p.x, p.y, vertexHeight(std::isnan(height) ? lowest : height)});
                mNodes.push_back(mGrid.index(i, j));
            }
            return found->second;
        };
        addNode(0, 0);
        addNode(right, 0);
        addNode(right, top);
        addNode(0, top);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> segments;
        for (const GridSegment &segment : voidBorder(mGrid)) {
            const std::uint32_t from = addNode(segment.fromColumn, segment.fromRow);
            segments.emplace_back(from, addNode(segment.toColumn, segment.toRow));
        }
        auto built = buildTin(points, mGrid.domain());
        if (!built)
            return fail(built.error());
        std::vector<std::uint64_t> nodes(points.size());
        for (std::size_t p = 0; p < points.size(); ++p)
            nodes[built->vertexOf[p]] = mNodes[p];
        mNodes = std::move(nodes);

        Tin &tin = built->tin;
        TinEdit edit(tin, VolumeRule::Keep);
        for (const auto &[from, to] : segments)
            if (auto done = edit.constrain(built->vertexOf[from], built->vertexOf[to], BorderOwner); !done)
                return fail(done.error());
        std::vector<TriangleId> voids;
        for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t)
            if (isOverVoid(tin.arrays(), t))
                voids.push_back(t);
        if (voids.size() == tin.triangleCount())
            return fail(ErrorCode::NoSurface);
        edit.setVoid(voids, true);
        edit.releaseOwner(BorderOwner);
        edit.commit();
        return std::move(tin);
    }

    Node nodeOf(VertexId v) const
    {
        return {std::int64_t(mNodes[v] % mGrid.columns), std::int64_t(mNodes[v] / mGrid.columns)};
    }

    /// Of a triangle that no border of voids cuts: all of it is what the square at any inner point is.
    bool isOverVoid(const TinArrays &tin, TriangleId t) const
    {
        // In a third of a square: the centroid of a triangle of nodes lies on no border but that of a square inside it.
        std::int64_t i = 0, j = 0;
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
            const Node node = nodeOf(tin.vertex(c));
            i += node.i;
            j += node.j;
        }
        return !mGrid.isGround(std::uint32_t(std::min<std::int64_t>(i / 3, mGrid.columns - 2)),
                               std::uint32_t(std::min<std::int64_t>(j / 3, mGrid.rows - 2)));
    }

    /// The columns of row j that lie in the triangle, its border included.
    struct Edge
    {
        std::int64_t a, b, c; ///< inside where a i + b j + c >= 0
    };
    static Edge edgeBetween(Node from, Node to)
    {
        const std::int64_t a = from.j - to.j, b = to.i - from.i;
        return {a, b, -(a * from.i + b * from.j)};
    }
    static void narrow(const Edge &edge, std::int64_t j, std::int64_t &low, std::int64_t &high)
    {
        const std::int64_t rest = edge.b * j + edge.c;
        if (edge.a > 0)
            low = std::max(low, ceilDivide(-rest, edge.a));
        else if (edge.a < 0)
            high = std::min(high, floorDivide(rest, -edge.a));
        else if (rest < 0)
            high = low - 1;
    }

    /// Finds the worst node of a triangle.
    void scan(TriangleId t)
    {
        Candidate &best = mCandidates[t];
        best = {};
        if (mArrays.isVoid(t))
            return;
        const VertexId *const v = mArrays.triangleVertices.data() + 3 * std::size_t(t);
        const Node a = nodeOf(v[0]), b = nodeOf(v[1]), c = nodeOf(v[2]);
        const double za = mArrays.heights[v[0]], zb = mArrays.heights[v[1]] - za, zc = mArrays.heights[v[2]] - za;
        const double doubleArea = double((b.i - a.i) * (c.j - a.j) - (b.j - a.j) * (c.i - a.i));
        const double slopeI = (zb * double(c.j - a.j) - zc * double(b.j - a.j)) / doubleArea;
        const double slopeJ = (zc * double(b.i - a.i) - zb * double(c.i - a.i)) / doubleArea;
        const Edge edges[] = {edgeBetween(a, b), edgeBetween(b, c), edgeBetween(c, a)};
        const std::int64_t left = std::min({a.i, b.i, c.i}), right = std::max({a.i, b.i, c.i});
        for (std::int64_t j = std::min({a.j, b.j, c.j}), last = std::max({a.j, b.j, c.j}); j <= last; ++j) {
            std::int64_t low = left, high = right;
            for (const Edge &edge : edges)
                narrow(edge, j, low, high);
            const double *const row = mGrid.heights.data() + std::size_t(j) * mGrid.columns;
            const double base = za + slopeJ * double(j - a.j) - slopeI * double(a.i);
            for (std::int64_t i = low; i <= high; ++i) {
                const double error = std::abs(row[i] - (base + slopeI * double(i)));
                if (!(error > best.error))
                    continue;
                const std::uint64_t node = std::uint64_t(j) * mGrid.columns + std::uint64_t(i);
                // A vertex has the error that its rounded height gives it, and is no candidate.
                if (node != mNodes[v[0]] && node != mNodes[v[1]] && node != mNodes[v[2]])
                    best = {error, node};
            }
        }
        if (best.error > mLimit)
            mHeap.push({best.error, best.node, t});
        else
            best = {};
    }

    Result<void> insertAll(const Progress &progress)
    {
        Journal journal;
        TinWriter writer(mArrays, journal);
        const double worst = mHeap.empty() ? 0 : mHeap.top().error;
        for (std::uint32_t step = 1; !mHeap.empty(); ++step) {
            const Entry entry = mHeap.top();
            mHeap.pop();
            if (mCandidates[entry.triangle].node != entry.node || mCandidates[entry.triangle].error != entry.error)
                continue; // of a triangle that is no more
            if (step % 256 == 0) {
                if (progress.isCancelled())
                    return fail(ErrorCode::Cancelled);
                // Errors fall about as the vertices multiply.
                if (mLimit > 0)
                    progress.report(1 - std::log(entry.error / mLimit) / std::log(std::max(worst / mLimit, 1.0001)));
            }
            insert(writer, entry);
        }
        return {};
    }

    void insert(TinWriter &writer, const Entry &entry)
    {
        const auto i = std::uint32_t(entry.node % mGrid.columns), j = std::uint32_t(entry.node / mGrid.columns);
        const Point2 p = mGrid.point(i, j);
        const Location location = locateNear(p, entry.triangle);
        assert(location.kind != Location::Kind::Vertex && "a triangle's candidate lies in it, and not at a corner");
        VertexId v = None;
        if (location.kind == Location::Kind::Edge) {
            const VertexId a = mArrays.vertex(next(location.corner)), b = mArrays.vertex(previous(location.corner));
            v = writer.addVertex(p, heightOfNode(entry.node));
            writer.splitEdge(location.corner, v);
            if (mArrays.constraints[a] != None)
                splitRecords(writer, a, b, v);
        } else {
            v = writer.addVertex(p, heightOfNode(entry.node));
            writer.splitTriangle(triangleOf(location.corner), v);
        }
        mNodes.push_back(entry.node);
        writer.restoreDelaunayAround(v);
        mCandidates.resize(mArrays.triangleSlots());
        // Every flip made an edge at the new vertex: no other triangle has changed.
        forEachCornerAround(mArrays, v, [&](Corner c) { scan(triangleOf(c)); });
    }

    Location locateNear(Point2 p, TriangleId t) const { return locate(mArrays, p, mArrays.vertex(cornerOf(t, 0))); }

    const HeightGrid &mGrid;
    const SimplifySettings mSettings;
    double mLimit = 0;
    TinArrays mArrays;
    std::vector<std::uint64_t> mNodes;  ///< of each vertex
    std::vector<Candidate> mCandidates; ///< of each triangle
    std::priority_queue<Entry> mHeap;
};

Result<void> check(const HeightGrid &grid)
{
    if (grid.columns < 2 || grid.rows < 2)
        return fail(ErrorCode::BadValue, "size of the grid",
                    std::to_string(grid.columns) + " x " + std::to_string(grid.rows), "at least 2 x 2");
    for (std::size_t n = 0; n < grid.heights.size(); ++n)
        if (std::isinf(grid.heights[n]))
            return fail(ErrorCode::NonFinite,
                        "column " + std::to_string(n % grid.columns) + " of row " + std::to_string(n / grid.columns));
    return {};
}

} // namespace

double heightQuantumFor(double maxError)
{
    constexpr int Finest = -40, Coarsest = -10;
    if (!(maxError > 0))
        return 0;
    return std::ldexp(1.0, std::clamp(int(std::floor(std::log2(maxError / 8))), Finest, Coarsest));
}

Result<Tin> simplifyGrid(const HeightGrid &grid, const SimplifySettings &settings, const Progress &progress)
{
    if (const Result<void> checked = check(grid); !checked)
        return fail(checked.error());
    return GridSimplifier(grid, settings).run(progress);
}

} // namespace model::terrain
