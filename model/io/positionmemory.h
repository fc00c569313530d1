// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/geometry/vec.h"

#include <cstdint>
#include <vector>

namespace model::io {

/// The most positions of one animation, in bytes: more would not fit into the memory of the machines that we know.
constexpr std::uint64_t MaxPositionBytes = std::uint64_t(32) << 30;

/// Memory for all positions of an animation. \error LimitExceeded, OutOfMemory
Result<std::vector<Vec3f>> positionMemory(std::uint64_t vertexCount, std::uint64_t frameCount);

} // namespace model::io
