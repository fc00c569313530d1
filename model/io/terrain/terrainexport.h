// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/terrain/rasters/raster.h"

namespace model::io {

enum class TerrainFormat : std::uint8_t { Obj, Ply, Stl, AsciiGrid, GeoTiff, Png16, Contours };

struct TerrainExportOptions
{
    /// Meshes in world coordinates: precise in OBJ and PLY, which have 64 bits for them; STL has 32 and is always
    /// local. Rasters and contours are always in the world.
    bool isWorld = false;
    double cell = 0; ///< of a raster; 0: as the raster that the terrain came from, or 1024 cells along the longer side
    double interval = 10; ///< of contours
};

/// What was written, for people and scripts.
struct ExportedTerrain
{
    std::uint64_t vertices = 0, triangles = 0; ///< of a mesh
    std::uint32_t columns = 0, rows = 0;       ///< of a raster
    std::uint64_t lines = 0;                   ///< contours
    PngScale scale;                            ///< of a PNG
};

/// By the ending: obj, ply, stl, asc, tif, tiff, png, geojson, json.
std::optional<TerrainFormat> terrainFormatOf(const QString &path);
/// Those endings, without dot.
QStringList terrainExportEndings();

/// Writes a terrain for other programs, through SaveFile. Voids are left out of meshes and contours. Contours are
/// GeoJSON lines with an `elevation`, in the terrain's own coordinate system. \param step  of the raster that the
/// terrain came from, or 0 \error as rasterOf(), writeRaster(), contoursOf(); CannotOpen, CannotWrite; Cancelled
Result<ExportedTerrain> exportTerrain(const QString &path, TerrainFormat format, const terrain::Terrain &terrain,
                                      terrain::Point2 step, const TerrainExportOptions &options,
                                      const Progress &progress = Progress());

} // namespace model::io
