// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/terrainimport.h"

#include "model/base/outofmemory.h"
#include "model/io/failure.h"
#include "model/io/filebuffer.h"
#include "model/io/meshfile.h"
#include "model/io/terrain/meshes/pointsreader.h"
#include "model/io/terrain/meshes/surfacemesh.h"
#include "model/terrain/simplify/simplifygrid.h"
#include "model/terrain/simplify/simplifytin.h"
#include "model/terrain/tin/tinedit.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace model::io {

using namespace terrain;

namespace {

/// Points of a cloud are put on a grid that is this much finer than their mean distance: files hold such coordinates in
/// few bytes, and nobody can tell.
constexpr double GridFineness = 4096;

double planeQuantum(const Rectangle &domain, std::size_t count)
{
    const double area = (domain.high.x - domain.low.x) * (domain.high.y - domain.low.y);
    const double distance = std::sqrt(area / double(count));
    return std::isfinite(distance) && distance > 0 ? std::exp2(std::floor(std::log2(distance / GridFineness))) : 0;
}

double rounded(double value, double quantum)
{
    return quantum > 0 ? std::nearbyint(value / quantum) * quantum : value;
}

Result<ImportedTerrain> fromRaster(Raster raster, const TerrainImportOptions &options, const Progress &progress)
{
    const auto &heights = raster.grid.heights;
    const auto voids =
        std::uint64_t(std::count_if(heights.begin(), heights.end(), [](double h) { return std::isnan(h); }));
    Result<Tin> tin =
        simplifyGrid(raster.grid, {options.maxError, heightQuantumFor(options.maxError)}, progress.part(0.2, 1.0));
    if (!tin)
        return fail(tin.error());
    ImportedTerrain imported{
        Terrain(std::move(*tin)), {raster.grid.stepX, raster.grid.stepY}, heights.size(), voids, 0};
    imported.terrain.geoReference = std::move(raster.geoReference);
    return imported;
}

/// The most south-western corner, in whole units where that costs no precision: what people read is then their own
/// coordinates but for an offset.
Point2 originOf(const Rectangle &bounds)
{
    return {std::floor(bounds.low.x), std::floor(bounds.low.y)};
}

Result<ImportedTerrain> fromPoints(std::vector<Point3> points, const TerrainImportOptions &options,
                                   const Progress &progress)
{
    const Point2 origin = originOf(boundsOf(points));
    for (Point3 &p : points) {
        p.x -= origin.x;
        p.y -= origin.y;
        p.z = p.z * options.raster.heightScale + options.raster.heightOffset;
    }
    const double quantum = planeQuantum(boundsOf(points), points.size());
    const double heightQuantum = heightQuantumFor(options.maxError);
    for (Point3 &p : points) {
        p.x = rounded(p.x, quantum);
        p.y = rounded(p.y, quantum);
        p.z = rounded(p.z, heightQuantum);
    }
    Result<BuiltTin> built = buildTin(points, boundsOf(points));
    if (!built)
        return fail(built.error());
    const std::uint64_t duplicates = built->duplicates;
    if (options.maxError > 0) {
        // What rounding took of the error is gone.
        Result<Tin> simple =
            simplifyTin(built->tin, options.maxError - heightQuantum / 2, terrain::None, progress.part(0.4, 1.0));
        if (!simple)
            return fail(simple.error());
        built->tin = std::move(*simple);
    }
    ImportedTerrain imported{Terrain(std::move(built->tin)), {}, points.size(), 0, duplicates};
    imported.terrain.geoReference.originX = origin.x;
    imported.terrain.geoReference.originY = origin.y;
    return imported;
}

Result<ImportedTerrain> fromMesh(const PreciseMesh &mesh, const TerrainImportOptions &options, const Progress &progress)
{
    std::vector<Point3> positions;
    positions.reserve(mesh.positions.size());
    for (const Vec3d &p : mesh.positions)
        positions.push_back(options.up == UpAxis::Z ? Point3{p.x, p.y, p.z} : Point3{p.x, -p.z, p.y});
    if (mesh.connectivity.triangles.empty())
        return fromPoints(std::move(positions), options, progress);
    const Point2 origin = originOf(boundsOf(positions));
    for (Point3 &p : positions) {
        p.x -= origin.x;
        p.y -= origin.y;
        p.z = p.z * options.raster.heightScale + options.raster.heightOffset;
    }
    Result<Tin> tin = tinOfSurface(positions, mesh.connectivity.triangles, progress.part(0.2, 0.6));
    if (tin && options.maxError > 0)
        tin = simplifyTin(*tin, options.maxError, SurfaceOwner, progress.part(0.6, 1.0));
    if (!tin)
        return fail(tin.error());
    ImportedTerrain imported{Terrain(std::move(*tin)), {}, positions.size(), 0, 0};
    imported.terrain.geoReference.originX = origin.x;
    imported.terrain.geoReference.originY = origin.y;
    return imported;
}

QStringList pointEndings()
{
    return {"xyz", "txt", "csv", "pts"};
}

Result<ImportedTerrain> import(const QString &path, const TerrainImportOptions &options, const Progress &progress)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    const auto kind = meshKindOf(path);
    const bool isText = pointEndings().contains(ending), isRaw = ending == QLatin1String("raw");
    if (!isText && !isRaw && (!kind || *kind == MeshKind::Off)) {
        Result<Raster> raster = readRaster(path, options.raster, progress.part(0.0, 0.2));
        if (!raster)
            return fail(raster.error());
        return fromRaster(std::move(*raster), options, progress);
    }
    FileBuffer buffer;
    const auto bytes = buffer.load(path, progress.part(0.0, 0.1));
    if (!bytes)
        return fail(bytes.error());
    if (isRaw) {
        Result<Raster> raster = parseRaw({reinterpret_cast<const std::uint8_t *>(bytes->data()), bytes->size()},
                                         options.raw, options.raster);
        if (!raster)
            return fail(raster.error());
        return fromRaster(std::move(*raster), options, progress);
    }
    if (isText) {
        Result<std::vector<Point3>> points = parsePoints(*bytes, progress.part(0.1, 0.2));
        if (!points)
            return fail(points.error());
        return fromPoints(std::move(*points), options, progress);
    }
    const Result<PreciseMesh> mesh = parsePreciseMesh(*kind, *bytes, progress.part(0.1, 0.2));
    if (!mesh)
        return fail(mesh.error());
    return fromMesh(*mesh, options, progress);
}

} // namespace

QStringList terrainEndings()
{
    return rasterEndings() + pointEndings() + QStringList{"raw", "obj", "ply", "stl"};
}

Result<ImportedTerrain> importTerrain(const QString &path, const TerrainImportOptions &options,
                                      const Progress &progress)
{
    std::string crs;
    if (!options.crs.empty()) {
        auto wkt = wktOfCrs(options.crs);
        if (!wkt)
            return fail(wkt.error());
        crs = std::move(*wkt);
    }
    Result<ImportedTerrain> imported = catchBadAlloc([&] { return import(path, options, progress); });
    if (!imported)
        return failIn(path, imported.error());
    if (!crs.empty())
        imported->terrain.geoReference.crs = crs;
    return imported;
}

} // namespace model::io
