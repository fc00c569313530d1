// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/io/objreader.h"
#include "model/mesh/trianglemesh.h"

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

/// The first frame of an animation, and what is kept of it to read the others: they differ in their positions only.
/// parseNext() may run in several threads.
class FirstFrame
{
public:
    /// Memory for one call of parseNext(), to be used again.
    struct Scratch
    {
        ObjMesh mesh;
    };

    /// \param bytes  of the file; not needed afterwards
    static Result<FirstFrame> parse(MeshKind kind, std::string_view bytes, std::string file,
                                    const Progress &progress = Progress());

    const TriangleMesh &mesh() const { return mMesh; }
    TriangleMesh takeMesh() { return std::move(mMesh); }
    const Connectivity &connectivity() const { return mMesh.connectivity; }

    /// Parses another frame.
    /// \param positions  #V, written
    /// \error VertexCountDiffers, FaceCountDiffers, FacesDiffer, and those of the format's parser
    Result<void> parseNext(std::string_view bytes, std::span<Vec3f> positions, Scratch &scratch,
                           const Progress &progress = Progress()) const;

private:
    MeshKind mKind = MeshKind::Obj;
    std::string mFile;
    TriangleMesh mMesh;
    std::string mObjFaces; ///< the text of the faces, if nothing else matters to them
};

} // namespace model::io
