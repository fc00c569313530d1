// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tests {

/// An `.anim` decoded by a second, plain decoder that was written from model/codec/FORMAT.md alone and shares no code
/// with the product: if the two agree, the document is right.
struct PlainAnim
{
    std::string error; ///< empty if all went well
    std::string creator, name;
    double rate = 0, resolution = 0;
    std::uint64_t vertices = 0, triangleCount = 0, frames = 0, rank = 0, wanted = 0;
    std::vector<std::array<std::int64_t, 3>> triangles;
    std::vector<std::int64_t> means;
    std::vector<std::vector<std::int64_t>> basis, coefficients;

    /// FORMAT.md 5.4, in double.
    double coordinate(std::uint64_t frame, std::uint64_t vertex, unsigned axis) const;
};

PlainAnim decodePlainly(const std::vector<std::uint8_t> &file);

/// FORMAT.md 5.1: the chunk of the triangles. Throws a std::string.
std::vector<std::array<std::int64_t, 3>> plainTriangles(const std::vector<std::uint8_t> &payload, std::uint64_t count);

} // namespace tests
