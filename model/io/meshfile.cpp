// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/meshfile.h"

#include "model/io/objreader.h"
#include "model/io/offreader.h"
#include "model/io/plyreader.h"
#include "model/io/stlreader.h"

#include <algorithm>

#include <QFileInfo>
#include <QStringList>

namespace model::io {

namespace {

/// OBJ, OFF and PLY. \returns true if the faces are those of `known`
Result<bool> parseIndexed(MeshKind kind, std::string_view bytes, ParsedMesh &mesh, const Progress &progress,
                          const KnownFaces &known, std::vector<Vec3d> *precise = nullptr)
{
    if (kind == MeshKind::Obj)
        return parseObj(bytes, mesh, progress, known, precise);
    if (kind == MeshKind::Off)
        return parseOff(bytes, mesh, progress, known);
    mesh.clear();
    mesh.facesBegin = bytes.size();
    if (auto parsed = parsePly(bytes, mesh.mesh, progress, precise); !parsed)
        return fail(std::move(parsed.error()));
    return false;
}

} // namespace

QStringList meshEndings()
{
    return {QStringLiteral("obj"), QStringLiteral("off"), QStringLiteral("ply"), QStringLiteral("stl")};
}

std::optional<MeshKind> meshKindOf(const QString &path)
{
    const auto index = meshEndings().indexOf(QFileInfo(path).suffix().toLower());
    return index < 0 ? std::nullopt : std::optional(MeshKind(index));
}

Result<TriangleMesh> parseMesh(MeshKind kind, std::string_view bytes, const Progress &progress)
{
    Result<FirstFrame> frame = FirstFrame::parse(kind, bytes, {}, progress);
    if (!frame)
        return fail(std::move(frame.error()));
    return frame->takeMesh();
}

Result<PreciseMesh> parsePreciseMesh(MeshKind kind, std::string_view bytes, const Progress &progress)
{
    PreciseMesh precise;
    if (kind == MeshKind::Stl) {
        std::vector<Vec3f> corners;
        std::vector<Vec3d> wide;
        if (auto parsed = parseStl(bytes, corners, progress, &wide); !parsed)
            return fail(std::move(parsed.error()));
        precise.positions = weldCorners(wide, precise.connectivity);
        return precise;
    }
    ParsedMesh mesh;
    if (auto parsed = parseIndexed(kind, bytes, mesh, progress, {}, &precise.positions); !parsed)
        return fail(std::move(parsed.error()));
    if (kind == MeshKind::Off)
        precise.positions.assign(mesh.mesh.positions.begin(), mesh.mesh.positions.end());
    precise.connectivity = std::move(mesh.mesh.connectivity);
    return precise;
}

Result<FirstFrame> FirstFrame::parse(MeshKind kind, std::string_view bytes, std::string file, const Progress &progress)
{
    FirstFrame frame;
    frame.mKind = kind;
    frame.mFile = std::move(file);
    if (kind == MeshKind::Stl) {
        std::vector<Vec3f> corners;
        if (auto parsed = parseStl(bytes, corners, progress); !parsed)
            return fail(std::move(parsed.error()));
        frame.mMesh = weldCorners(corners);
        return frame;
    }
    ParsedMesh mesh;
    if (auto parsed = parseIndexed(kind, bytes, mesh, progress, {}); !parsed)
        return fail(std::move(parsed.error()));
    if (mesh.facesLast)
        frame.mFacesText = bytes.substr(mesh.facesBegin);
    frame.mAnnouncedFaces = mesh.announcedFaces;
    frame.mMesh = std::move(mesh.mesh);
    return frame;
}

Result<void> FirstFrame::parseNext(std::string_view bytes, std::span<Vec3f> positions, Scratch &scratch,
                                   const Progress &progress) const
{
    if (mKind == MeshKind::Stl)
        return parseNextStl(bytes, positions, scratch, progress);
    const Result<bool> sameFaces = parseIndexed(mKind, bytes, scratch.parsed, progress, knownFaces());
    if (!sameFaces)
        return fail(sameFaces.error());
    const TriangleMesh &mesh = scratch.parsed.mesh;
    if (mesh.positions.size() != positions.size())
        return failCountDiffers(ErrorCode::VertexCountDiffers, mesh.positions.size(), positions.size());
    if (!*sameFaces)
        if (auto same = compareFaces(mesh.connectivity.triangles); !same)
            return same;
    std::copy(mesh.positions.begin(), mesh.positions.end(), positions.begin());
    return {};
}

Result<void> FirstFrame::parseNextStl(std::string_view bytes, std::span<Vec3f> positions, Scratch &scratch,
                                      const Progress &progress) const
{
    if (auto parsed = parseStl(bytes, scratch.corners, progress); !parsed)
        return parsed;
    const std::size_t count = scratch.corners.size() / 3, firstCount = connectivity().triangles.size();
    if (count != firstCount)
        return failCountDiffers(ErrorCode::FaceCountDiffers, count, firstCount);
    const std::size_t torn = gatherVertices(scratch.corners, connectivity().triangles, positions);
    if (torn != count)
        return fail(ErrorCode::FacesDiffer, std::to_string(torn), mFile);
    return {};
}

Result<void> FirstFrame::compareFaces(const std::vector<Triangle> &triangles) const
{
    const std::vector<Triangle> &first = connectivity().triangles;
    if (triangles.size() != first.size())
        return failCountDiffers(ErrorCode::FaceCountDiffers, triangles.size(), first.size());
    const auto at = std::mismatch(triangles.begin(), triangles.end(), first.begin()).first;
    if (at != triangles.end())
        return fail(ErrorCode::FacesDiffer, std::to_string(at - triangles.begin()), mFile);
    return {};
}

tl::unexpected<Error> FirstFrame::failCountDiffers(ErrorCode code, std::size_t here, std::size_t first) const
{
    return fail(code, std::to_string(here), std::to_string(first), mFile);
}

} // namespace model::io
