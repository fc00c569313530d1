// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: Z. Karni, C. Gotsman, Compression of soft-body animation sequences, 2004 (the KG error).
// Differs: the mean is that over the vertices of each frame, not over time, as the authors' later programs compute it.
#include "model/animation/metrics.h"

#include "model/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

namespace model {

namespace {

struct Point
{
    double x = 0, y = 0, z = 0;
};

double squaredDistance(const Point &a, Vec3f b)
{
    const double dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z;
    return dx * dx + dy * dy + dz * dz;
}

/// What one frame contributes. Each is summed in the order of the vertices by one thread, so that the result does not
/// depend on how frames are spread over threads.
struct FrameSums
{
    double squaredError = 0;
    double squaredSpread = 0; ///< of the reference around its mean vertex
    double largest = -1;      ///< squared
    std::uint32_t worstVertex = 0;
    Box3f box;
};

FrameSums sumsOf(std::span<const Vec3f> reference, std::span<const Vec3f> test,
                 std::span<const std::uint32_t> permutation)
{
    FrameSums sums;
    Point mean;
    for (const Vec3f &v : reference)
        mean = {mean.x + v.x, mean.y + v.y, mean.z + v.z};
    const double count = double(reference.size());
    mean = {mean.x / count, mean.y / count, mean.z / count};
    for (const Vec3f &v : reference)
        sums.squaredSpread += squaredDistance(mean, v);
    for (std::size_t i = 0; i < test.size(); ++i) {
        const std::uint32_t vertex = permutation.empty() ? std::uint32_t(i) : permutation[i];
        const Vec3f v = reference[vertex];
        const double error = squaredDistance({v.x, v.y, v.z}, test[i]);
        sums.squaredError += error;
        if (error > sums.largest || (error == sums.largest && vertex < sums.worstVertex)) {
            sums.largest = error;
            sums.worstVertex = vertex;
        }
    }
    sums.box = boundingBox(reference);
    return sums;
}

double kgErrorPercent(double squaredError, double squaredSpread)
{
    return 100 * std::sqrt(squaredError) / (squaredSpread > 0 ? std::sqrt(squaredSpread) : 1);
}

double diagonalOf(const Box3f &box)
{
    return std::sqrt(squaredDistance({box.min.x, box.min.y, box.min.z}, box.max));
}

std::optional<Error> errorOfPermutation(std::span<const std::uint32_t> permutation, std::uint32_t vertexCount)
{
    const auto bad = [](std::string what) {
        return Error{ErrorCode::BadPermutation, {std::move(what)}, {}, Error::None, Error::None};
    };
    if (permutation.size() != vertexCount)
        return bad(std::to_string(permutation.size()) + " entries for " + std::to_string(vertexCount) + " vertices");
    std::vector<bool> seen(vertexCount);
    for (const std::uint32_t vertex : permutation) {
        if (vertex >= vertexCount)
            return bad("vertex " + std::to_string(vertex) + " of " + std::to_string(vertexCount));
        if (seen[vertex])
            return bad("vertex " + std::to_string(vertex) + " twice");
        seen[vertex] = true;
    }
    return {};
}

ComparisonResult resultOf(std::span<const FrameSums> frames, std::uint32_t vertexCount)
{
    ComparisonResult result;
    double squaredError = 0, squaredSpread = 0, largest = -1;
    Box3f box;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const FrameSums &frame = frames[i];
        result.frames.push_back({kgErrorPercent(frame.squaredError, frame.squaredSpread),
                                 std::sqrt(frame.squaredError / vertexCount), std::sqrt(frame.largest),
                                 frame.worstVertex});
        squaredError += frame.squaredError;
        squaredSpread += frame.squaredSpread;
        box.add(frame.box);
        if (frame.largest > largest) {
            largest = frame.largest;
            result.worstFrame = std::uint32_t(i);
            result.worstVertex = frame.worstVertex;
        }
    }
    result.kgErrorPercent = kgErrorPercent(squaredError, squaredSpread);
    result.rmse = std::sqrt(squaredError / (double(vertexCount) * double(frames.size())));
    result.maxVertexError = std::sqrt(largest);
    result.diagonal = diagonalOf(box);
    result.psnrDb =
        result.rmse > 0 ? 20 * std::log10(result.diagonal / result.rmse) : std::numeric_limits<double>::infinity();
    return result;
}

} // namespace

Result<ComparisonResult> compareAnimations(const FrameSource &reference, const FrameSource &test,
                                           std::span<const std::uint32_t> permutation, const Progress &progress)
{
    const std::uint32_t vertexCount = reference.vertexCount();
    const std::uint32_t frameCount = reference.frameCount();
    if (test.vertexCount() != vertexCount)
        return fail(ErrorCode::MeshesDiffer, "vertices", std::to_string(vertexCount),
                    std::to_string(test.vertexCount()));
    if (test.frameCount() != frameCount)
        return fail(ErrorCode::MeshesDiffer, "frames", std::to_string(frameCount), std::to_string(test.frameCount()));
    if (!permutation.empty())
        if (std::optional<Error> error = errorOfPermutation(permutation, vertexCount))
            return fail(std::move(*error));

    std::vector<FrameSums> frames(frameCount);
    std::atomic<std::uint32_t> done = 0;
    parallelFor(frameCount, [&](std::size_t i) {
        if (progress.isCancelled())
            return;
        frames[i] = sumsOf(reference.frame(std::uint32_t(i)), test.frame(std::uint32_t(i)), permutation);
        progress.report(double(++done) / frameCount);
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    return resultOf(frames, vertexCount);
}

} // namespace model
