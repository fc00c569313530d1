// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"

#include <mutex>
#include <vector>

namespace model {

/// An animation with all its positions in memory, as float32: 12 V F bytes. Not copyable: share it.
class Sequence final : public FrameSource
{
public:
    /// \param positions  #F*V, frame after frame
    /// Preconditions: positions.size() is a positive multiple of connectivity.vertexCount, which is above zero; indices
    /// in range; frameRate > 0.
    Sequence(Connectivity connectivity, std::vector<Vec3f> positions, double frameRate = 25.0, std::string name = {});

    std::uint32_t frameCount() const override { return mFrameCount; }
    const Connectivity &connectivity() const override { return mConnectivity; }
    void positions(std::uint32_t frame, std::span<Vec3f> out) const override;
    double frameRate() const override { return mFrameRate; }
    const std::string &name() const override { return mName; }
    std::uint64_t digest() const override;
    std::size_t memoryBytes() const override;

    /// One frame without a copy.
    std::span<const Vec3f> frameView(std::uint32_t frame) const;
    std::span<const Vec3f> allPositions() const { return mPositions; }

private:
    Connectivity mConnectivity;
    std::vector<Vec3f> mPositions;
    std::uint32_t mFrameCount;
    double mFrameRate;
    std::string mName;
    mutable std::once_flag mDigestOnce;
    mutable std::uint64_t mDigest = 0;
};

/// The whole of `source` as a Sequence; the same object if it is one.
std::shared_ptr<const Sequence> toSequence(const FrameSourcePtr &source);

} // namespace model
