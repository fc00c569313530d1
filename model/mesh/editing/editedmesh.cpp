// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/editing/editedmesh.h"

#include "model/base/parallel.h"
#include "model/geometry/vec3d.h"

#include <array>

namespace model {

std::uint32_t VertexSources::copyOf(std::uint32_t vertex) const
{
    const auto shares = of(vertex);
    return shares.size() == 1 ? shares[0].vertex : NoSource;
}

void VertexSources::addCopy(std::uint32_t vertex)
{
    addMean(std::array{Share{vertex, 1.0f}});
}

void VertexSources::addMean(std::span<const Share> shares)
{
    mShares.insert(mShares.end(), shares.begin(), shares.end());
    mBegins.push_back(mShares.size());
}

std::vector<Vec3f> VertexSources::positions(std::span<const Vec3f> before) const
{
    std::vector<Vec3f> result(count());
    constexpr std::size_t Grain = 1 << 12; // vertices
    parallelRanges(count(), Grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const auto shares = of(std::uint32_t(v));
            if (shares.size() == 1) {
                result[v] = before[shares[0].vertex];
                continue;
            }
            Vec3d sum;
            for (const Share &share : shares)
                sum = sum + Vec3d(before[share.vertex]) * double(share.weight);
            result[v] = {float(sum.x), float(sum.y), float(sum.z)};
        }
    });
    return result;
}

VertexSources VertexSources::followedBy(const VertexSources &later) const
{
    VertexSources result;
    std::vector<Share> shares;
    for (std::uint32_t v = 0; v < later.count(); ++v) {
        shares.clear();
        for (const Share &outer : later.of(v))
            for (const Share &inner : of(outer.vertex))
                shares.push_back({inner.vertex, outer.weight * inner.weight});
        result.addMean(shares);
    }
    return result;
}

VertexSources VertexSources::identity(std::uint32_t count)
{
    VertexSources result;
    for (std::uint32_t v = 0; v < count; ++v)
        result.addCopy(v);
    return result;
}

bool EditedMesh::isUnchanged(const Faces &before) const
{
    if (!(faces == before))
        return false;
    for (std::uint32_t v = 0; v < vertices.count(); ++v)
        if (vertices.copyOf(v) != v)
            return false;
    return true;
}

EditedMesh combined(const EditedMesh &first, EditedMesh later)
{
    later.vertices = first.vertices.followedBy(later.vertices);
    for (std::uint32_t &from : later.faceFrom)
        if (from != EditedMesh::NewFace)
            from = first.faceFrom[from];
    return later;
}

MeshBuilder::MeshBuilder(const Faces &before)
    : mBefore(before)
{
    mResult.faces.reserve(before.faceCount(), before.cornerCount());
    mResult.faceFrom.reserve(before.faceCount());
}

std::uint32_t MeshBuilder::addCopy(std::uint32_t vertex)
{
    mNew.addCopy(vertex);
    return mBefore.vertexCount() + mNew.count() - 1;
}

std::uint32_t MeshBuilder::addMean(std::span<const VertexSources::Share> shares)
{
    mNew.addMean(shares);
    return mBefore.vertexCount() + mNew.count() - 1;
}

void MeshBuilder::addFace(std::span<const std::uint32_t> corners, std::uint32_t from)
{
    mResult.faces.add(corners);
    mResult.faceFrom.push_back(from);
}

EditedMesh MeshBuilder::finish(bool dropIsolated) &&
{
    const std::uint32_t oldCount = mBefore.vertexCount(), count = oldCount + mNew.count();
    std::vector<bool> isKept(count, false), wasUsed(oldCount, false);
    for (const std::uint32_t vertex : mBefore.vertices())
        wasUsed[vertex] = true;
    for (const std::uint32_t vertex : mResult.faces.vertices())
        isKept[vertex] = true;
    std::vector<std::uint32_t> names(count);
    for (std::uint32_t v = 0; v < count; ++v) {
        if (!isKept[v] && (v >= oldCount || wasUsed[v] || dropIsolated))
            continue;
        names[v] = mResult.vertices.count();
        if (v < oldCount)
            mResult.vertices.addCopy(v);
        else
            mResult.vertices.addMean(mNew.of(v - oldCount));
    }
    mResult.faces.setVertexCount(mResult.vertices.count());
    mResult.faces.renameVertices(names);
    return std::move(mResult);
}

} // namespace model
