// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/rasters/rawraster.h"

#include <bit>

namespace model::io {

namespace {

std::size_t sizeOf(RawType type)
{
    switch (type) {
    case RawType::Uint8:
        return 1;
    case RawType::Uint16:
    case RawType::Int16:
        return 2;
    case RawType::Uint32:
    case RawType::Float32:
        return 4;
    case RawType::Float64:
        return 8;
    }
    return 1;
}

double valueOf(std::uint64_t bits, RawType type)
{
    switch (type) {
    case RawType::Int16:
        return std::int16_t(bits);
    case RawType::Float32:
        return std::bit_cast<float>(std::uint32_t(bits));
    case RawType::Float64:
        return std::bit_cast<double>(bits);
    default:
        return double(bits);
    }
}

} // namespace

Result<Raster> parseRaw(std::span<const std::uint8_t> bytes, const RawLayout &layout, const RasterOptions &options)
{
    if (layout.columns == 0 || layout.rows == 0)
        return fail(ErrorCode::BadSetting, "size", std::to_string(layout.columns) + "x" + std::to_string(layout.rows),
                    "COLUMNSxROWS");
    const std::size_t size = sizeOf(layout.type);
    const std::uint64_t wanted = std::uint64_t(layout.columns) * layout.rows;
    if (wanted > bytes.size() / size)
        return fail(ErrorCode::Truncated, std::to_string(wanted * size), std::to_string(bytes.size()));
    if (wanted * size < bytes.size())
        return fail(ErrorCode::TrailingBytes, std::to_string(bytes.size() - wanted * size));
    Raster raster;
    raster.grid = {layout.columns, layout.rows, options.cellSize, options.cellSize, {}};
    raster.grid.heights.resize(std::size_t(wanted));
    for (std::size_t i = 0; i < wanted; ++i) {
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < size; ++k)
            bits |= std::uint64_t(bytes[i * size + k]) << 8 * (layout.isBigEndian ? size - 1 - k : k);
        const double value = valueOf(bits, layout.type);
        const std::size_t row = layout.rows - 1 - i / layout.columns;
        const bool isVoid = !std::isfinite(value) || (options.noData && value == *options.noData);
        raster.grid.heights[row * layout.columns + i % layout.columns] =
            isVoid ? NAN : value * options.heightScale + options.heightOffset;
    }
    return raster;
}

} // namespace model::io
