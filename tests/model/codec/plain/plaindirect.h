// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tests {

/// The frames of a `direct` animation by a second, plain decoder that was written from model/codec/FORMAT.md 11 alone.
struct PlainDirect
{
    std::string error;                                            ///< empty if all went well
    std::vector<std::vector<std::array<std::int64_t, 3>>> frames; ///< coordinates in cells
    double cell = 0;
    std::array<double, 3> origin{};
};

PlainDirect decodeDirectPlainly(const std::vector<std::uint8_t> &file);

} // namespace tests
