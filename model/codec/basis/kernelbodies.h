// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The bodies of Kernels. Each source that includes this file is compiled for another processor; everything here has
// internal linkage, and Eigen is renamed for all but one of them, so that the linker cannot mix their code.
#include "model/codec/basis/kernels.h"

#include <Eigen/Core>

#include <cstring>

namespace model::codec {
namespace {

using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using DoubleMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Rows = Eigen::Map<const Matrix, 0, Eigen::OuterStride<>>;

void gramTileBody(const float *a, std::size_t rowsA, const float *b, std::size_t rowsB, std::size_t depth,
                  std::size_t stride, double *sums, std::size_t sumStride)
{
    // In double: with float products, components below some 1e-4 of the strongest drown in rounding.
    constexpr std::size_t BlockDepth = 256;
    DoubleMatrix left, right, part(rowsA, rowsB);
    for (std::size_t d = 0; d < depth; d += BlockDepth) {
        const std::size_t count = depth - d < BlockDepth ? depth - d : BlockDepth;
        const auto load = [&](DoubleMatrix &into, const float *rows, std::size_t rowCount) {
            const Rows block(rows + d, Eigen::Index(rowCount), Eigen::Index(count),
                             Eigen::OuterStride<>(Eigen::Index(stride)));
            into = block.cast<double>();
        };
        load(left, a, rowsA);
        load(right, b, rowsB);
        part.noalias() = left * right.transpose();
        for (std::size_t i = 0; i < rowsA; ++i)
            for (std::size_t j = 0; j < rowsB; ++j)
                sums[i * sumStride + j] += part(Eigen::Index(i), Eigen::Index(j));
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

#ifdef __AVX2__
constexpr std::size_t Lanes = 8;
#else
constexpr std::size_t Lanes = 4;
#endif
// A vector register: with plain arrays GCC keeps the sums in memory, which takes three times as long.
typedef float Packed __attribute__((vector_size(Lanes * sizeof(float))));
constexpr std::size_t PackedPerTile = TileVertices / Lanes;

void reconstructBody(const float *tiles, std::size_t rank, const float *basis, const float *mean,
                     std::size_t vertexCount, float *out)
{
    for (std::size_t first = 0; first < vertexCount; first += TileVertices) {
        Packed sums[3][PackedPerTile];
        for (int axis = 0; axis < 3; ++axis)
            for (std::size_t i = 0; i < PackedPerTile; ++i)
                sums[axis][i] = Packed{} + mean[3 + axis];
        for (std::size_t k = 0; k < rank; ++k, tiles += TileVertices) {
            Packed coefficients[PackedPerTile];
            std::memcpy(coefficients, tiles, sizeof coefficients);
            for (int axis = 0; axis < 3; ++axis)
                for (std::size_t i = 0; i < PackedPerTile; ++i)
                    sums[axis][i] += basis[std::size_t(axis) * rank + k] * coefficients[i];
        }
        float lanes[3][TileVertices];
        for (int axis = 0; axis < 3; ++axis)
            for (std::size_t i = 0; i < PackedPerTile; ++i) {
                const Packed position = sums[axis][i] + mean[axis];
                std::memcpy(lanes[axis] + i * Lanes, &position, sizeof position);
            }
        const std::size_t count = vertexCount - first < TileVertices ? vertexCount - first : TileVertices;
        for (std::size_t i = 0; i < count; ++i)
            for (int axis = 0; axis < 3; ++axis)
                out[3 * (first + i) + std::size_t(axis)] = lanes[axis][i];
    }
}

typedef double PackedDouble __attribute__((vector_size(Lanes * sizeof(float))));
constexpr std::size_t PackedPerColumn = PanelRows * sizeof(double) / sizeof(PackedDouble);

void rotateColumnsBody(double *columns, const PlaneRotation *rotations, std::size_t count)
{
    PackedDouble carried[PackedPerColumn]; // a column stays in registers between its two rotations
    std::memcpy(carried, columns, sizeof carried);
    for (std::size_t k = 0; k < count; ++k, columns += PanelRows) {
        const double c = rotations[k].cosine, s = rotations[k].sine;
        for (std::size_t i = 0; i < PackedPerColumn; ++i) {
            PackedDouble next;
            std::memcpy(&next, columns + PanelRows + i * Lanes / 2, sizeof next);
            const PackedDouble done = c * carried[i] - s * next;
            carried[i] = s * carried[i] + c * next;
            std::memcpy(columns + i * Lanes / 2, &done, sizeof done);
        }
    }
    std::memcpy(columns, carried, sizeof carried);
}

} // namespace
} // namespace model::codec
