// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/terrain/tiles/packing.h"

#include <array>

namespace model::io {

/// What is known of a vertex of a tile before its coordinates: the edge a-b over which it was found, and the vertex o
/// on the other side. Numbers in the tile's own vertices; NoVertex where that vertex is another tile's or there is
/// none.
struct TileContext
{
    static constexpr std::uint32_t NoVertex = ~std::uint32_t(0);
    std::uint32_t a = NoVertex, b = NoVertex, o = NoVertex;
};

// Predictions look at vertices before the predicted one alone. FORMAT.md, 5.3.

/// Of one coordinate of vertex `i`: as if a-b-o were one half of a parallelogram.
inline std::int64_t predictAcross(std::span<const std::int32_t> done, std::size_t i, const TileContext &context)
{
    const auto at = [&](std::uint32_t v) { return std::int64_t(done[v]); };
    const bool hasA = context.a != TileContext::NoVertex, hasB = context.b != TileContext::NoVertex;
    if (hasA && hasB && context.o != TileContext::NoVertex)
        return at(context.a) + at(context.b) - at(context.o);
    if (hasA && hasB)
        return (at(context.a) + at(context.b)) >> 1;
    if (hasA || hasB)
        return at(hasA ? context.a : context.b);
    return i > 0 ? done[i - 1] : 0;
}

/// The mean of a and b.
inline std::int64_t predictMean(std::span<const std::int32_t> done, std::size_t i, TileContext context)
{
    context.o = TileContext::NoVertex;
    return predictAcross(done, i, context);
}

/// The bits of a float: those at a, else at b, else those before.
inline std::uint32_t predictBits(std::span<const std::uint32_t> done, std::size_t i, const TileContext &context)
{
    if (context.a != TileContext::NoVertex)
        return done[context.a];
    if (context.b != TileContext::NoVertex)
        return done[context.b];
    return i > 0 ? done[i - 1] : 0;
}

/// The height of the plane through a, b and o; the mean of a and b where that plane says nothing about the vertex.
std::int64_t predictOnPlane(std::span<const std::int32_t> x, std::span<const std::int32_t> y,
                            std::span<const std::int32_t> done, std::size_t i, const TileContext &context);

enum class HeightPrediction : std::uint8_t { Mean, Plane };

inline std::int64_t predictHeight(HeightPrediction kind, std::span<const std::int32_t> x,
                                  std::span<const std::int32_t> y, std::span<const std::int32_t> done, std::size_t i,
                                  const TileContext &context)
{
    return kind == HeightPrediction::Mean ? predictMean(done, i, context) : predictOnPlane(x, y, done, i, context);
}

/// The multiples less what is predicted of each from those before it.
template <class Predict>
void writePredicted(ByteWriter &out, const FixedPoint &numbers, Predict predict)
{
    std::vector<std::uint32_t> residuals(numbers.multiples.size());
    for (std::size_t i = 0; i < residuals.size(); ++i)
        residuals[i] = zigzag(std::int32_t(std::uint32_t(numbers.multiples[i]) - std::uint32_t(predict(i))));
    writeWords(out, residuals);
}
template <class Predict>
bool readPredicted(ByteReader &in, std::size_t count, FixedPoint &numbers, Predict predict)
{
    std::vector<std::uint32_t> residuals;
    if (!readWords(in, count, residuals))
        return false;
    numbers.multiples.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        numbers.multiples[i] = std::int32_t(std::uint32_t(unzigzag(residuals[i])) + std::uint32_t(predict(i)));
    return true;
}

} // namespace model::io
