// SPDX-License-Identifier: GPL-3.0-or-later
// GDAL stops at this file.
#include "model/io/terrain/rasters/raster.h"

#include "model/base/memory.h"
#include "model/base/numbertext.h"
#include "model/base/outofmemory.h"
#include "model/io/failure.h"
#include "model/io/filebuffer.h"
#include "model/io/savefile.h"
#include "model/io/terrain/terrainimport.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

namespace model::io {

namespace {

/// Formats of local files that hold their own data. What refers to other files or servers is left out: a terrain that
/// somebody sends must not open what it likes.
constexpr const char *Drivers[] = {"GTiff", "AAIGrid", "PNG",  "SRTMHGT", "DTED",           "USGSDEM", "EHdr",
                                   "ENVI",  "HFA",     "GSAG", "GSBG",    "GS7BG",          "BMP",     "PNM",
                                   "SAGA",  "RST",     "ERS",  "JPEG",    "GRASSASCIIGrid", "BT",      "TERRAGEN",
                                   "ISIS3", "PDS",     "NITF", nullptr};

void registerDrivers()
{
    static std::once_flag once;
    std::call_once(once, [] {
        GDALAllRegister();
        // No network, whatever a file says.
        CPLSetConfigOption("GDAL_HTTP_MAX_RETRY", "0");
        CPLSetConfigOption("CPL_VSIL_CURL_ALLOWED_EXTENSIONS", ".none");
    });
}

/// Collects what GDAL would print, for the thread's calls while it lives.
class Messages
{
public:
    Messages() { CPLPushErrorHandlerEx(&Messages::take, this); }
    Messages(const Messages &) = delete;
    Messages &operator=(const Messages &) = delete;
    ~Messages() { CPLPopErrorHandler(); }

