// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/terrainexport.h"

#include "model/base/numbertext.h"
#include "model/io/savefile.h"
#include "model/io/terrain/contours.h"

#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include <bit>
#include <cmath>

namespace model::io {

using namespace terrain;

namespace {

void appendInteger(std::string &out, std::uint64_t value)
{
    out += std::to_string(value);
}

/// The triangles that are ground, and their vertices, numbered without gaps.
struct SurfaceMesh
{
    std::vector<VertexId> vertices;
    std::vector<std::uint32_t> numberOf; ///< of each slot; None: not used
    std::vector<TriangleId> triangles;
};

SurfaceMesh meshOf(const TinArrays &tin)
{
    SurfaceMesh mesh;
    mesh.numberOf.assign(tin.vertexSlots(), None);
    for (TriangleId t = 0; t < tin.triangleSlots(); ++t) {
        if (!tin.isTriangle(t) || tin.isVoid(t))
            continue;
        mesh.triangles.push_back(t);
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
            std::uint32_t &number = mesh.numberOf[tin.vertex(c)];
            if (number != None)
                continue;
            number = std::uint32_t(mesh.vertices.size());
            mesh.vertices.push_back(tin.vertex(c));
        }
    }
    return mesh;
}

class MeshText
{
public:
    MeshText(const Terrain &terrain, bool isWorld)
        : mTin(terrain.tin.arrays())
        , mMesh(meshOf(mTin))
        , mOrigin{terrain.geoReference.originX, terrain.geoReference.originY}
        , mOffset(isWorld ? mOrigin : Point2{})
        , mIsWorld(isWorld)
    {}

    const SurfaceMesh &mesh() const { return mMesh; }

    std::string obj() const
    {
        std::string out = "# Sandreel terrain" + originComment() + "\n";
        for (const VertexId v : mMesh.vertices) {
            out += "v ";
            appendNumber(out, mTin.points[v].x + mOffset.x);
            out += ' ';
            appendNumber(out, mTin.points[v].y + mOffset.y);
            out += ' ';
            appendNumber(out, mTin.heights[v]);
            out += '\n';
        }
        for (const TriangleId t : mMesh.triangles) {
            out += 'f';
            for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
                out += ' ';
                appendInteger(out, mMesh.numberOf[mTin.vertex(c)] + std::uint64_t(1));
            }
            out += '\n';
        }
        return out;
    }

    Bytes ply() const
    {
        const std::string header = "ply\nformat binary_little_endian 1.0\ncomment Sandreel terrain" + originComment() +
                                   "\nelement vertex " + std::to_string(mMesh.vertices.size()) +
                                   "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                                   std::to_string(mMesh.triangles.size()) +
                                   "\nproperty list uchar uint vertex_indices\nend_header\n";
        ByteWriter out;
        out.bytes({reinterpret_cast<const std::uint8_t *>(header.data()), header.size()});
        for (const VertexId v : mMesh.vertices) {
            out.f64(mTin.points[v].x + mOffset.x);
            out.f64(mTin.points[v].y + mOffset.y);
            out.f64(mTin.heights[v]);
        }
        for (const TriangleId t : mMesh.triangles) {
            out.u8(3);
            for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c)
                out.u32(mMesh.numberOf[mTin.vertex(c)]);
        }
        return out.take();
    }

    Bytes stl() const
    {
        constexpr std::size_t HeaderSize = 80;
        std::string header = "Sandreel terrain" + originComment();
        header.resize(HeaderSize, ' ');
        ByteWriter out;
        out.bytes({reinterpret_cast<const std::uint8_t *>(header.data()), header.size()});
        out.u32(std::uint32_t(mMesh.triangles.size()));
        for (const TriangleId t : mMesh.triangles) {
            const Gradient gradient = gradientOf(mTin, t);
            const double length = std::sqrt(gradient.x * gradient.x + gradient.y * gradient.y + 1);
            for (const double n : {-gradient.x / length, -gradient.y / length, 1 / length})
                out.f32(float(n));
            for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
                out.f32(float(mTin.pointAt(c).x));
                out.f32(float(mTin.pointAt(c).y));
                out.f32(float(mTin.heights[mTin.vertex(c)]));
            }
            out.u16(0);
        }
        return out.take();
    }

private:
    std::string originComment() const
    {
        if (mIsWorld || (mOrigin.x == 0 && mOrigin.y == 0))
            return {};
        std::string text = ", origin ";
        appendNumber(text, mOrigin.x);
        text += ' ';
        appendNumber(text, mOrigin.y);
        return text;
    }

    const TinArrays &mTin;
    const SurfaceMesh mMesh;
    const Point2 mOrigin, mOffset;
    const bool mIsWorld;
};

Result<void> saveText(const QString &path, const std::string &text)
{
    return saveBytes(path, {reinterpret_cast<const std::uint8_t *>(text.data()), text.size()});
}

