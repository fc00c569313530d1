// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: P. Cignoni, C. Rocchini, R. Scopigno, Metro: measuring error on simplified surfaces, 1998.
// Differs: samples are placed by a rule, and those that cannot raise the maximum are left out.
#include "model/animation/hausdorff.h"

#include "model/animation/framepair.h"
#include "model/base/parallel.h"
#include "model/mesh/surfacedistance.h"
#include "model/mesh/surfacesamples.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

namespace model {

namespace {

constexpr double Unbounded = std::numeric_limits<double>::infinity();
constexpr std::size_t CancelInterval = 256; ///< edges or triangles between two looks at the progress

/// What of a surface does not change with the frames.
struct Surface
{
    Surface(const Connectivity &connectivity, std::span<const Vec3f> positions, const Progress &progress)
        : tree(connectivity, positions, progress)
        , edges(connectivity)
    {}

    SurfaceTree tree;
    VertexEdges edges;
    /// For each triangle and edge, whether the other surface has it too. Then it went there as a whole, and no point of
    /// it is farther from the other surface than its worst corner from where that went.
    std::vector<std::uint32_t> twins; ///< #T, the other surface's triangle of the same corners, or NoTriangle
    std::vector<bool> sharedEdges;    ///< #E
};

Triangle sortedCorners(Triangle triangle)
{
    std::ranges::sort(triangle);
    return triangle;
}

void findShared(Surface &surface, const Surface &other)
{
    using Entry = std::pair<Triangle, std::uint32_t>;
    std::vector<Entry> entries;
    const std::span<const Triangle> theirs = other.tree.triangles();
    for (std::size_t i = 0; i < theirs.size(); ++i)
        entries.emplace_back(sortedCorners(theirs[i]), std::uint32_t(i));
    std::ranges::sort(entries);
    for (const Triangle &triangle : surface.tree.triangles()) {
        const Triangle key = sortedCorners(triangle);
        const auto at = std::ranges::lower_bound(entries, key, {}, &Entry::first);
        surface.twins.push_back(at != entries.end() && at->first == key ? at->second : SurfaceDistance::NoTriangle);
    }
    for (const Edge &edge : surface.edges.edges())
        surface.sharedEdges.push_back(std::ranges::binary_search(other.edges.edges(), edge));
}

/// How far the samples of one surface are from another, in one frame. The samples come in the order in which the
/// maximum grows soonest; only what might raise it is computed.
class FarthestSample
{
public:
    FarthestSample(const Surface &from, std::span<const Vec3f> positions, const SurfaceDistance &to,
                   std::span<const double> squaredMoves, const Progress &progress)
        : mFrom(from)
        , mPositions(positions)
        , mTo(to)
        , mSquaredMoves(squaredMoves)
        , mProgress(progress)
    {}

    double find(double samplesPerTriangle)
    {
        tryVertices();
        const std::span<const Triangle> triangles = mFrom.tree.triangles();
        const SampleCounts counts = countSamples(mPositions, triangles, mFrom.edges.edges(), samplesPerTriangle);
        tryTriangles(counts.onTriangle);
        tryEdges(counts.onEdge);
        return std::sqrt(mSquared);
    }

private:
    bool isStopped(std::size_t i) const { return i % CancelInterval == 0 && mProgress.isCancelled(); }

    void attempt(Vec3d point) { mSquared = std::max(mSquared, mTo.squared(point, mNearest, mSquared)); }

    /// Every vertex belongs to both surfaces.
    void tryVertices()
    {
        std::vector<std::uint32_t> order(mPositions.size());
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::stable_sort(order, std::greater(), [&](std::uint32_t i) { return mSquaredMoves[i]; });
        for (std::size_t i = 0; i < order.size() && mSquaredMoves[order[i]] > mSquared && !isStopped(i); ++i)
            attempt(mPositions[order[i]]);
    }

