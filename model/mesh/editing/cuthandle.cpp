// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/editing/cuthandle.h"

#include "model/mesh/analysis/facelinks.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

namespace model {

namespace {

constexpr std::uint32_t None = ~std::uint32_t(0);

class LoopCutter
{
public:
    LoopCutter(const Faces &faces, std::span<const std::uint32_t> loop)
        : mLinks(faces)
        , mFaces(faces)
        , mLoop(loop)
    {}

    /// \returns the corners that move to the new vertices, by the place of their vertex in the loop
    tl::expected<std::vector<std::vector<std::uint32_t>>, EditError> cornersOfOneSide()
    {
        if (mLoop.size() < 3)
            return failEdit(EditError::Kind::BadLoop, {mLoop.begin(), mLoop.end()});
        std::unordered_map<std::uint32_t, std::uint32_t> wanted; // place of each vertex
        for (std::uint32_t i = 0; i < mLoop.size(); ++i)
            if (!wanted.emplace(mLoop[i], i).second)
                return failEdit(EditError::Kind::BadLoop, {mLoop[i]});
        mSides.assign(mLoop.size(), None);
        for (std::uint32_t side = 0; side < mFaces.cornerCount(); ++side) {
            const auto from = wanted.find(mFaces.vertex(side));
            const auto to = wanted.find(mFaces.sideEnd(side));
            if (from == wanted.end() || to == wanted.end() || !mLinks.isLinked(side))
                continue;
            if (next(from->second) == to->second)
                mSides[from->second] = side;
            else if (next(to->second) == from->second)
                mSides[to->second] = side;
        }
        for (std::uint32_t i = 0; i < mLoop.size(); ++i)
            if (mSides[i] == None)
                return failEdit(EditError::Kind::BadLoop, {mLoop[i], mLoop[next(i)]});
        // One side of the loop is as good as the other, unless there is a hole.
        auto corners = walk(mSides[0]);
        if (!corners)
            corners = walk(mLinks.across(mSides[0]));
        if (!corners)
            return failEdit(EditError::Kind::LoopAtBorder, {mBlockedAt});
        return std::move(*corners);
    }

private:
    std::uint32_t next(std::uint32_t place) const { return place + 1 == mLoop.size() ? 0 : place + 1; }

    bool isLoopEdge(std::uint32_t side, std::uint32_t place) const
    {
        return side == mSides[place] || side == mLinks.across(mSides[place]);
    }

    /// Along the loop, from the face of `side`, over all faces that touch it on that face's side.
    std::optional<std::vector<std::vector<std::uint32_t>>> walk(std::uint32_t side)
    {
        std::vector<std::vector<std::uint32_t>> corners(mLoop.size());
        for (std::uint32_t i = 0; i < mLoop.size(); ++i) {
            // Around the vertex at which this edge ends, to the next one of the loop.
            const std::uint32_t place = next(i);
            const std::uint32_t vertex = mLoop[place];
            const bool endsHere = mFaces.vertex(side) != vertex;
            FaceLinks::Step at{side, mFaces.previous(side)};
            if (endsHere) {
                const std::uint32_t corner = mFaces.next(side);
                at = {corner, corner};
            }
            corners[place].push_back(at.corner);
            while (!isLoopEdge(at.side, place)) {
                if (!mLinks.isLinked(at.side)) {
                    mBlockedAt = vertex;
                    return std::nullopt;
                }
                at = mLinks.aroundVertex(at);
                corners[place].push_back(at.corner);
            }
            side = at.side;
        }
        return corners;
    }

    const FaceLinks mLinks;
    const Faces &mFaces;
    const std::span<const std::uint32_t> mLoop;
    std::vector<std::uint32_t> mSides; ///< one of each edge of the loop
    std::uint32_t mBlockedAt = 0;
};

} // namespace

EditResult cutHandle(const Faces &faces, std::span<const Vec3f> positions, std::span<const std::uint32_t> loop,
                     const HoleFilling &filling, const Progress &progress)
{
    const auto moved = LoopCutter(faces, loop).cornersOfOneSide();
    if (!moved)
        return tl::unexpected(moved.error());
    MeshBuilder builder(faces);
    std::unordered_map<std::uint32_t, std::uint32_t> vertexOf; // of corners that move
    std::vector<std::uint32_t> copies;
    for (std::uint32_t i = 0; i < loop.size(); ++i) {
        copies.push_back(builder.addCopy(loop[i]));
        for (const std::uint32_t corner : (*moved)[i])
            vertexOf.emplace(corner, copies.back());
    }
    std::vector<std::uint32_t> face;
    for (std::uint32_t f = 0; f < faces.faceCount(); ++f) {
        face.clear();
        for (std::uint32_t corner = faces.begin(f); corner < faces.end(f); ++corner) {
            const auto at = vertexOf.find(corner);
            face.push_back(at == vertexOf.end() ? faces.vertex(corner) : at->second);
        }
        builder.addFace(face, f);
    }
    const EditedMesh open = std::move(builder).finish();

    // The two new boundary loops are those over the loop's vertices.
    const FaceLinks links(open.faces);
    std::vector<BorderLoop> holes = findBorderLoops(links);
    std::vector<bool> isOfLoop(faces.vertexCount());
    for (const std::uint32_t vertex : loop)
        isOfLoop[vertex] = true;
    std::erase_if(holes, [&](const BorderLoop &hole) {
        return hole.vertices.size() != loop.size() ||
               !std::all_of(hole.vertices.begin(), hole.vertices.end(),
                            [&](std::uint32_t v) { return isOfLoop[open.vertices.copyOf(v)]; });
    });
    auto filled = fillHoles(open.faces, open.vertices.positions(positions), holes, filling, progress);
    if (!filled)
        return tl::unexpected(filled.error());
    return combined(open, std::move(*filled));
}

} // namespace model
