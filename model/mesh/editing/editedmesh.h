// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/faces.h"

namespace model {

/// Where the vertices of an edited mesh are: each at a weighted mean of vertices that were there before. The same for
/// every frame of an animation, so that an edit acts on all frames alike and they keep one connectivity.
class VertexSources
{
public:
    struct Share
    {
        std::uint32_t vertex; ///< of the mesh before
        float weight;
    };

    std::uint32_t count() const { return std::uint32_t(mBegins.size() - 1); }
    std::span<const Share> of(std::uint32_t vertex) const
    {
        return std::span(mShares).subspan(mBegins[vertex], mBegins[vertex + 1] - mBegins[vertex]);
    }
    /// The vertex that this one is a copy of; NoSource if it is a mean of several.
    std::uint32_t copyOf(std::uint32_t vertex) const;
    static constexpr std::uint32_t NoSource = ~std::uint32_t(0);

    void addCopy(std::uint32_t vertex);
    /// Precondition: the weights add up to 1.
    void addMean(std::span<const Share> shares);
    /// #V new positions of one frame.
    /// \param before  of the same frame
    std::vector<Vec3f> positions(std::span<const Vec3f> before) const;

    /// Those of an edit that comes after the one that these describe.
    VertexSources followedBy(const VertexSources &later) const;
    static VertexSources identity(std::uint32_t count);

private:
    std::vector<std::size_t> mBegins = {0};
    std::vector<Share> mShares;
};

/// What an edit makes of a mesh.
struct EditedMesh
{
    Faces faces;
    VertexSources vertices;
    /// For each face the one that it was, or is a part of; NewFace for one that is in place of nothing.
    std::vector<std::uint32_t> faceFrom;

    static constexpr std::uint32_t NewFace = ~std::uint32_t(0);
    /// Whether nothing changed at all: the same faces over the same vertices.
    bool isUnchanged(const Faces &before) const;
};

/// Both edits, one after the other.
/// \param later  of the mesh that `first` made
EditedMesh combined(const EditedMesh &first, EditedMesh later);

/// Puts an edited mesh together: faces whose corners are numbers of vertices before, or of new ones.
class MeshBuilder
{
public:
    explicit MeshBuilder(const Faces &before);

    /// A vertex beside those of before. \returns its number for addFace()
    std::uint32_t addCopy(std::uint32_t vertex);
    std::uint32_t addMean(std::span<const VertexSources::Share> shares);
    void addFace(std::span<const std::uint32_t> corners, std::uint32_t from);
    void keepFace(std::uint32_t face) { addFace(mBefore.face(face), face); }

    /// Vertices that no face uses any more are dropped, those that none used before stay unless `dropIsolated`. The
    /// others keep their order, new ones come last.
    EditedMesh finish(bool dropIsolated = false) &&;

private:
    const Faces &mBefore;
    VertexSources mNew;
    EditedMesh mResult;
};

} // namespace model
