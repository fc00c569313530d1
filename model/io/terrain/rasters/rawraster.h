// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/terrain/rasters/raster.h"

namespace model::io {

enum class RawType : std::uint8_t { Uint8, Uint16, Int16, Uint32, Float32, Float64 };

/// What a file of bare numbers is, which says nothing of itself: rows from the north, each from the west.
struct RawLayout
{
    std::uint32_t columns = 0, rows = 0;
    RawType type = RawType::Uint16;
    bool isBigEndian = false;
};

/// \error BadSetting (a size of nothing); Truncated, TrailingBytes: the size does not fit the file; LimitExceeded
Result<Raster> parseRaw(std::span<const std::uint8_t> bytes, const RawLayout &layout, const RasterOptions &options);

} // namespace model::io
