// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: L. Vasa, V. Skala, A perception correlated comparison method for dynamic meshes, 2011.
// Differs: computed in one pass over blocks of frames.
#include "model/animation/sted.h"

#include "model/animation/framepair.h"
#include "model/base/parallel.h"
#include "model/geometry/diameter.h"
#include "model/geometry/vec3d.h"
#include "model/mesh/vertexedges.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>

namespace model {

namespace {

constexpr double StillStep = 0.0003; ///< t: what a vertex at rest counts as moving, so that noise on it is weighed
constexpr double TemporalWeight = 9.144e-5; ///< c
constexpr std::uint32_t WindowBefore = 4, WindowAfter = 5;

// How much is worked on at a time. Sums are formed per frame, and per range of vertices within it, so that no choice
// here shows in the result except VertexRange, which is fixed.
constexpr std::size_t VertexRange = 1024;
constexpr std::size_t BlockBytes = std::size_t(96) << 20;
constexpr std::uint32_t LongestBlock = 64;

/// The edges of one frame; lengths in the animation's units.
struct EdgeDifferences
{
    std::vector<double> length;     ///< #E, of the reference
    std::vector<double> difference; ///< #E, relative
};

/// The step to one frame.
struct Steps
{
    std::vector<double> size;       ///< #V, s
    std::vector<double> difference; ///< #V, s' - s
};

EdgeDifferences edgeDifferences(const FramePair::Frame &frame, std::span<const Edge> edges)
{
    EdgeDifferences result;
    result.length.resize(edges.size());
    result.difference.resize(edges.size());
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto [a, b] = edges[e];
        const double length = distance(frame.reference[a], frame.reference[b]);
        result.length[e] = length;
        result.difference[e] = length > 0 ? (length - distance(frame.test[a], frame.test[b])) / length : 0;
    }
    return result;
}

Steps steps(const FramePair::Frame &before, const FramePair::Frame &after, double inverseSquaredDiameter)
{
    const auto size = [&](Vec3d a, Vec3d b) {
        return std::sqrt(squaredDistance(a, b) * inverseSquaredDiameter + StillStep * StillStep);
    };
    Steps result;
    const std::size_t count = before.reference.size();
    result.size.resize(count);
    result.difference.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        result.size[i] = size(before.reference[i], after.reference[i]);
        result.difference[i] = size(before.test[i], after.test[i]) - result.size[i];
    }
    return result;
}

double deviation(const EdgeDifferences &frame, std::span<const std::uint32_t> edges)
{
    double length = 0, weighted = 0;
    for (const std::uint32_t e : edges) {
        length += frame.length[e];
        weighted += frame.difference[e] * frame.length[e];
    }
    if (!(length > 0))
        return 0;
    const double mean = weighted / length;
    double squares = 0;
    for (const std::uint32_t e : edges) {
        const double off = frame.difference[e] - mean;
        squares += frame.length[e] * off * off;
    }
    return std::sqrt(squares / length);
}

/// Goes through the animation block by block. Within a block the frames, then ranges of vertices, then the frames again
/// are spread over threads.
class Measurement
{
public:
    Measurement(const FramePair &pair, const Progress &progress)
        : mPair(pair)
        , mProgress(progress)
        , mEdges(pair.reference().connectivity())
    {
        const double d = diameter(pair.reference().frame(0), progress);
        mInverseSquaredDiameter = d > 0 ? 1 / (d * d) : 1;
        const std::size_t frameBytes =
            mEdges.edges().size() * 2 * sizeof(double) + pair.vertexCount() * (2 * sizeof(Vec3f) + 2 * sizeof(double));
        mBlock = std::uint32_t(std::clamp<std::size_t>(BlockBytes / frameBytes, 1, LongestBlock));
        mResult.frames.resize(pair.frameCount());
    }

    /// What has been measured; incomplete after a cancel.
    StedResult run()
    {
        const std::uint32_t frameCount = mPair.frameCount();
        for (std::uint32_t begin = 0; begin < frameCount && !mProgress.isCancelled(); begin += mBlock) {
            const std::uint32_t end = std::min(frameCount, begin + mBlock);
            loadBlock(begin, end);
            measureShape(begin, end);
            measureMotion(end == frameCount);
            mProgress.report(double(end) / frameCount);
        }
        sum();
        return std::move(mResult);
    }

private:
    void loadBlock(std::uint32_t begin, std::uint32_t end)
    {
        const std::size_t count = end - begin;
        std::vector<FramePair::Frame> frames(count + 1); // the last of the block before first
        frames[0] = std::move(mLastFrame);
        mDifferences.resize(count);
        parallelFor(count, [&](std::size_t i) {
            if (mProgress.isCancelled())
                return;
            frames[i + 1] = mPair.frame(begin + std::uint32_t(i));
            mDifferences[i] = edgeDifferences(frames[i + 1], mEdges.edges());
        });
        if (mProgress.isCancelled())
            return;
        const std::size_t firstStep = begin == 0 ? 1 : 0; // no step leads to the first frame
        const std::size_t before = mSteps.size();
        mSteps.resize(before + count - firstStep);
        parallelFor(count - firstStep, [&](std::size_t i) {
            mSteps[before + i] = steps(frames[i + firstStep], frames[i + firstStep + 1], mInverseSquaredDiameter);
        });
        mLastFrame = std::move(frames.back());
    }

