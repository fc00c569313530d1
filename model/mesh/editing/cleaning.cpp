// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/editing/cleaning.h"

#include "model/geometry/vec3d.h"
#include "model/mesh/analysis/duplicates.h"
#include "model/mesh/analysis/parts.h"
#include "model/mesh/analysis/vertexfans.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <unordered_map>

namespace model {

namespace {

/// A face without the stretches between equal corners, the shorter ones first: (a, b, a, c, d) becomes (a, c, d).
std::vector<std::uint32_t> withoutRepeats(std::vector<std::uint32_t> face)
{
    for (std::size_t gap = 1; gap <= face.size() / 2; ++gap)
        for (std::size_t i = 0; i < face.size() && gap <= face.size() / 2; ++i)
            if (const std::size_t j = (i + gap) % face.size(); i != j && face[i] == face[j]) {
                std::rotate(face.begin(), face.begin() + std::ptrdiff_t(j),
                            face.end()); // j first, i gap before the end
                face.resize(face.size() - gap);
                gap = 1;
                i = ~std::size_t(0);
            }
    return face;
}

class Unions
{
public:
    explicit Unions(std::uint32_t count)
        : mRoot(count)
    {
        std::iota(mRoot.begin(), mRoot.end(), 0u);
    }
    std::uint32_t rootOf(std::uint32_t i)
    {
        while (mRoot[i] != i)
            i = mRoot[i] = mRoot[mRoot[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b)
    {
        a = rootOf(a);
        b = rootOf(b);
        mRoot[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> mRoot;
};

/// A cell of a grid and its neighbours find all that is within the tolerance.
struct Cell
{
    std::int64_t x, y, z;
    friend bool operator==(const Cell &, const Cell &) = default;
};
struct CellHash
{
    std::size_t operator()(const Cell &c) const
    {
        std::uint64_t hash = 0;
        for (const std::int64_t v : {c.x, c.y, c.z}) {
            hash = (hash ^ std::uint64_t(v)) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 31;
        }
        return std::size_t(hash);
    }
};

bool isNear(Vec3f a, Vec3f b, float tolerance)
{
    return std::abs(a.x - b.x) <= tolerance && std::abs(a.y - b.y) <= tolerance && std::abs(a.z - b.z) <= tolerance;
}

} // namespace

EditedMesh deleteComponents(const Faces &faces, std::span<const std::uint32_t> components)
{
    const FaceLinks links(faces);
    const MeshParts parts = findParts(links);
    const std::set<std::uint32_t> deleted(components.begin(), components.end());
    MeshBuilder builder(faces);
    for (std::uint32_t f = 0; f < faces.faceCount(); ++f)
        if (!deleted.contains(parts.componentOf[f]))
            builder.keepFace(f);
    return std::move(builder).finish();
}

EditedMesh removeDegenerateFaces(const Faces &faces)
{
    MeshBuilder builder(faces);
    for (std::uint32_t f = 0; f < faces.faceCount(); ++f) {
        const auto face = faces.face(f);
        if (!isDegenerate(face)) {
            builder.keepFace(f);
            continue;
        }
        const std::vector<std::uint32_t> rest = withoutRepeats({face.begin(), face.end()});
        if (rest.size() > 2)
            builder.addFace(rest, f);
    }
    return std::move(builder).finish();
}

EditedMesh removeDuplicateFaces(const Faces &faces)
{
    std::vector<bool> isCopy(faces.faceCount());
    for (const ProblemIds &pair : findDuplicateFaces(FaceLinks(faces)))
        isCopy[pair[0]] = true;
    MeshBuilder builder(faces);
    for (std::uint32_t f = 0; f < faces.faceCount(); ++f)
        if (!isCopy[f])
            builder.keepFace(f);
    return std::move(builder).finish();
}

EditedMesh removeIsolatedVertices(const Faces &faces)
{
    MeshBuilder builder(faces);
    for (std::uint32_t f = 0; f < faces.faceCount(); ++f)
        builder.keepFace(f);
    return std::move(builder).finish(true);
}

EditedMesh orientFaces(const Faces &faces, std::span<const Vec3f> positions)
{
    const FaceLinks links(faces);
    MeshParts parts = findParts(links);
    std::vector<double> volume(parts.componentCount());
    std::vector<bool> isClosed(parts.componentCount(), true);
    for (std::uint32_t f = 0; f < faces.faceCount(); ++f) {
        const auto face = faces.face(f);
        double sum = 0;
        for (std::size_t i = 2; i < face.size(); ++i)
            sum += dot(Vec3d(positions[face[0]]), cross(Vec3d(positions[face[i - 1]]), Vec3d(positions[face[i]])));
        volume[parts.componentOf[f]] += parts.isTurned[f] ? -sum : sum;
        for (std::uint32_t side = faces.begin(f); side < faces.end(f); ++side)
            if (!links.isLinked(side))
                isClosed[parts.componentOf[f]] = false;
    }
    MeshBuilder builder(faces);
    std::vector<std::uint32_t> turned;
    for (std::uint32_t f = 0; f < faces.faceCount(); ++f) {
        const std::uint32_t component = parts.componentOf[f];
        const bool turn = parts.isTurned[f] ^ (isClosed[component] && volume[component] < 0);
        if (!turn || !parts.isOrientable[component]) {
            builder.keepFace(f);
            continue;
        }
        const auto face = faces.face(f); // the first corner stays the first
        turned.assign(face.begin(), face.end());
        std::reverse(turned.begin() + 1, turned.end());
        builder.addFace(turned, f);
    }
    return std::move(builder).finish();
}

EditedMesh splitNonManifold(const Faces &faces)
{
    const FaceLinks links(faces);
    // Corners that stay one vertex are united: those joined at a linked edge, or at a pair of sides of a crowded one.
    Unions corners(faces.cornerCount());
    const auto glue = [&](std::uint32_t a, std::uint32_t b) {
        const std::uint32_t aEnd = faces.next(a), bEnd = faces.next(b);
        if (faces.vertex(a) == faces.vertex(b)) {
            corners.join(a, b);
            corners.join(aEnd, bEnd);
        } else {
            corners.join(a, bEnd);
            corners.join(aEnd, b);
        }
    };
    for (std::uint32_t side = 0; side < faces.cornerCount(); ++side)
        if (links.isLinked(side) && side < links.across(side))
            glue(side, links.across(side));
    for (const FaceLinks::CrowdedEdge &edge : links.crowded()) {
        std::array<std::vector<std::uint32_t>, 2> byDirection;
        for (const std::uint32_t side : edge.sides)
            byDirection[faces.vertex(side) == edge.edge[0] ? 0 : 1].push_back(side);
        for (std::size_t i = 0; i < std::min(byDirection[0].size(), byDirection[1].size()); ++i)
            glue(byDirection[0][i], byDirection[1][i]);
    }
    MeshBuilder builder(faces);
    std::vector<std::uint32_t> name(faces.cornerCount(), NoFaceCorner); // of a root
    std::vector<bool> isTaken(faces.vertexCount());
    std::vector<std::uint32_t> face;
    for (std::uint32_t f = 0; f < faces.faceCount(); ++f) {
        face.clear();
        for (std::uint32_t corner = faces.begin(f); corner < faces.end(f); ++corner) {
            std::uint32_t &vertex = name[corners.rootOf(corner)];
            if (vertex == NoFaceCorner) {
                const std::uint32_t before = faces.vertex(corner);
                vertex = isTaken[before] ? builder.addCopy(before) : before;
                isTaken[before] = true;
            }
            face.push_back(vertex);
        }
        builder.addFace(face, f);
    }
    return std::move(builder).finish();
}

EditedMesh weldVertices(const Faces &faces, std::span<const std::span<const Vec3f>> frames, float tolerance)
{
    Unions vertices(faces.vertexCount());
    if (!frames.empty()) {
        // Candidates share a cell of the first frame, or lie in cells side by side.
        const auto cellOf = [&](Vec3f p) {
            const auto place = [&](float c) {
                if (tolerance > 0)
                    return std::int64_t(std::clamp(std::floor(double(c) / double(tolerance)), -9e18, 9e18));
                return std::int64_t(std::bit_cast<std::int32_t>(c + 0.0f)); // -0 is +0
            };
            return Cell{place(p.x), place(p.y), place(p.z)};
        };
        const int reach = tolerance > 0 ? 1 : 0;
        std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells;
        for (std::uint32_t v = 0; v < faces.vertexCount(); ++v) {
            const Cell cell = cellOf(frames[0][v]);
            for (int dx = -reach; dx <= reach; ++dx)
                for (int dy = -reach; dy <= reach; ++dy)
                    for (int dz = -reach; dz <= reach; ++dz) {
                        const auto found = cells.find({cell.x + dx, cell.y + dy, cell.z + dz});
                        if (found == cells.end())
                            continue;
                        for (const std::uint32_t other : found->second)
                            if (std::all_of(frames.begin(), frames.end(), [&](std::span<const Vec3f> frame) {
                                    return isNear(frame[v], frame[other], tolerance);
                                }))
                                vertices.join(v, other);
                    }
            cells[cell].push_back(v);
        }
    }
    MeshBuilder builder(faces);
    std::vector<std::uint32_t> face;
    for (std::uint32_t f = 0; f < faces.faceCount(); ++f) {
        face.clear();
        bool isChanged = false;
        for (const std::uint32_t vertex : faces.face(f)) {
            const std::uint32_t to = vertices.rootOf(vertex);
            isChanged |= to != vertex;
            face.push_back(to);
        }
        if (isChanged && isDegenerate(face) && !isDegenerate(faces.face(f)))
            face = withoutRepeats(std::move(face));
        if (!isChanged || face.size() > 2)
            builder.addFace(face, f);
    }
    return std::move(builder).finish();
}

} // namespace model
