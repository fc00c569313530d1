// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: Z. Karni, C. Gotsman, Compression of soft-body animation sequences, 2004 (the KG error).
//           E. S. Jang and others, Interpolator data compression for MPEG-4 animation, 2004 (the DA error).
// Differs: the mean is that over the vertices of each frame, not over time, as the authors' later programs compute it.
#include "model/animation/metrics.h"

#include "model/animation/framepair.h"
#include "model/base/parallel.h"
#include "model/geometry/vec3d.h"

#include <atomic>
#include <cmath>
#include <limits>

namespace model {

namespace {

/// What one frame contributes. Each is summed in the order of the vertices by one thread, so that the result does not
/// depend on how frames are spread over threads.
struct FrameSums
{
    double squaredError = 0;
    double error = 0;         ///< lengths
    double squaredSpread = 0; ///< of the reference around its mean vertex
    double largest = -1;      ///< squared
    std::uint32_t worstVertex = 0;
    Box3f box;
};

FrameSums sumsOf(const FramePair::Frame &frame)
{
    FrameSums sums;
    Vec3d mean;
    for (const Vec3f &v : frame.reference)
        mean = mean + v;
    mean = mean * (1 / double(frame.reference.size()));
    for (std::size_t i = 0; i < frame.reference.size(); ++i) {
        sums.squaredSpread += squaredDistance(mean, frame.reference[i]);
        const double error = squaredDistance(frame.reference[i], frame.test[i]);
        sums.squaredError += error;
        sums.error += std::sqrt(error);
        if (error > sums.largest) {
            sums.largest = error;
            sums.worstVertex = std::uint32_t(i);
        }
    }
    sums.box = boundingBox(frame.reference);
    return sums;
}

double kgErrorPercent(double squaredError, double squaredSpread)
{
    return 100 * std::sqrt(squaredError) / (squaredSpread > 0 ? std::sqrt(squaredSpread) : 1);
}

ComparisonResult resultOf(std::span<const FrameSums> frames, std::uint32_t vertexCount)
{
    ComparisonResult result;
    Box3f box;
    for (const FrameSums &frame : frames)
        box.add(frame.box);
    result.diagonal = distance(box.min, box.max);
    const double unit = result.diagonal > 0 ? result.diagonal : 1;

    double squaredError = 0, squaredSpread = 0, largest = -1;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const FrameSums &frame = frames[i];
        result.frames.push_back({kgErrorPercent(frame.squaredError, frame.squaredSpread),
                                 frame.error / vertexCount / unit, std::sqrt(frame.squaredError / vertexCount),
                                 std::sqrt(frame.largest), frame.worstVertex});
        squaredError += frame.squaredError;
        squaredSpread += frame.squaredSpread;
        result.daError += result.frames.back().daError / double(frames.size());
        if (frame.largest > largest) {
            largest = frame.largest;
            result.worstFrame = std::uint32_t(i);
            result.worstVertex = frame.worstVertex;
        }
    }
    result.kgErrorPercent = kgErrorPercent(squaredError, squaredSpread);
    result.rmse = std::sqrt(squaredError / (double(vertexCount) * double(frames.size())));
    result.maxVertexError = std::sqrt(largest);
    result.psnrDb =
        result.rmse > 0 ? 20 * std::log10(result.diagonal / result.rmse) : std::numeric_limits<double>::infinity();
    return result;
}

} // namespace

Result<ComparisonResult> compareAnimations(const FrameSource &reference, const FrameSource &test,
                                           std::span<const std::uint32_t> permutation, const Progress &progress)
{
    const auto pair = FramePair::of(reference, test, permutation);
    if (!pair)
        return fail(pair.error());
    std::vector<FrameSums> frames(pair->frameCount());
    std::atomic<std::uint32_t> done = 0;
    parallelFor(frames.size(), [&](std::size_t i) {
        if (progress.isCancelled())
            return;
        frames[i] = sumsOf(pair->frame(std::uint32_t(i)));
        progress.report(double(++done) / double(frames.size()));
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    return resultOf(frames, pair->vertexCount());
}

} // namespace model
