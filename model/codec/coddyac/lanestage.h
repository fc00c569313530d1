// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/codec/container/container.h"

#include <functional>

namespace model::codec {

/// Trajectories, each x y z of frame after frame: a value is predicted from the two before it in time, 2 c1 - c2.
/// Without loss. FORMAT.md 14.2.
/// \param values  #rows x #columns; each at most MaxLaneValue in magnitude
Bytes encodeLanes(std::size_t columns, std::span<const std::int64_t> values);

/// The inverse. \param row  called for each row in turn
/// \error CorruptStream{stage}, Cancelled
Result<void> decodeLanes(const Chunk &chunk, std::size_t rows, std::size_t columns, std::string_view stage,
                         const Progress &progress,
                         const std::function<void(std::size_t, std::span<const std::int64_t>)> &row);

/// Every integer up to it is exact as a double.
inline constexpr std::int64_t MaxLaneValue = std::int64_t(1) << 53;

} // namespace model::codec