    void measureShape(std::uint32_t begin, std::uint32_t end)
    {
        const std::size_t frames = end - begin;
        const std::size_t ranges = (mPair.vertexCount() + VertexRange - 1) / VertexRange;
        std::vector<double> sums(ranges * frames);
        parallelFor(ranges, [&](std::size_t range) {
            std::vector<std::uint32_t> edges;
            const std::size_t last = std::min<std::size_t>(mPair.vertexCount(), (range + 1) * VertexRange);
            for (std::size_t i = range * VertexRange; i < last && !mProgress.isCancelled(); ++i) {
                findEdgesAround(mEdges, std::uint32_t(i), edges);
                for (std::size_t f = 0; f < frames; ++f)
                    sums[range * frames + f] += deviation(mDifferences[f], edges);
            }
        });
        for (std::size_t f = 0; f < frames; ++f) {
            double sum = 0;
            for (std::size_t range = 0; range < ranges; ++range)
                sum += sums[range * frames + f];
            mResult.frames[begin + f].spatial = sum / mPair.vertexCount();
        }
    }

    /// Measures the frames whose window is complete, and drops the steps that no later window holds.
    void measureMotion(bool isLastBlock)
    {
        if (mProgress.isCancelled())
            return;
        const std::uint32_t known =
            mFirstStep + std::uint32_t(mSteps.size()); // the first frame whose step is not known
        const std::uint32_t end = isLastBlock ? known : std::max(mNextMotion, known - std::min(known, WindowAfter));
        parallelFor(end - mNextMotion, [&](std::size_t i) {
            if (!mProgress.isCancelled())
                mResult.frames[mNextMotion + i].temporal = motionDifference(mNextMotion + std::uint32_t(i), known);
        });
        mNextMotion = end;
        for (; mFirstStep + WindowBefore < mNextMotion && !mSteps.empty(); ++mFirstStep)
            mSteps.pop_front();
    }

    double motionDifference(std::uint32_t frame, std::uint32_t known) const
    {
        const std::uint32_t from = std::max(mFirstStep, frame - std::min(frame, WindowBefore));
        const std::uint32_t to = std::min(known, frame + WindowAfter + 1);
        const Steps &own = mSteps[frame - mFirstStep];
        double sum = 0;
        for (std::size_t i = 0; i < own.size.size(); ++i) {
            double window = 0;
            for (std::uint32_t g = from; g < to; ++g)
                window += mSteps[g - mFirstStep].size[i];
            sum += std::abs(own.difference[i]) * double(to - from) / window;
        }
        return sum / mPair.vertexCount();
    }

    void sum()
    {
        const double frameCount = mPair.frameCount();
        for (const FrameSted &frame : mResult.frames) {
            mResult.spatial += frame.spatial / frameCount;
            mResult.temporal += frame.temporal / std::max(frameCount - 1, 1.0);
        }
        const double temporal = TemporalWeight * mResult.temporal;
        mResult.sted = std::sqrt(mResult.spatial * mResult.spatial + temporal * temporal);
    }

    const FramePair &mPair;
    const Progress &mProgress;
    const VertexEdges mEdges;
    double mInverseSquaredDiameter = 1;
    std::uint32_t mBlock = 1;

    FramePair::Frame mLastFrame;               ///< of the block before
    std::vector<EdgeDifferences> mDifferences; ///< of the frames of the block
    std::deque<Steps> mSteps;                  ///< that windows to come still need
    std::uint32_t mFirstStep = 1;              ///< the frame that mSteps.front() leads to
    std::uint32_t mNextMotion = 1;             ///< the first frame whose motion is not measured yet
    StedResult mResult;
};

} // namespace

Result<StedResult> spatioTemporalDifference(const FrameSource &reference, const FrameSource &test,
                                            std::span<const std::uint32_t> permutation, const Progress &progress)
{
    const auto pair = FramePair::of(reference, test, permutation);
    if (!pair)
        return fail(pair.error());
    StedResult result = Measurement(*pair, progress).run();
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    return result;
}

} // namespace model
