// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/geometry/vec3d.h"
#include "model/io/parsedmesh.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <QString>

namespace model::io {

/// Formats of single meshes, by the ending of the file.
enum class MeshKind : std::uint8_t { Obj, Off, Ply, Stl };

std::optional<MeshKind> meshKindOf(const QString &path);

/// Lower case, without dot, in the order of MeshKind.
QStringList meshEndings();

/// Parses a mesh file. Errors as the format's parser; NoVertices.
Result<TriangleMesh> parseMesh(MeshKind kind, std::string_view bytes, const Progress &progress = Progress());

struct PreciseMesh
{
    std::vector<Vec3d> positions;
    Connectivity connectivity;
};
/// The same with positions in double, as text and PLY of 64 bits have them: for coordinates whose offsets leave floats
/// no centimetres.
Result<PreciseMesh> parsePreciseMesh(MeshKind kind, std::string_view bytes, const Progress &progress = Progress());

/// The first frame of an animation, and what is kept of it to read the others: they differ in their positions only.
/// parseNext() may run in several threads.
class FirstFrame
{
public:
    /// Memory for one call of parseNext(), to be used again.
    struct Scratch
    {
        ParsedMesh parsed;
        std::vector<Vec3f> corners;
    };

    /// \param bytes  of the file; not needed afterwards
    static Result<FirstFrame> parse(MeshKind kind, std::string_view bytes, std::string file,
                                    const Progress &progress = Progress());

    const TriangleMesh &mesh() const { return mMesh; }
    TriangleMesh takeMesh() { return std::move(mMesh); }
    const Connectivity &connectivity() const { return mMesh.connectivity; }

    /// Parses another frame. STL corners make the vertices that they made in the first frame: one that moves apart is
    /// FacesDiffer, two that meet stay two.
    /// \param positions  #V, written
    /// \error VertexCountDiffers, FaceCountDiffers, FacesDiffer, and those of the format's parser
    Result<void> parseNext(std::string_view bytes, std::span<Vec3f> positions, Scratch &scratch,
                           const Progress &progress = Progress()) const;

private:
    Result<void> parseNextStl(std::string_view bytes, std::span<Vec3f> positions, Scratch &scratch,
                              const Progress &progress) const;
    Result<void> compareFaces(const std::vector<Triangle> &triangles) const;
    tl::unexpected<Error> failCountDiffers(ErrorCode code, std::size_t here, std::size_t first) const;
    KnownFaces knownFaces() const { return {mFacesText, connectivity().vertexCount, mAnnouncedFaces}; }

    MeshKind mKind = MeshKind::Obj;
    std::string mFile;
    TriangleMesh mMesh;
    std::string mFacesText; ///< if nothing else in the file matters to the faces
    std::int64_t mAnnouncedFaces = 0;
};

} // namespace model::io