    void tryTriangles(std::span<const std::uint32_t> counts)
    {
        const std::span<const Triangle> triangles = mFrom.tree.triangles();
        const std::vector<std::uint32_t> &order = mFrom.tree.tree().order; // neighbours follow each other
        for (std::size_t i = 0; i < order.size() && !isStopped(i); ++i) {
            const std::uint32_t triangle = order[i];
            const auto &[a, b, c] = triangles[triangle];
            const std::uint32_t twin = mFrom.twins[triangle];
            const double bound = twin == SurfaceDistance::NoTriangle
                                     ? Unbounded
                                     : std::max({mSquaredMoves[a], mSquaredMoves[b], mSquaredMoves[c]});
            if (bound <= mSquared)
                continue;
            if (twin != SurfaceDistance::NoTriangle)
                mNearest = twin;
            const Vec3d corners[] = {mPositions[a], mPositions[b], mPositions[c]};
            for (std::uint32_t k = 0; k < counts[triangle]; ++k) {
                const auto [u, v, w] = triangleSample(k);
                attempt(corners[0] * u + corners[1] * v + corners[2] * w);
                if (k % CancelInterval == CancelInterval - 1 && mProgress.isCancelled())
                    return;
            }
        }
    }

    void tryEdges(std::span<const std::uint32_t> counts)
    {
        const std::span<const Edge> edges = mFrom.edges.edges();
        for (std::size_t i = 0; i < edges.size() && !isStopped(i); ++i) {
            const auto [a, b] = edges[i];
            const double bound = mFrom.sharedEdges[i] ? std::max(mSquaredMoves[a], mSquaredMoves[b]) : Unbounded;
            if (bound <= mSquared)
                continue;
            const Vec3d begin = mPositions[a], end = mPositions[b];
            for (std::uint32_t k = 0; k < counts[i]; ++k) {
                const double share = (k + 1.0) / (counts[i] + 1.0);
                attempt(begin * (1 - share) + end * share);
            }
        }
    }

    const Surface &mFrom;
    std::span<const Vec3f> mPositions;
    const SurfaceDistance &mTo;
    std::span<const double> mSquaredMoves; ///< #V, squared vertex errors
    const Progress &mProgress;
    double mSquared = 0;
    std::uint32_t mNearest = SurfaceDistance::NoTriangle; ///< of the sample before: a good place to look first
};

FrameHausdorff measure(const FramePair::Frame &frame, const Surface &reference, const Surface &test,
                       double samplesPerTriangle, const Progress &progress)
{
    std::vector<double> squaredMoves(frame.reference.size());
    for (std::size_t i = 0; i < squaredMoves.size(); ++i)
        squaredMoves[i] = squaredDistance(frame.reference[i], frame.test[i]);
    const SurfaceDistance toReference(reference.tree, frame.reference), toTest(test.tree, frame.test);
    return {FarthestSample(reference, frame.reference, toTest, squaredMoves, progress).find(samplesPerTriangle),
            FarthestSample(test, frame.test, toReference, squaredMoves, progress).find(samplesPerTriangle)};
}

} // namespace

Result<HausdorffResult> hausdorffDistance(const FrameSource &reference, const FrameSource &test,
                                          std::span<const std::uint32_t> permutation, double samplesPerTriangle,
                                          const Progress &progress)
{
    const auto pair = FramePair::of(reference, test, permutation);
    if (!pair)
        return fail(pair.error());
    const FramePair::Frame first = pair->frame(0);
    Surface referenceSurface(reference.connectivity(), first.reference, progress);
    Surface testSurface({test.vertexCount(), pair->testTriangles()}, first.test, progress);
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    findShared(referenceSurface, testSurface);
    findShared(testSurface, referenceSurface);

    HausdorffResult result;
    result.frames.resize(pair->frameCount());
    std::atomic<std::uint32_t> done = 0;
    parallelFor(result.frames.size(), [&](std::size_t i) {
        if (progress.isCancelled())
            return;
        result.frames[i] =
            measure(pair->frame(std::uint32_t(i)), referenceSurface, testSurface, samplesPerTriangle, progress);
        progress.report(double(++done) / double(result.frames.size()));
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    for (std::size_t i = 0; i < result.frames.size(); ++i) {
        const FrameHausdorff &frame = result.frames[i];
        result.fromReference = std::max(result.fromReference, frame.fromReference);
        result.fromTest = std::max(result.fromTest, frame.fromTest);
        if (frame.distance() > result.distance) {
            result.distance = frame.distance();
            result.worstFrame = std::uint32_t(i);
        }
    }
    return result;
}

} // namespace model
