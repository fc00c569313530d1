// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/remeshedframes.h"

#include "model/base/digest.h"

#include <algorithm>

namespace model {

namespace {

std::uint64_t digestOfEdit(const VertexSources &vertices, const Connectivity &connectivity, std::uint64_t seed)
{
    std::uint64_t digest = digestOfArray(std::span<const Triangle>(connectivity.triangles), seed);
    for (std::uint32_t v = 0; v < vertices.count(); ++v)
        digest = digestOfArray(vertices.of(v), digest);
    return digest;
}

} // namespace

RemeshedFrames::RemeshedFrames(FrameSourcePtr source, EditedMesh edit)
    : mSource(std::move(source))
    , mConnectivity(fans(edit.faces))
    , mVertices(std::move(edit.vertices))
    , mDigest(digestOfEdit(mVertices, mConnectivity, mSource->digest()))
{}

void RemeshedFrames::positions(std::uint32_t frame, std::span<Vec3f> out) const
{
    const std::vector<Vec3f> positions = mVertices.positions(mSource->frame(frame));
    std::copy(positions.begin(), positions.end(), out.begin());
}

std::size_t RemeshedFrames::memoryBytes() const
{
    std::size_t shares = 0;
    for (std::uint32_t v = 0; v < mVertices.count(); ++v)
        shares += mVertices.of(v).size();
    return mSource->memoryBytes() + mConnectivity.triangles.size() * sizeof(Triangle) +
           shares * sizeof(VertexSources::Share) + mVertices.count() * sizeof(std::size_t);
}

} // namespace model
