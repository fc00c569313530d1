// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace model::codec {

/// Vertices of a tile: the coefficients lie as [tile][k][vertex in tile], so that one pass reads them in order.
inline constexpr std::size_t TileVertices = 16;

/// Rows of a panel that plane rotations are applied to.
inline constexpr std::size_t PanelRows = 16;

/// (a, b) becomes (cosine a - sine b, sine a + cosine b).
struct PlaneRotation
{
    double cosine;
    double sine;
};

/// The inner loops, compiled once for any processor and once for those with AVX2 and FMA. Results of the two differ by
/// float rounding.
struct Kernels
{
    const char *name;

    /// sums += a b^T over `depth` columns; products and sums in double.
    /// \param a, b   rowsA, rowsB x depth, rows `stride` floats apart
    /// \param sums   rowsA x rowsB, rows `sumStride` doubles apart; rowsA, rowsB at most MaxGramTile
    void (*gramTile)(const float *a, std::size_t rowsA, const float *b, std::size_t rowsB, std::size_t depth,
                     std::size_t stride, double *sums, std::size_t sumStride);

    /// out = m x: the coefficients of some vertices.
    /// \param m    rows x inner, without gaps
    /// \param x    inner x columns, rows `stride` floats apart
    /// \param out  rows x columns, rows `outStride` floats apart
    void (*multiply)(const float *m, std::size_t rows, std::size_t inner, const float *x, std::size_t stride,
                     std::size_t columns, float *out, std::size_t outStride);

    /// The positions of one frame: mean + sum over k of basis x coefficient.
    /// \param tiles  coefficients as above
    /// \param basis  3 x rank: all of x, all of y, all of z
    /// \param mean   x, y, z, then what rounding them to float took away: far from the origin that is not little
    /// \param out    vertexCount x 3
    void (*reconstruct)(const float *tiles, std::size_t rank, const float *basis, const float *mean,
                        std::size_t vertexCount, float *out);

    /// Rotates columns 0 and 1, then 1 and 2, and so on.
    /// \param columns  PanelRows x (count + 1), one column after another
    void (*rotateColumns)(double *columns, const PlaneRotation *rotations, std::size_t count);
};

inline constexpr std::size_t MaxGramTile = 128;

/// The best ones for this processor.
const Kernels &kernels();
/// Those for any processor: the reference in tests.
const Kernels &portableKernels();

} // namespace model::codec
