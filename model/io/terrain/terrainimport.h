// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/terrain/rasters/rawraster.h"

namespace model::io {

enum class UpAxis : std::uint8_t { Z, Y };

struct TerrainImportOptions
{
    double maxError = 0; ///< vertical; at least 0: then every sample is a vertex unless its neighbours make it so
    RasterOptions raster;
    RawLayout raw; ///< of a .raw file
    UpAxis up = UpAxis::Z;
    std::string crs; ///< WKT or a code such as EPSG:5514, for files that have none; empty: unknown
};

/// A terrain from somebody else's file, and what was in that.
struct ImportedTerrain
{
    terrain::Terrain terrain;
    terrain::Point2 step;         ///< of a raster; 0 for points and meshes
    std::uint64_t samples = 0;    ///< heights in the file
    std::uint64_t voids = 0;      ///< samples that are void
    std::uint64_t duplicates = 0; ///< points at the place of an earlier one, which counts
};

/// Reads elevation models as readRaster() and parseRaw() do, points (.xyz, .txt, .csv, .pts), and meshes (.obj, .ply,
/// .stl) that have one height at each place. Local coordinates begin at the source's most south-western sample.
/// No sample is farther than `maxError` from the terrain; a mesh is nowhere farther from it.
/// \error as those; UnknownFormat, NotASurface; BadSetting (the crs)
Result<ImportedTerrain> importTerrain(const QString &path, const TerrainImportOptions &options,
                                      const Progress &progress = Progress());

/// Endings of all that importTerrain() reads, without dot.
QStringList terrainEndings();

/// A coordinate reference system as WKT. \error BadSetting
Result<std::string> wktOfCrs(const std::string &crs);

} // namespace model::io
