// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The bodies of Kernels. Each source that includes this file is compiled for another processor; everything here has
// internal linkage, and Eigen is renamed for all but one of them, so that the linker cannot mix their code.
#include "model/codec/kernels.h"

#include <Eigen/Core>

namespace model::codec {
namespace {

using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Rows = Eigen::Map<const Matrix, 0, Eigen::OuterStride<>>;

void gramTileBody(const float *a, std::size_t rowsA, const float *b, std::size_t rowsB, std::size_t depth,
                  std::size_t stride, double *sums, std::size_t sumStride)
{
    constexpr std::size_t FloatDepth = 512;
    Matrix part(rowsA, rowsB);
    for (std::size_t d = 0; d < depth; d += FloatDepth) {
        const std::size_t count = depth - d < FloatDepth ? depth - d : FloatDepth;
        const Rows left(a + d, Eigen::Index(rowsA), Eigen::Index(count), Eigen::OuterStride<>(Eigen::Index(stride)));
        const Rows right(b + d, Eigen::Index(rowsB), Eigen::Index(count), Eigen::OuterStride<>(Eigen::Index(stride)));
        part.noalias() = left * right.transpose();
        for (std::size_t i = 0; i < rowsA; ++i)
            for (std::size_t j = 0; j < rowsB; ++j)
                sums[i * sumStride + j] += double(part(Eigen::Index(i), Eigen::Index(j)));
    }
}

void multiplyBody(const float *m, std::size_t rows, std::size_t inner, const float *x, std::size_t stride,
                  std::size_t columns, float *out, std::size_t outStride)
{
    const Rows left(m, Eigen::Index(rows), Eigen::Index(inner), Eigen::OuterStride<>(Eigen::Index(inner)));
    const Rows right(x, Eigen::Index(inner), Eigen::Index(columns), Eigen::OuterStride<>(Eigen::Index(stride)));
    Eigen::Map<Matrix, 0, Eigen::OuterStride<>> result(out, Eigen::Index(rows), Eigen::Index(columns),
                                                       Eigen::OuterStride<>(Eigen::Index(outStride)));
    result.noalias() = left * right;
}

void reconstructBody(const float *tiles, std::size_t rank, const float *basis, const float *mean,
                     std::size_t vertexCount, float *out)
{
    for (std::size_t first = 0; first < vertexCount; first += TileVertices, tiles += rank * TileVertices) {
        float x[TileVertices], y[TileVertices], z[TileVertices];
        for (std::size_t i = 0; i < TileVertices; ++i) {
            x[i] = mean[3];
            y[i] = mean[4];
            z[i] = mean[5];
        }
        for (std::size_t k = 0; k < rank; ++k) {
            const float *c = tiles + k * TileVertices;
            const float bx = basis[k], by = basis[rank + k], bz = basis[2 * rank + k];
            for (std::size_t i = 0; i < TileVertices; ++i) {
                x[i] += bx * c[i];
                y[i] += by * c[i];
                z[i] += bz * c[i];
            }
        }
        const std::size_t count = vertexCount - first < TileVertices ? vertexCount - first : TileVertices;
        for (std::size_t i = 0; i < count; ++i) {
            out[3 * (first + i)] = mean[0] + x[i];
            out[3 * (first + i) + 1] = mean[1] + y[i];
            out[3 * (first + i) + 2] = mean[2] + z[i];
        }
    }
}

} // namespace
} // namespace model::codec
