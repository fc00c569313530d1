// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/trianglemesh.h"

#include <span>
#include <vector>

namespace model {

/// The faces of a mesh with any number of corners each, exactly as a file has them: repeated indices, faces of one or
/// two corners, duplicates and everything else that is wrong stay. Invariant: each index is below vertexCount().
///
/// Corners are numbered through all faces. A corner also names a *side*: that from its vertex to the vertex of the next
/// corner of its face. (The corners of a CornerTable name the side opposite to them.)
class Faces
{
public:
    Faces() = default;
    explicit Faces(std::uint32_t vertexCount)
        : mVertexCount(vertexCount)
    {}
    explicit Faces(const Connectivity &connectivity);

    std::uint32_t vertexCount() const { return mVertexCount; }
    void setVertexCount(std::uint32_t count) { mVertexCount = count; }
    std::uint32_t cornerCount() const { return std::uint32_t(mCorners.size()); }
    std::uint32_t faceCount() const { return mBegins.empty() ? cornerCount() / 3 : std::uint32_t(mBegins.size() - 1); }
    bool areTriangles() const { return mBegins.empty(); }

    /// Precondition: not so many that the corners reach 2^32 - 4.
    void add(std::span<const std::uint32_t> corners);
    void reserve(std::size_t faces, std::size_t corners);

    std::span<const std::uint32_t> vertices() const { return mCorners; }
    std::uint32_t vertex(std::uint32_t corner) const { return mCorners[corner]; }
    std::span<const std::uint32_t> face(std::uint32_t face) const
    {
        return std::span(mCorners).subspan(begin(face), end(face) - begin(face));
    }
    std::uint32_t begin(std::uint32_t face) const { return mBegins.empty() ? 3 * face : mBegins[face]; }
    std::uint32_t end(std::uint32_t face) const { return mBegins.empty() ? 3 * face + 3 : mBegins[face + 1]; }
    std::uint32_t faceOf(std::uint32_t corner) const { return mBegins.empty() ? corner / 3 : mFaceOf[corner]; }

    std::uint32_t next(std::uint32_t corner) const
    {
        if (mBegins.empty())
            return corner % 3 == 2 ? corner - 2 : corner + 1;
        const std::uint32_t face = mFaceOf[corner];
        return corner + 1 == mBegins[face + 1] ? mBegins[face] : corner + 1;
    }
    std::uint32_t previous(std::uint32_t corner) const
    {
        if (mBegins.empty())
            return corner % 3 == 0 ? corner + 2 : corner - 1;
        const std::uint32_t face = mFaceOf[corner];
        return (corner == mBegins[face] ? mBegins[face + 1] : corner) - 1;
    }
    /// Where the side of a corner ends.
    std::uint32_t sideEnd(std::uint32_t corner) const { return mCorners[next(corner)]; }

    /// Each index i becomes names[i]. Precondition: the new ones are below vertexCount().
    void renameVertices(std::span<const std::uint32_t> names);

    friend bool operator==(const Faces &, const Faces &) = default;

private:
    std::uint32_t mVertexCount = 0;
    std::vector<std::uint32_t> mCorners;
    std::vector<std::uint32_t> mBegins; ///< #F + 1; empty as long as all faces are triangles
    std::vector<std::uint32_t> mFaceOf; ///< #C; empty too
};

/// Faces and where their vertices are: positions.size() == faces.vertexCount().
struct PolygonMesh
{
    std::vector<Vec3f> positions;
    Faces faces;
};

/// The same surface of triangles: each face becomes a fan around its first corner, in order; faces of fewer than three
/// corners become none.
/// \param faceOf  where not null: gets for each triangle the face that it is a part of
Connectivity fans(const Faces &faces, std::vector<std::uint32_t> *faceOf = nullptr);

/// Whether a face has fewer than three corners or a vertex twice.
bool isDegenerate(std::span<const std::uint32_t> face);

} // namespace model
