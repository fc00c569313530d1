// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"
#include "model/base/progress.h"
#include "model/terrain/simplify/heightgrid.h"
#include "model/terrain/terrain.h"

#include <optional>

#include <QString>
#include <QStringList>

namespace model::io {

/// An elevation model on a grid: samples in the middle of a raster's cells, the most south-western one at the origin.
struct Raster
{
    terrain::HeightGrid grid;
    terrain::GeoReference geoReference; ///< the origin is that sample in the world
    std::string heightUnit;             ///< as the file says it; empty if it does not
};

struct RasterOptions
{
    std::optional<double> noData; ///< the value of void cells; not set: as the file says
    double cellSize = 1;          ///< of files that say nothing of it
    double heightScale = 1;       ///< heights are the file's times this ...
    double heightOffset = 0;      ///< ... plus this
    int band = 1;                 ///< counted from 1
};

/// Reads an elevation model: GeoTIFF, ESRI ASCII grid, 16-bit PNG and the other local raster formats of GDAL. Cells
/// that are NODATA, masked out or no number are void; an ASCII grid that does not say what NODATA is has -9999, as its
/// format says.
/// \error NotFound, CannotOpen; UnknownFormat; ImporterFailed: what GDAL says; UnsupportedFeature: a turned grid,
/// complex
///        numbers; BadValue: a band that is not there; LimitExceeded: more than half of the machine's memory; Cancelled
Result<Raster> readRaster(const QString &path, const RasterOptions &options, const Progress &progress = Progress());

/// Endings of the raster formats that people mostly have.
QStringList rasterEndings();

enum class RasterFormat : std::uint8_t { AsciiGrid, GeoTiff, Png16 };

/// What the numbers of a 16-bit picture mean: height = number * scale + offset; 0 is void if anything is.
struct PngScale
{
    double scale = 1, offset = 0;
};

/// Writes a raster through SaveFile. ASC: heights with as many digits as they need, square cells only; GeoTIFF: 64-bit
/// floats, compressed without loss; PNG: 65535 steps from the lowest height to the highest.
/// \param scale  of a PNG, if wanted
/// \error UnsupportedFeature (cells that are not square in an ASC), ImporterFailed, CannotOpen, CannotWrite, Cancelled
Result<void> writeRaster(const QString &path, const Raster &raster, RasterFormat format, PngScale *scale = nullptr,
                         const Progress &progress = Progress());

/// Heights of the terrain at the nodes of a grid of cells of `step` over its domain; NaN in voids.
/// \error LimitExceeded  more than half of the machine's memory; BadSetting: a step that the domain does not hold;
///        Cancelled
Result<Raster> rasterOf(const terrain::Terrain &terrain, terrain::Point2 step, const Progress &progress = Progress());

} // namespace model::io
