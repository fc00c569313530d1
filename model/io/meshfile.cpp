// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/meshfile.h"

#include <algorithm>

#include <QFileInfo>
#include <QStringList>

namespace model::io {

QStringList meshEndings()
{
    return {QStringLiteral("obj")};
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

Result<FirstFrame> FirstFrame::parse(MeshKind kind, std::string_view bytes, std::string file, const Progress &progress)
{
    FirstFrame frame;
    frame.mKind = kind;
    frame.mFile = std::move(file);
    ObjMesh obj;
    if (const auto parsed = parseObj(bytes, obj, progress); !parsed)
        return fail(parsed.error());
    if (obj.facesLast)
        frame.mObjFaces = bytes.substr(obj.facesBegin);
    frame.mMesh = std::move(obj.mesh);
    return frame;
}

Result<void> FirstFrame::parseNext(std::string_view bytes, std::span<Vec3f> positions, Scratch &scratch,
                                   const Progress &progress) const
{
    const Result<bool> sameFaces = parseObj(bytes, scratch.mesh, progress, {mObjFaces, connectivity().vertexCount});
    if (!sameFaces)
        return fail(sameFaces.error());
    const TriangleMesh &mesh = scratch.mesh.mesh;
    const auto differs = [&](ErrorCode code, std::size_t here, std::size_t first) {
        return fail(code, std::to_string(here), std::to_string(first), mFile);
    };
    if (mesh.positions.size() != positions.size())
        return differs(ErrorCode::VertexCountDiffers, mesh.positions.size(), positions.size());
    if (!*sameFaces) {
        const auto &here = mesh.connectivity.triangles, &first = connectivity().triangles;
        if (here.size() != first.size())
            return differs(ErrorCode::FaceCountDiffers, here.size(), first.size());
        const auto at = std::mismatch(here.begin(), here.end(), first.begin()).first;
        if (at != here.end())
            return fail(ErrorCode::FacesDiffer, std::to_string(at - here.begin()), mFile);
    }
    std::copy(mesh.positions.begin(), mesh.positions.end(), positions.begin());
    return {};
}

} // namespace model::io
