// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/polygonreader.h"

#include "model/base/outofmemory.h"
#include "model/io/animationreader.h"
#include "model/io/failure.h"
#include "model/io/filebuffer.h"
#include "model/io/objreader.h"
#include "model/io/offreader.h"
#include "model/io/plyreader.h"
#include "model/io/stlreader.h"

#include <QFileInfo>

namespace model::io {

Result<PolygonMesh> parsePolygonMesh(MeshKind kind, std::string_view bytes, const Progress &progress)
{
    PolygonMesh polygons;
    ParsedMesh mesh;
    Result<void> parsed;
    const auto without = [](Result<bool> result) { return result ? Result<void>() : fail(std::move(result.error())); };
    switch (kind) {
    case MeshKind::Obj:
        parsed = without(parseObj(bytes, mesh, progress, {}, nullptr, &polygons.faces));
        break;
    case MeshKind::Off:
        parsed = without(parseOff(bytes, mesh, progress, {}, &polygons.faces));
        break;
    case MeshKind::Ply:
        parsed = parsePly(bytes, mesh.mesh, progress, nullptr, &polygons.faces);
        break;
    case MeshKind::Stl: {
        std::vector<Vec3f> corners;
        if (parsed = parseStl(bytes, corners, progress); parsed) {
            mesh.mesh = weldCorners(corners);
            polygons.faces = Faces(mesh.mesh.connectivity);
        }
        break;
    }
    }
    if (!parsed)
        return fail(std::move(parsed.error()));
    polygons.positions = std::move(mesh.mesh.positions);
    polygons.faces.setVertexCount(std::uint32_t(polygons.positions.size()));
    return polygons;
}

Result<PolygonMesh> readPolygonMesh(const QString &path, const Progress &progress)
{
    return catchBadAlloc([&]() -> Result<PolygonMesh> {
        const auto kind = meshKindOf(path);
        if (!kind || QFileInfo(path).isDir()) {
            const auto animation = readAnimation(path, {}, progress);
            if (!animation)
                return fail(animation.error());
            return PolygonMesh{(*animation)->frame(0), Faces((*animation)->connectivity())};
        }
        FileBuffer file;
        const auto bytes = file.load(path, progress);
        if (!bytes)
            return fail(bytes.error());
        auto mesh = parsePolygonMesh(*kind, *bytes, progress);
        return mesh ? std::move(mesh) : failIn(path, std::move(mesh.error()));
    });
}

} // namespace model::io