Result<std::uint64_t> writeContours(const QString &path, const Terrain &terrain, double interval,
                                    const Progress &progress)
{
    const auto contours = contoursOf(terrain.tin, interval, 0, progress);
    if (!contours)
        return fail(contours.error());
    std::string out = "{\"type\":\"FeatureCollection\",";
    if (!terrain.geoReference.crs.empty()) {
        const QByteArray wkt = QJsonDocument(QJsonObject{{"wkt", QString::fromStdString(terrain.geoReference.crs)}})
                                   .toJson(QJsonDocument::Compact);
        out += "\"coordRefSys\":" + wkt.toStdString() + ",";
    }
    out += "\"features\":[";
    bool isFirst = true;
    for (const Contour &contour : *contours) {
        out += isFirst ? "\n" : ",\n";
        isFirst = false;
        out += "{\"type\":\"Feature\",\"properties\":{\"elevation\":";
        appendNumber(out, contour.level);
        out += "},\"geometry\":{\"type\":\"LineString\",\"coordinates\":[";
        for (std::size_t i = 0; i < contour.points.size(); ++i) {
            out += i ? ",[" : "[";
            appendNumber(out, contour.points[i].x + terrain.geoReference.originX);
            out += ',';
            appendNumber(out, contour.points[i].y + terrain.geoReference.originY);
            out += ']';
        }
        out += "]}}";
    }
    out += "\n]}\n";
    if (auto saved = saveText(path, out); !saved)
        return fail(saved.error());
    return contours->size();
}

Point2 cellOf(const Terrain &terrain, Point2 step, double wanted)
{
    constexpr double CellsAlong = 1024;
    if (wanted > 0)
        return {wanted, wanted};
    if (step.x > 0 && step.y > 0)
        return step;
    const Rectangle domain = terrain.tin.domain();
    const double cell = std::max(domain.high.x - domain.low.x, domain.high.y - domain.low.y) / CellsAlong;
    return {cell, cell};
}

struct Ending
{
    const char *ending;
    TerrainFormat format;
};
constexpr Ending Endings[] = {
    {"obj", TerrainFormat::Obj},       {"ply", TerrainFormat::Ply},          {"stl", TerrainFormat::Stl},
    {"asc", TerrainFormat::AsciiGrid}, {"tif", TerrainFormat::GeoTiff},      {"tiff", TerrainFormat::GeoTiff},
    {"png", TerrainFormat::Png16},     {"geojson", TerrainFormat::Contours}, {"json", TerrainFormat::Contours}};

} // namespace

std::optional<TerrainFormat> terrainFormatOf(const QString &path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    for (const Ending &known : Endings)
        if (ending == QLatin1String(known.ending))
            return known.format;
    return std::nullopt;
}

QStringList terrainExportEndings()
{
    QStringList endings;
    for (const Ending &known : Endings)
        endings << QLatin1String(known.ending);
    return endings;
}

Result<ExportedTerrain> exportTerrain(const QString &path, TerrainFormat format, const Terrain &terrain, Point2 step,
                                      const TerrainExportOptions &options, const Progress &progress)
{
    ExportedTerrain exported;
    Result<void> written;
    switch (format) {
    case TerrainFormat::Obj:
    case TerrainFormat::Ply:
    case TerrainFormat::Stl: {
        const MeshText text(terrain, options.isWorld && format != TerrainFormat::Stl);
        exported.vertices = text.mesh().vertices.size();
        exported.triangles = text.mesh().triangles.size();
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        if (format == TerrainFormat::Obj)
            written = saveText(path, text.obj());
        else
            written = saveBytes(path, format == TerrainFormat::Ply ? text.ply() : text.stl());
        break;
    }
    case TerrainFormat::AsciiGrid:
    case TerrainFormat::GeoTiff:
    case TerrainFormat::Png16: {
        const auto raster = rasterOf(terrain, cellOf(terrain, step, options.cell), progress.part(0.0, 0.5));
        if (!raster)
            return fail(raster.error());
        exported.columns = raster->grid.columns;
        exported.rows = raster->grid.rows;
        const RasterFormat rasterFormat = format == TerrainFormat::AsciiGrid ? RasterFormat::AsciiGrid
                                          : format == TerrainFormat::GeoTiff ? RasterFormat::GeoTiff
                                                                             : RasterFormat::Png16;
        written = writeRaster(path, *raster, rasterFormat, &exported.scale, progress.part(0.5, 1.0));
        break;
    }
    case TerrainFormat::Contours: {
        const auto lines = writeContours(path, terrain, options.interval, progress);
        if (!lines)
            return fail(lines.error());
        exported.lines = *lines;
        break;
    }
    }
    if (!written)
        return fail(written.error());
    return exported;
}

} // namespace model::io
