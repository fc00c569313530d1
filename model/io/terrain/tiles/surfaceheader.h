// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"
#include "model/terrain/tin/tinarrays.h"

#include <span>
#include <vector>

namespace model::io {

/// Vertices of a tile as we write it: a tile's arrays fit into the processor's second cache.
inline constexpr std::uint32_t TileVertices = 1 << 14;
/// And the most that a reader takes.
inline constexpr std::uint32_t MaxTileVertices = 1 << 20;
inline constexpr std::uint32_t MaxTileTriangles = 8 * MaxTileVertices;
inline constexpr std::uint32_t MaxSurfaceVertices = (std::uint32_t(1) << 28) - 1;
/// The corners of the domain come first and belong to no tile.
inline constexpr std::uint32_t DomainCorners = 4;

/// What a surface begins with. FORMAT.md, 4.
struct SurfaceHeader
{
    terrain::Rectangle domain;
    double cornerHeights[DomainCorners] = {};
    terrain::LayerTable layers;
    terrain::LayerSample cornerSamples[DomainCorners][terrain::MaxLayers];
    std::uint64_t vertices = DomainCorners; ///< those of the domain's corners included
    std::uint64_t triangles = 0;
    std::uint64_t tiles = 0;
};

struct TileHeader
{
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::uint64_t bytes = 0;
};

/// How the first of the tile's vertices and triangles are numbered in the file.
struct TilePlace
{
    std::uint32_t firstVertex = DomainCorners;
    std::uint32_t firstTriangle = 0;
};

void writeHeader(ByteWriter &out, const SurfaceHeader &header, std::span<const TileHeader> tiles);
/// \returns false after an error; `in` has it
bool readHeader(ByteReader &in, SurfaceHeader &header, std::vector<TileHeader> &tiles);

} // namespace model::io