    /// The first error; it is the one that says why.
    std::string text() const { return mFirst.empty() ? "no reason given" : mFirst; }

private:
    static void CPL_STDCALL take(CPLErr kind, CPLErrorNum, const char *message)
    {
        auto *const self = static_cast<Messages *>(CPLGetErrorHandlerUserData());
        if (kind >= CE_Failure && self->mFirst.empty())
            self->mFirst = message;
    }
    std::string mFirst;
};

struct CloseDataset
{
    void operator()(GDALDataset *dataset) const { GDALClose(dataset); }
};
using DatasetPtr = std::unique_ptr<GDALDataset, CloseDataset>;

tl::unexpected<Error> failGdal(const QString &path, const Messages &messages)
{
    return failIn(path, ErrorCode::ImporterFailed, messages.text());
}

std::uint64_t memoryLimit()
{
    const std::uint64_t memory = physicalMemory();
    return memory > 0 ? memory / 2 : std::uint64_t(4) << 30;
}

Result<void> checkSize(std::uint64_t columns, std::uint64_t rows)
{
    const std::uint64_t bytes = columns * rows * sizeof(double);
    if (bytes > memoryLimit())
        return fail(ErrorCode::LimitExceeded, "memory", std::to_string(bytes), std::to_string(memoryLimit()));
    return {};
}

std::string wktOf(const OGRSpatialReference *reference)
{
    if (!reference)
        return {};
    char *text = nullptr;
    std::string wkt;
    const char *const options[] = {"FORMAT=WKT2_2019", nullptr};
    if (reference->exportToWkt(&text, options) == OGRERR_NONE)
        wkt = text;
    CPLFree(text);
    return wkt;
}

std::string unitOf(const OGRSpatialReference *reference)
{
    if (!reference || reference->IsLocal())
        return "metre";
    const char *name = nullptr;
    if (reference->IsGeographic())
        reference->GetAngularUnits(&name);
    else
        reference->GetLinearUnits(&name);
    return name && *name ? name : "metre";
}

/// What the format says a void cell is, if the file does not.
std::optional<double> noDataOf(GDALDataset &dataset, GDALRasterBand &band, const RasterOptions &options)
{
    if (options.noData)
        return options.noData;
    int isKnown = 0;
    const double value = band.GetNoDataValue(&isKnown);
    if (isKnown)
        return value;
    constexpr double AsciiGridDefault = -9999;
    const char *const driver = dataset.GetDriver() ? dataset.GetDriver()->GetDescription() : "";
    return EQUAL(driver, "AAIGrid") ? std::optional(AsciiGridDefault) : std::nullopt;
}

Result<Raster> readFrom(const QString &path, const RasterOptions &options, const Progress &progress)
{
    const Messages messages;
    // Text would be read as 32-bit floats.
    const bool isText = path.endsWith(QLatin1String(".asc"), Qt::CaseInsensitive);
    const char *const openOptions[] = {isText ? "DATATYPE=Float64" : nullptr, nullptr};
    const DatasetPtr dataset(GDALDataset::Open(QFile::encodeName(path).constData(),
                                               GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, Drivers,
                                               openOptions));
    if (!dataset) {
        if (messages.text().find("not recognized") != std::string::npos)
            return failIn(path, ErrorCode::UnknownFormat, QFileInfo(path).suffix().toLower().toStdString());
        return failGdal(path, messages);
    }
    if (options.band < 1 || options.band > dataset->GetRasterCount())
        return failIn(path, ErrorCode::BadValue, QT_TRANSLATE_NOOP("ErrorText", "band"), std::to_string(options.band),
                      "1 ... " + std::to_string(dataset->GetRasterCount()));
    GDALRasterBand &band = *dataset->GetRasterBand(options.band);
    if (GDALDataTypeIsComplex(band.GetRasterDataType()))
        return failIn(path, ErrorCode::UnsupportedFeature, QT_TRANSLATE_NOOP("ErrorText", "complex numbers"));
    const auto columns = std::uint32_t(band.GetXSize()), rows = std::uint32_t(band.GetYSize());
    if (const auto checked = checkSize(columns, rows); !checked)
        return failIn(path, checked.error());

    // Pixel 0, 0 is the most north-western one, and the transform says where its outer corner lies.
    double transform[6];
    if (dataset->GetGeoTransform(transform) != CE_None) {
        const double cell = options.cellSize;
        const double unplaced[6] = {-0.5 * cell, cell, 0, (rows - 0.5) * cell, 0, -cell};
        std::copy(std::begin(unplaced), std::end(unplaced), transform);
    }
    if (transform[2] != 0 || transform[4] != 0 || !(transform[1] > 0) || transform[5] == 0)
        return failIn(path, ErrorCode::UnsupportedFeature, QT_TRANSLATE_NOOP("ErrorText", "a grid that is turned"));
    const bool isNorthUp = transform[5] < 0;

    Raster raster;
    raster.grid.columns = columns;
    raster.grid.rows = rows;
    raster.grid.stepX = transform[1];
    raster.grid.stepY = std::abs(transform[5]);
    raster.geoReference.originX = transform[0] + 0.5 * transform[1];
    raster.geoReference.originY = transform[3] + (isNorthUp ? rows - 0.5 : 0.5) * transform[5];
    raster.geoReference.crs = wktOf(dataset->GetSpatialRef());
    raster.geoReference.unit = unitOf(dataset->GetSpatialRef());
    raster.heightUnit = band.GetUnitType() ? band.GetUnitType() : "";

    const std::optional<double> noData = noDataOf(*dataset, band, options);
    const bool hasMask = (band.GetMaskFlags() & (GMF_ALL_VALID | GMF_NODATA | GMF_ALPHA)) == 0;
    std::vector<std::uint8_t> mask(hasMask ? columns : 0);
    raster.grid.heights.resize(std::size_t(columns) * rows);
    int hasScale = 0, hasOffset = 0;
    const double fileScale = band.GetScale(&hasScale), fileOffset = band.GetOffset(&hasOffset);
    const double scale = options.heightScale * (hasScale ? fileScale : 1);
    const double offset = options.heightOffset + options.heightScale * (hasOffset ? fileOffset : 0);
    for (std::uint32_t row = 0; row < rows; ++row) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        double *const line = raster.grid.heights.data() + std::size_t(isNorthUp ? rows - 1 - row : row) * columns;
        if (band.RasterIO(GF_Read, 0, int(row), int(columns), 1, line, int(columns), 1, GDT_Float64, 0, 0, nullptr) !=
            CE_None)
            return failGdal(path, messages);
        if (hasMask && band.GetMaskBand()->RasterIO(GF_Read, 0, int(row), int(columns), 1, mask.data(), int(columns), 1,
                                                    GDT_Byte, 0, 0, nullptr) != CE_None)
            return failGdal(path, messages);
        for (std::uint32_t i = 0; i < columns; ++i) {
            double &height = line[i];
            // Files of 32-bit floats give NODATA as the text of a 64-bit one.
            if (!std::isfinite(height) || (noData && (height == *noData || float(height) == float(*noData))) ||
                (hasMask && mask[i] == 0))
                height = NAN;
            else if (scale != 1 || offset != 0)
                height = height * scale + offset;
        }
        progress.report(double(row + 1) / rows);
    }
    return raster;
}

/// A raster as a dataset in memory, for the drivers that copy.
DatasetPtr memoryDataset(const Raster &raster, GDALDataType type)
{
    auto *const driver = GetGDALDriverManager()->GetDriverByName("MEM");
    DatasetPtr dataset(driver ? driver->Create("", int(raster.grid.columns), int(raster.grid.rows), 1, type, nullptr)
                              : nullptr);
    if (!dataset)
        return dataset;
    const terrain::HeightGrid &grid = raster.grid;
    double transform[6] = {raster.geoReference.originX - 0.5 * grid.stepX,
                           grid.stepX,
                           0,
                           raster.geoReference.originY + (grid.rows - 0.5) * grid.stepY,
                           0,
                           -grid.stepY};
    dataset->SetGeoTransform(transform);
    if (!raster.geoReference.crs.empty()) {
        OGRSpatialReference reference;
        if (reference.importFromWkt(raster.geoReference.crs.c_str()) == OGRERR_NONE)
            dataset->SetSpatialRef(&reference);
    }
    return dataset;
}

/// Removes a file in GDAL's own memory.
struct MemoryFile
{
    std::string name;

