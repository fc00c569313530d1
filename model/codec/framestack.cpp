// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/framestack.h"

#include "model/animation/sequence.h"
#include "model/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

namespace model::codec {

namespace {

constexpr std::size_t AllFinite = std::numeric_limits<std::size_t>::max();

/// The first vertex with a NaN or an infinity, or AllFinite.
std::size_t firstNonFinite(std::span<const Vec3f> positions)
{
    // x - x is 0 for finite x and NaN otherwise, so that one sum tells about all of them.
    float sum = 0;
    for (const Vec3f p : positions)
        sum += (p.x - p.x) + (p.y - p.y) + (p.z - p.z);
    if (sum == 0)
        return AllFinite;
    const auto bad = std::find_if(positions.begin(), positions.end(), [](Vec3f p) { return !isFinite(p); });
    return std::size_t(bad - positions.begin());
}

/// The error of the first frame (in their order) that has a position that is not finite.
Result<void> requireFinite(std::span<const std::span<const Vec3f>> frames, const Progress &progress)
{
    std::vector<std::size_t> bad(frames.size(), AllFinite);
    parallelFor(frames.size(), [&](std::size_t f) {
        if (!progress.isCancelled())
            bad[f] = firstNonFinite(frames[f]);
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    for (std::size_t f = 0; f < frames.size(); ++f)
        if (bad[f] != AllFinite)
            return fail(ErrorCode::NonFinite, "vertex " + std::to_string(bad[f]) + " of frame " + std::to_string(f));
    return {};
}

} // namespace

Result<FrameStack> FrameStack::gather(const FrameSource &source, const Progress &progress)
{
    FrameStack stack;
    stack.mVertexCount = source.vertexCount();
    const std::size_t vertices = stack.mVertexCount;
    stack.mFrames.resize(source.frameCount());
    if (const auto *sequence = dynamic_cast<const Sequence *>(&source)) {
        for (std::uint32_t f = 0; f < source.frameCount(); ++f)
            stack.mFrames[f] = sequence->frameView(f);
    } else {
        stack.mOwn.resize(vertices * source.frameCount());
        std::atomic<std::size_t> done = 0;
        parallelFor(source.frameCount(), [&](std::size_t f) {
            if (progress.isCancelled())
                return;
            const std::span<Vec3f> frame(stack.mOwn.data() + f * vertices, vertices);
            source.positions(std::uint32_t(f), frame);
            stack.mFrames[f] = frame;
            progress.report(double(++done) / source.frameCount());
        });
    }
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    if (const auto finite = requireFinite(stack.mFrames, progress); !finite)
        return fail(finite.error());
    return stack;
}

FrameStack FrameStack::subset(std::span<const std::uint32_t> vertices) const
{
    FrameStack stack;
    stack.mVertexCount = std::uint32_t(vertices.size());
    stack.mFrames.resize(mFrames.size());
    stack.mOwn.resize(vertices.size() * mFrames.size());
    parallelFor(mFrames.size(), [&](std::size_t f) {
        const std::span<Vec3f> frame(stack.mOwn.data() + f * vertices.size(), vertices.size());
        for (std::size_t i = 0; i < vertices.size(); ++i)
            frame[i] = mFrames[f][vertices[i]];
        stack.mFrames[f] = frame;
    });
    return stack;
}

std::vector<double> FrameStack::rowMeans() const
{
    std::vector<double> means(rowCount());
    parallelFor(mFrames.size(), [&](std::size_t f) {
        double x = 0, y = 0, z = 0;
        for (const Vec3f p : mFrames[f]) {
            x += double(p.x);
            y += double(p.y);
            z += double(p.z);
        }
        means[3 * f] = x / mVertexCount;
        means[3 * f + 1] = y / mVertexCount;
        means[3 * f + 2] = z / mVertexCount;
    });
    return means;
}

double FrameStack::centredEnergy() const
{
    const std::vector<double> means = rowMeans();
    std::vector<double> sums(mFrames.size());
    parallelFor(mFrames.size(), [&](std::size_t f) {
        for (const Vec3f p : mFrames[f]) {
            const double x = double(p.x) - means[3 * f];
            const double y = double(p.y) - means[3 * f + 1];
            const double z = double(p.z) - means[3 * f + 2];
            sums[f] += x * x + y * y + z * z;
        }
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

double kgErrorOf(double squaredError, double energy)
{
    return 100 * std::sqrt(std::max(squaredError, 0.0)) / (energy > 0 ? std::sqrt(energy) : 1);
}

void FrameStack::centredVertices(std::span<const double> means, std::size_t first, std::size_t count, float *out,
                                 std::size_t stride) const
{
    for (std::size_t f = 0; f < mFrames.size(); ++f) {
        const Vec3f *p = mFrames[f].data() + first;
        const double mx = means[3 * f], my = means[3 * f + 1], mz = means[3 * f + 2];
        float *x = out + 3 * f * stride;
        float *y = x + stride;
        float *z = y + stride;
        // In double: far from the origin the difference of two floats would lose what is left.
        for (std::size_t i = 0; i < count; ++i) {
            x[i] = float(double(p[i].x) - mx);
            y[i] = float(double(p[i].y) - my);
            z[i] = float(double(p[i].z) - mz);
        }
    }
}

void FrameStack::centredFrames(std::span<const double> means, std::size_t first, std::size_t count, float *out,
                               std::size_t stride) const
{
    for (std::size_t f = first; f < first + count; ++f) {
        float *column = out + 3 * (f - first);
        for (std::size_t v = 0; v < mVertexCount; ++v) {
            const Vec3f p = mFrames[f][v];
            column[v * stride] = float(double(p.x) - means[3 * f]);
            column[v * stride + 1] = float(double(p.y) - means[3 * f + 1]);
            column[v * stride + 2] = float(double(p.z) - means[3 * f + 2]);
        }
    }
}

} // namespace model::codec
