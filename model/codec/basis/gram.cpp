// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/basis/gram.h"

#include "model/base/parallel.h"
#include "model/codec/basis/kernels.h"

#include <algorithm>

namespace model::codec {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using RowMajorMatrixF = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Floats of a panel of S that are worked on at once: 16 MB, whatever the animation's size.
constexpr std::size_t PanelFloats = 1u << 22;
constexpr std::size_t MaxPanelColumns = 2048;
constexpr std::size_t BlockColumns = 256;
// Parts that the vertices are cut into then; each has a sum of its own, so that their order is fixed.
constexpr std::size_t ProductParts = 16;
constexpr std::size_t ProductColumns = 64;

std::size_t panelColumns(std::size_t rows)
{
    const std::size_t fitting = PanelFloats / rows / BlockColumns * BlockColumns;
    return std::clamp(fitting, BlockColumns, MaxPanelColumns);
}

} // namespace

Result<MatrixXd> gramMatrix(const FrameStack &frames, std::span<const double> means, const Progress &progress)
{
    const bool byVertices = frames.rowCount() <= frames.vertexCount();
    const std::size_t rows = byVertices ? frames.rowCount() : frames.vertexCount();
    const std::size_t columns = byVertices ? frames.vertexCount() : frames.frameCount(); // a frame is three columns
    const std::size_t step = byVertices ? panelColumns(rows) : std::max<std::size_t>(1, panelColumns(rows) / 3);
    const std::size_t stride = byVertices ? step : 3 * step;

    MatrixXd gram = MatrixXd::Zero(Index(rows), Index(rows));
    std::vector<float> panel(rows * stride);
    const std::size_t tiles = (rows + MaxGramTile - 1) / MaxGramTile;
    for (std::size_t first = 0; first < columns; first += step) {
        const std::size_t count = std::min(step, columns - first);
        const std::size_t depth = byVertices ? count : 3 * count;
        // Each thread fills a part of every row; then each tile is summed by one thread in a fixed order.
        parallelRanges(count, byVertices ? BlockColumns : 16, [&](std::size_t begin, std::size_t end) {
            if (progress.isCancelled())
                return;
            if (byVertices)
                frames.centredVertices(means, first + begin, end - begin, panel.data() + begin, stride);
            else
                frames.centredFrames(means, first + begin, end - begin, panel.data() + 3 * begin, stride);
        });
        parallelFor(tiles * tiles, [&](std::size_t tile) {
            const std::size_t i = tile / tiles * MaxGramTile;
            const std::size_t j = tile % tiles * MaxGramTile;
            if (j > i || progress.isCancelled())
                return;
            kernels().gramTile(panel.data() + i * stride, std::min(MaxGramTile, rows - i), panel.data() + j * stride,
                               std::min(MaxGramTile, rows - j), depth, stride, gram.data() + i * rows + j, rows);
        });
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        progress.report(double(first + count) / double(columns));
    }
    // What was filled is the lower triangle of a row-major matrix: Eigen's upper one.
    gram.triangularView<Eigen::StrictlyLower>() = gram.transpose();
    return gram;
}

void applyGram(const FrameStack &frames, std::span<const double> means, const Eigen::VectorXd &in, Eigen::VectorXd &out,
               const Progress &progress)
{
    const std::size_t vertices = frames.vertexCount();
    const std::size_t part = (vertices + ProductParts - 1) / ProductParts;
    std::vector<Eigen::VectorXd> sums(ProductParts, Eigen::VectorXd::Zero(in.size()));
    parallelFor(ProductParts, [&](std::size_t p) {
        RowMajorMatrixF panel(in.size(), Index(ProductColumns));
        MatrixXd columns;
        const std::size_t end = std::min(vertices, (p + 1) * part);
        for (std::size_t first = p * part; first < end && !progress.isCancelled(); first += ProductColumns) {
            const std::size_t width = std::min(ProductColumns, end - first);
            frames.centredVertices(means, first, width, panel.data(), ProductColumns);
            columns = panel.leftCols(Index(width)).cast<double>();
            const Eigen::VectorXd projections = columns.transpose() * in;
            sums[p].noalias() += columns * projections;
        }
    });
    out = Eigen::VectorXd::Zero(in.size());
    for (const Eigen::VectorXd &sum : sums)
        out += sum;
}

} // namespace model::codec