    explicit MemoryFile(const char *ending)
        : name(std::string("/vsimem/sandreel-") + std::to_string(reinterpret_cast<std::uintptr_t>(this)) + ending)
    {}
    MemoryFile(const MemoryFile &) = delete;
    MemoryFile &operator=(const MemoryFile &) = delete;
    ~MemoryFile()
    {
        VSIUnlink(name.c_str());
        VSIUnlink((name + ".aux.xml").c_str());
    }
    std::span<const std::uint8_t> bytes() const
    {
        vsi_l_offset size = 0;
        const GByte *const data = VSIGetMemFileBuffer(name.c_str(), &size, FALSE);
        return {data, data ? std::size_t(size) : 0};
    }
};

Result<void> writeByGdal(const QString &path, const Raster &raster, RasterFormat format, PngScale *scale,
                         const Progress &progress)
{
    const Messages messages;
    const terrain::HeightGrid &grid = raster.grid;
    const bool isPng = format == RasterFormat::Png16;
    const DatasetPtr source = memoryDataset(raster, isPng ? GDT_UInt16 : GDT_Float64);
    auto *const driver = GetGDALDriverManager()->GetDriverByName(isPng ? "PNG" : "GTiff");
    if (!source || !driver)
        return failGdal(path, messages);
    double lowest = INFINITY, highest = -INFINITY;
    bool hasVoids = false;
    for (const double height : grid.heights) {
        hasVoids = hasVoids || std::isnan(height);
        lowest = std::min(lowest, std::isnan(height) ? lowest : height);
        highest = std::max(highest, std::isnan(height) ? highest : height);
    }
    PngScale png;
    if (isPng && lowest <= highest) {
        const double steps = hasVoids ? 65534 : 65535;
        png.scale = highest > lowest ? (highest - lowest) / steps : 1;
        png.offset = lowest - (hasVoids ? png.scale : 0);
    }
    GDALRasterBand &band = *source->GetRasterBand(1);
    constexpr double Void = -std::numeric_limits<float>::max();
    if (hasVoids)
        band.SetNoDataValue(isPng ? 0 : Void);
    std::vector<double> line(grid.columns);
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        for (std::uint32_t i = 0; i < grid.columns; ++i) {
            const double height = grid.height(i, grid.rows - 1 - row);
            line[i] = std::isnan(height) ? (isPng ? 0 : Void)
                      : isPng            ? std::nearbyint((height - png.offset) / png.scale)
                                         : height;
        }
        if (band.RasterIO(GF_Write, 0, int(row), int(grid.columns), 1, line.data(), int(grid.columns), 1, GDT_Float64,
                          0, 0, nullptr) != CE_None)
            return failGdal(path, messages);
        progress.report(0.5 * double(row + 1) / grid.rows);
    }
    const MemoryFile file(isPng ? ".png" : ".tif");
    const char *const geoTiffOptions[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", "BIGTIFF=IF_SAFER", nullptr};
    const auto report = [](double done, const char *, void *data) {
        const auto *const part = static_cast<const Progress *>(data);
        part->report(0.5 + 0.5 * done);
        return part->isCancelled() ? FALSE : TRUE;
    };
    Progress watched = progress;
    const DatasetPtr copy(driver->CreateCopy(file.name.c_str(), source.get(), FALSE,
                                             isPng ? nullptr : const_cast<char **>(geoTiffOptions), report, &watched));
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    if (!copy)
        return failGdal(path, messages);
    const_cast<DatasetPtr &>(copy).reset();
    if (scale)
        *scale = png;
    return saveBytes(path, file.bytes());
}

/// Our own: GDAL rounds to a fixed number of digits.
Result<void> writeAsciiGrid(const QString &path, const Raster &raster, const Progress &progress)
{
    const terrain::HeightGrid &grid = raster.grid;
    if (grid.stepX != grid.stepY)
        return failIn(path, ErrorCode::UnsupportedFeature,
                      QT_TRANSLATE_NOOP("ErrorText", "cells that are not square; GeoTIFF has them"));
    std::string text = "ncols " + std::to_string(grid.columns) + "\nnrows " + std::to_string(grid.rows);
    for (const auto &[key, value] : {std::pair{"\nxllcenter ", raster.geoReference.originX},
                                     {"\nyllcenter ", raster.geoReference.originY},
                                     {"\ncellsize ", grid.stepX}}) {
        text += key;
        appendNumber(text, value);
    }
    text += "\nNODATA_value -9999\n";
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        for (std::uint32_t i = 0; i < grid.columns; ++i) {
            const double height = grid.height(i, grid.rows - 1 - row);
            appendNumber(text, std::isnan(height) ? -9999 : height);
            text += i + 1 < grid.columns ? ' ' : '\n';
        }
        progress.report(double(row + 1) / grid.rows);
    }
    return saveBytes(path, {reinterpret_cast<const std::uint8_t *>(text.data()), text.size()});
}

} // namespace

