// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/codec/container/container.h"

#include <functional>

namespace model::codec {

/// Largest magnitude of a value in a band: differences still fit 32 bits.
inline constexpr std::int32_t MaxBandValue = (1 << 30) - 1;
/// Largest magnitude of a mean: every integer up to it is exact as a double.
inline constexpr std::int64_t MaxMeanValue = std::int64_t(1) << 53;

/// Integers in rows ("bands": the basis trajectories, or one coefficient of all vertices), each of which predicts a
/// value from the one `stride` before it in its row. Without loss. FORMAT.md 5.3.
struct Bands
{
    std::uint32_t rows = 0;
    std::uint32_t columns = 0;
    std::uint32_t stride = 1;
};

/// \param values  #rows x #columns, each at most MaxBandValue in magnitude
/// \error Cancelled
Result<Bytes> encodeBands(const Bands &shape, std::span<const std::int32_t> values, const Progress &progress);

/// The inverse. \param row  called once for each row, from several threads at once
/// \error Truncated, TrailingBytes, BadValue, CorruptStream{stage}, Cancelled
Result<void> decodeBands(const Chunk &chunk, const Bands &shape, std::string_view stage, const Progress &progress,
                         const std::function<void(std::uint32_t, std::span<const std::int32_t>)> &row);

/// The mean vertex of each frame, x y z: predicted from the frame before. Without loss. FORMAT.md 5.2.
/// \param values  each at most MaxMeanValue in magnitude
Bytes encodeMeans(std::span<const std::int64_t> values);
/// \error CorruptStream
Result<std::vector<std::int64_t>> decodeMeans(const Chunk &chunk, std::size_t count);

} // namespace model::codec
