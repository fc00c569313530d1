// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/codec/connectivity/connectivitystage.h"
#include "model/codec/entropy/bandstage.h"

namespace model::codec {

/// What a vertex' coefficient is taken to be, from those of the vertices before it: the fourth corner of the
/// parallelogram that its neighbours span, the next point of a straight border, or what the vertex before it has.
inline std::int64_t predictedByNeighbours(std::span<const std::int32_t> values, std::uint32_t vertex,
                                          const VertexNeighbours &n) // FORMAT.md 14.3
{
    if (n.isNone())
        return vertex == 0 ? 0 : values[vertex - 1];
    return std::int64_t(values[n.left]) + values[n.right] - values[n.opposite];
}

/// Coefficients of vertices in the coded order, band after band, without loss. FORMAT.md 14.3.
/// \param values      #rank x #V, each at most MaxBandValue in magnitude
/// \param neighbours  #V
/// \error Cancelled
Result<Bytes> encodeByParallelograms(std::size_t rank, std::span<const std::int32_t> values,
                                     std::span<const VertexNeighbours> neighbours, const Progress &progress);

/// The inverse. \param row  called for each band in turn
/// \error CorruptStream, Cancelled
Result<void> decodeByParallelograms(const Chunk &chunk, std::size_t rank, std::span<const VertexNeighbours> neighbours,
                                    const Progress &progress,
                                    const std::function<void(std::uint32_t, std::span<const std::int32_t>)> &row);

} // namespace model::codec
