// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tests {

/// A `reel` animation by a second, plain decoder that was written from model/codec/FORMAT.md 12, 13, 15 alone.
struct PlainReel
{
    std::string error; ///< empty if all went well
    std::uint64_t vertices = 0, frames = 0, rank = 0;
    /// The largest effect of one step of anything, and of all magnitudes that are added up in a position: what errors
    /// of rounding are relative to.
    double step = 0, size = 0;
    std::vector<std::array<std::int64_t, 3>> triangles;
    std::vector<std::vector<std::array<double, 3>>> positions; ///< #F x #V
};

PlainReel decodeReelPlainly(const std::vector<std::uint8_t> &file);

} // namespace tests