QStringList rasterEndings()
{
    return {"asc", "tif", "tiff", "png", "hgt", "dem", "dt0", "dt1", "dt2",
            "img", "flt", "bil",  "grd", "bmp", "pgm", "jpg", "ter", "bt"};
}

Result<std::string> wktOfCrs(const std::string &crs)
{
    registerDrivers();
    const Messages messages;
    OGRSpatialReference reference;
    // By code or by text; never by the name of a file or a server.
    const char *const options[] = {"ALLOW_NETWORK_ACCESS=NO", "ALLOW_FILE_ACCESS=NO", nullptr};
    if (reference.SetFromUserInput(crs.c_str(), options) != OGRERR_NONE)
        return fail(ErrorCode::BadSetting, "crs", crs, "EPSG:code, WKT");
    return wktOf(&reference);
}

Result<Raster> readRaster(const QString &path, const RasterOptions &options, const Progress &progress)
{
    QFile file(path);
    if (const auto opened = openFile(file); !opened)
        return fail(opened.error());
    file.close();
    registerDrivers();
    return catchBadAlloc([&] { return readFrom(QFileInfo(path).absoluteFilePath(), options, progress); });
}

Result<void> writeRaster(const QString &path, const Raster &raster, RasterFormat format, PngScale *scale,
                         const Progress &progress)
{
    registerDrivers();
    if (format == RasterFormat::AsciiGrid)
        return writeAsciiGrid(path, raster, progress);
    return writeByGdal(path, raster, format, scale, progress);
}

