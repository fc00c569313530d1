// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace views {

inline constexpr int GrainSide = 256; ///< texels

/// A tile of sand that joins itself on all sides, GrainSide x GrainSide x 4 bytes: the slope in x and y and the height
/// of its grains (x 127 + 128), and a random number for each texel. The same on every machine.
std::vector<std::uint8_t> makeGrains();

} // namespace views
