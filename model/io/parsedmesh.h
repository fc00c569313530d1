// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/trianglemesh.h"

#include <cstdint>
#include <string_view>

namespace model::io {

/// A mesh from a text file, and what lets the next frame of its animation skip the faces.
struct ParsedMesh
{
    TriangleMesh mesh;
    /// Where the text of the faces starts; the length of the text without faces.
    std::size_t facesBegin = 0;
    /// Number of faces that the file announces; 0 in formats that do not.
    std::int64_t announcedFaces = 0;
    /// Nothing after facesBegin matters to the positions.
    bool facesLast = true;

    /// Empties it, but keeps its memory.
    void clear()
    {
        mesh.positions.clear();
        mesh.connectivity.triangles.clear();
        mesh.connectivity.vertexCount = 0;
        facesBegin = 0;
        announcedFaces = 0;
        facesLast = true;
    }
};

/// The faces of a frame that was parsed before: the same text after as many vertices means the same faces.
struct KnownFaces
{
    std::string_view text; ///< from facesBegin to the end; empty: nothing to compare with
    std::uint32_t vertexCount = 0;
    std::int64_t announcedFaces = 0;
};

} // namespace model::io