Result<Raster> rasterOf(const terrain::Terrain &terrain, terrain::Point2 step, const Progress &progress)
{
    const terrain::Rectangle domain = terrain.tin.domain();
    const double width = domain.high.x - domain.low.x, height = domain.high.y - domain.low.y;
    constexpr double Slack = 1e-9;
    const double columns = std::floor(width / step.x + Slack) + 1, rows = std::floor(height / step.y + Slack) + 1;
    if (!(columns >= 2 && rows >= 2))
        return fail(ErrorCode::BadSetting, "cell", numberText(step.x), "at most the terrain's width and height");
    if (columns > 1e6 || rows > 1e6)
        return fail(ErrorCode::LimitExceeded, "size of the grid",
                    std::to_string(std::uint64_t(std::max(columns, rows))), "1000000");
    if (const auto checked = checkSize(std::uint64_t(columns), std::uint64_t(rows)); !checked)
        return fail(checked.error());
    Raster raster;
    raster.geoReference = terrain.geoReference;
    raster.geoReference.originX += domain.low.x;
    raster.geoReference.originY += domain.low.y;
    terrain::HeightGrid &grid = raster.grid;
    grid.columns = std::uint32_t(columns);
    grid.rows = std::uint32_t(rows);
    grid.stepX = step.x;
    grid.stepY = step.y;
    grid.heights.resize(std::size_t(grid.columns) * grid.rows);
    terrain::VertexId near = terrain::None;
    for (std::uint32_t j = 0; j < grid.rows; ++j) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        for (std::uint32_t i = 0; i < grid.columns; ++i) {
            const terrain::Point2 node = grid.point(i, j);
            const terrain::Point2 p{std::min(domain.low.x + node.x, domain.high.x),
                                    std::min(domain.low.y + node.y, domain.high.y)};
            const terrain::Location location = terrain.tin.locate(p, near);
            near = terrain.tin.arrays().vertex(location.corner);
            bool isGround = !terrain.tin.arrays().isVoid(terrain::triangleOf(location.corner));
            // On the border of a void there is ground on one side.
            if (!isGround && location.kind == terrain::Location::Kind::Vertex)
                forEachCornerAround(terrain.tin.arrays(), near, [&](terrain::Corner c) {
                    isGround = isGround || !terrain.tin.arrays().isVoid(terrain::triangleOf(c));
                });
            else if (!isGround && location.kind == terrain::Location::Kind::Edge) {
                const terrain::Corner o = terrain.tin.arrays().opposite(location.corner);
                isGround = o != terrain::NoCorner && !terrain.tin.arrays().isVoid(terrain::triangleOf(o));
            }
            grid.heights[grid.index(i, j)] = isGround ? terrain.tin.heightAt(p, near) : NAN;
        }
        progress.report(double(j + 1) / grid.rows);
    }
    return raster;
}

} // namespace model::io
