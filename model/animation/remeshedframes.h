// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/mesh/editing/editedmesh.h"

namespace model {

/// An animation after an edit of its mesh, the same in every frame: frames of the source, their vertices taken from
/// where the edit says.
class RemeshedFrames final : public FrameSource
{
public:
    /// \param edit  of Faces(source->connectivity()); its faces become fans
    RemeshedFrames(FrameSourcePtr source, EditedMesh edit);

    std::uint32_t frameCount() const override { return mSource->frameCount(); }
    const Connectivity &connectivity() const override { return mConnectivity; }
    void positions(std::uint32_t frame, std::span<Vec3f> out) const override;
    double frameRate() const override { return mSource->frameRate(); }
    const std::string &name() const override { return mSource->name(); }
    std::uint64_t digest() const override { return mDigest; }
    std::size_t memoryBytes() const override;

    const FrameSourcePtr &source() const { return mSource; }
    const VertexSources &vertices() const { return mVertices; }

private:
    const FrameSourcePtr mSource;
    const Connectivity mConnectivity;
    const VertexSources mVertices;
    std::uint64_t mDigest;
};

} // namespace model
