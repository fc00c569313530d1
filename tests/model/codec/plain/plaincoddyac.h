// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tests {

/// A `coddyac` animation by a second, plain decoder that was written from model/codec/FORMAT.md 12, 14, 15 alone.
struct PlainCoddyac
{
    std::string error; ///< empty if all went well
    std::uint64_t vertices = 0, frames = 0;
    std::vector<std::array<std::int64_t, 3>> triangles;
    std::vector<double> means;                     ///< #F x 3
    std::vector<std::vector<double>> basis;        ///< #K x 3F
    std::vector<std::vector<double>> coefficients; ///< #K x V

    double coordinate(std::uint64_t frame, std::uint64_t vertex, unsigned axis) const;
    /// |mean| and the magnitudes of the products: what rounding is relative to.
    double size(std::uint64_t frame, std::uint64_t vertex, unsigned axis) const;
};

PlainCoddyac decodeCoddyacPlainly(const std::vector<std::uint8_t> &file);

} // namespace tests
