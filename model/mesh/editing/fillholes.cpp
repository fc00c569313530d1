// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/editing/fillholes.h"

#include "model/mesh/editing/cgalholes.h"
#include "model/mesh/editing/fairing.h"
#include "model/mesh/vertexedges.h"

#include <algorithm>
#include <optional>
#include <set>
#include <unordered_map>

namespace model {

namespace {

using Share = VertexSources::Share;

/// All points' mean, joined to every edge of the loop: what can always be done.
HolePatch fanPatch(std::span<const Vec3d> loop)
{
    HolePatch patch;
    const auto count = std::uint32_t(loop.size());
    Vec3d sum;
    for (std::uint32_t i = 0; i < count; ++i) {
        patch.triangles.push_back({i, (i + 1) % count, count});
        sum = sum + loop[i];
    }
    patch.added.push_back(sum * (1.0 / double(count)));
    return patch;
}

class HoleFiller
{
public:
    HoleFiller(const Faces &faces, std::span<const Vec3f> positions, const HoleFilling &filling)
        : mFaces(faces)
        , mPositions(positions)
        , mFilling(filling)
        , mBuilder(faces)
    {
        for (std::uint32_t f = 0; f < faces.faceCount(); ++f)
            mBuilder.keepFace(f);
        if (filling.isSmooth)
            mEdges.emplace(fans(faces));
    }

    void fill(const BorderLoop &hole)
    {
        // The lid runs along the loop against the faces there.
        std::vector<std::uint32_t> loop = hole.vertices;
        if (mFaces.vertex(hole.sides.front()) == loop.front())
            std::reverse(loop.begin(), loop.end());
        std::vector<Vec3d> points;
        for (const std::uint32_t vertex : loop)
            points.push_back(mPositions[vertex]);
        HolePatch patch = triangulateLoop(points, mFilling.isSmooth);
        if (patch.triangles.empty())
            patch = fanPatch(points);
        orient(patch, std::uint32_t(loop.size()));

        std::vector<std::uint32_t> names = loop;
        for (const std::vector<Share> &shares : sharesOf(patch, loop))
            names.push_back(mBuilder.addMean(shares));
        for (const Triangle &t : patch.triangles)
            mBuilder.addFace(std::array{names[t[0]], names[t[1]], names[t[2]]}, EditedMesh::NewFace);
    }

    EditedMesh finish() && { return std::move(mBuilder).finish(); }

private:
    /// Turns the lid so that it runs along the loop.
    static void orient(HolePatch &patch, std::uint32_t count)
    {
        for (const Triangle &t : patch.triangles)
            for (unsigned i = 0; i < 3; ++i) {
                const std::uint32_t a = t[i], b = t[(i + 1) % 3];
                if (a >= count || b >= count)
                    continue;
                if (b == (a + 1) % count)
                    return;
                if (a == (b + 1) % count) {
                    for (Triangle &turned : patch.triangles)
                        std::swap(turned[1], turned[2]);
                    return;
                }
            }
    }

    /// Where the lid's new vertices are, as means of vertices of the mesh.
    std::vector<std::vector<Share>> sharesOf(const HolePatch &patch, const std::vector<std::uint32_t> &loop) const
    {
        if (patch.added.empty())
            return {};
        // A graph of the lid, the loop, and the ring of vertices around it: what lies farther has no say.
        std::unordered_map<std::uint32_t, std::uint32_t> local;
        std::vector<std::uint32_t> vertices = loop;
        for (std::uint32_t i = 0; i < loop.size(); ++i)
            local.emplace(loop[i], i);
        const auto addedCount = std::uint32_t(patch.added.size());
        const auto firstAdded = std::uint32_t(loop.size());
        vertices.resize(loop.size() + addedCount);
        std::vector<std::set<std::uint32_t>> neighbours(vertices.size());
        const auto join = [&](std::uint32_t a, std::uint32_t b) {
            neighbours[a].insert(b);
            neighbours[b].insert(a);
        };
        for (const Triangle &t : patch.triangles)
            for (unsigned i = 0; i < 3; ++i)
                join(t[i], t[(i + 1) % 3]);
        if (mEdges)
            for (std::uint32_t i = 0; i < firstAdded; ++i)
                for (const std::uint32_t edge : mEdges->at(loop[i])) {
                    const std::uint32_t other = mEdges->otherEnd(edge, loop[i]);
                    const auto [at, isNew] = local.emplace(other, std::uint32_t(vertices.size()));
                    if (isNew) {
                        vertices.push_back(other);
                        neighbours.emplace_back();
                    }
                    join(i, at->second);
                }
        std::vector<std::uint32_t> free;
        for (std::uint32_t i = 0; i < addedCount; ++i)
            free.push_back(firstAdded + i);
        std::vector<std::vector<std::uint32_t>> lists;
        for (const std::set<std::uint32_t> &set : neighbours)
            lists.emplace_back(set.begin(), set.end());
        std::vector<std::vector<Share>> shares = fairingWeights(lists, free);
        if (shares.size() != addedCount) { // nothing holds it
            const float weight = 1.0f / float(loop.size());
            shares.assign(addedCount, {});
            for (std::vector<Share> &list : shares)
                for (std::uint32_t i = 0; i < firstAdded; ++i)
                    list.push_back({i, weight});
        }
        for (std::vector<Share> &list : shares)
            for (Share &share : list)
                share.vertex = vertices[share.vertex];
        return shares;
    }

    const Faces &mFaces;
    const std::span<const Vec3f> mPositions;
    const HoleFilling mFilling;
    MeshBuilder mBuilder;
    std::optional<VertexEdges> mEdges;
};

} // namespace

EditResult fillHoles(const Faces &faces, std::span<const Vec3f> positions, std::span<const BorderLoop> holes,
                     const HoleFilling &filling, const Progress &progress)
{
    HoleFiller filler(faces, positions, filling);
    for (std::size_t i = 0; i < holes.size(); ++i) {
        if (progress.isCancelled())
            return failEdit(EditError::Kind::Cancelled);
        if (holes[i].isClosed && holes[i].vertices.size() > 2)
            filler.fill(holes[i]);
        progress.report(double(i + 1) / double(holes.size()));
    }
    return std::move(filler).finish();
}

} // namespace model
