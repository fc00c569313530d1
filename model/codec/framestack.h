// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/base/error.h"
#include "model/base/progress.h"

#include <span>
#include <vector>

namespace model::codec {

/// All frames of a source at hand, and the matrix S of FORMAT.md 5 made of them: 3F rows (x, y, z of frame 0, of
/// frame 1, ...), one column for each vertex. A Sequence is looked into, any other source is copied.
class FrameStack
{
public:
    /// Keeps a view of `source`. \error NonFinite, OutOfMemory, Cancelled
    static Result<FrameStack> gather(const FrameSource &source, const Progress &progress);

    /// A copy of some of the vertices, in this order.
    FrameStack subset(std::span<const std::uint32_t> vertices) const;

    std::uint32_t frameCount() const { return std::uint32_t(mFrames.size()); }
    std::uint32_t vertexCount() const { return mVertexCount; }
    std::size_t rowCount() const { return 3 * mFrames.size(); }
    std::span<const Vec3f> frame(std::size_t index) const { return mFrames[index]; }

    /// The mean of each row.
    std::vector<double> rowMeans() const;
    /// Sum of the squares of S minus its row means.
    double centredEnergy() const;

    /// Columns first ... first+count-1 of S minus `means`: out is rowCount() x count, rows `stride` floats apart.
    void centredVertices(std::span<const double> means, std::size_t first, std::size_t count, float *out,
                         std::size_t stride) const;
    /// The transpose of the rows of some frames: out is vertexCount() x 3*count, rows `stride` floats apart.
    void centredFrames(std::span<const double> means, std::size_t first, std::size_t count, float *out,
                       std::size_t stride) const;

private:
    std::vector<std::span<const Vec3f>> mFrames;
    std::vector<Vec3f> mOwn;
    std::uint32_t mVertexCount = 0;
};

/// The error of Karni and Gotsman, per cent (model/animation/metrics.h). \param energy  FrameStack::centredEnergy()
double kgErrorOf(double squaredError, double energy);

} // namespace model::codec
