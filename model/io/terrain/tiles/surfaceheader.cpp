// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/tiles/surfaceheader.h"

namespace model::io {

using namespace terrain;

void writeHeader(ByteWriter &out, const SurfaceHeader &header, std::span<const TileHeader> tiles)
{
    for (const double value : {header.domain.low.x, header.domain.low.y, header.domain.high.x, header.domain.high.y})
        out.f64(value);
    for (const double height : header.cornerHeights)
        out.f64(height);
    out.u8(std::uint8_t(header.layers.count));
    for (std::uint32_t l = 0; l < header.layers.count; ++l)
        out.u8(header.layers.materials[l]);
    for (const auto &samples : header.cornerSamples)
        for (std::uint32_t l = 0; l < header.layers.count; ++l) {
            out.f64(samples[l].thickness);
            out.f32(samples[l].humidity);
        }
    out.varUint(header.vertices);
    out.varUint(header.triangles);
    out.varUint(header.tiles);
    for (const TileHeader &tile : tiles) {
        out.varUint(tile.vertices);
        out.varUint(tile.triangles);
        out.varUint(tile.bytes);
    }
}

bool readHeader(ByteReader &in, SurfaceHeader &header, std::vector<TileHeader> &tiles)
{
    for (double *const value :
         {&header.domain.low.x, &header.domain.low.y, &header.domain.high.x, &header.domain.high.y})
        *value = in.f64();
    for (double &height : header.cornerHeights)
        height = in.f64();
    header.layers.count = in.u8();
    if (!in.require(header.layers.count <= MaxLayers, "layer count", header.layers.count, "at most 12"))
        return false;
    for (std::uint32_t l = 0; l < header.layers.count; ++l)
        header.layers.materials[l] = in.u8();
    for (auto &samples : header.cornerSamples)
        for (std::uint32_t l = 0; l < header.layers.count; ++l) {
            samples[l].thickness = in.f64();
            samples[l].humidity = in.f32();
        }
    header.vertices = in.varUint();
    header.triangles = in.varUint();
    header.tiles = in.varUint();
    if (!in.require(header.vertices >= DomainCorners && header.vertices <= MaxSurfaceVertices, "vertex count",
                    header.vertices, "4 ... 268435455") ||
        !in.require(header.triangles >= 2 && header.triangles <= 2 * std::uint64_t(MaxSurfaceVertices),
                    "triangle count", header.triangles, "2 ... 536870910") ||
        !in.require(header.tiles >= 1 && header.tiles <= in.left(), "tile count", header.tiles,
                    "at most the bytes left"))
        return false;
    std::uint64_t vertices = DomainCorners, triangles = 0, bytes = 0;
    tiles.resize(std::size_t(header.tiles));
    for (TileHeader &tile : tiles) {
        tile.vertices = in.varUint();
        tile.triangles = in.varUint();
        tile.bytes = in.varUint();
        if (!in.require(tile.vertices <= MaxTileVertices, "vertex count", tile.vertices, "at most 1048576") ||
            !in.require(tile.triangles <= MaxTileTriangles, "triangle count", tile.triangles, "at most 8388608") ||
            !in.require(tile.bytes <= in.left(), "tile size", tile.bytes, "at most the bytes left"))
            return false;
        vertices += tile.vertices;
        triangles += tile.triangles;
        bytes += tile.bytes;
    }
    return in.require(vertices == header.vertices, "vertex count", header.vertices, "the sum of the tiles'") &&
           in.require(triangles == header.triangles, "triangle count", header.triangles, "the sum of the tiles'") &&
           in.require(bytes == in.left(), "tile size", bytes, "all of the bytes left");
}

} // namespace model::io
