// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"

#include <mutex>
#include <vector>

namespace model {

/// An animation whose vertices move up and down only: their places, and a height for each of them in each frame.
/// 4 V F bytes: a third of what a Sequence takes.
class HeightFrames final : public FrameSource
{
public:
    /// \param places   #V; y is not used
    /// \param heights  #F of #V
    /// Preconditions: as for Sequence.
    HeightFrames(Connectivity connectivity, std::vector<Vec3f> places, std::vector<std::vector<float>> heights,
                 double frameRate, std::string name);

    std::uint32_t frameCount() const override { return std::uint32_t(mHeights.size()); }
    const Connectivity &connectivity() const override { return mConnectivity; }
    void positions(std::uint32_t frame, std::span<Vec3f> out) const override;
    double frameRate() const override { return mFrameRate; }
    const std::string &name() const override { return mName; }
    std::uint64_t digest() const override;
    std::size_t memoryBytes() const override;

private:
    const Connectivity mConnectivity;
    const std::vector<Vec3f> mPlaces;
    const std::vector<std::vector<float>> mHeights;
    const double mFrameRate;
    const std::string mName;
    mutable std::once_flag mDigestOnce;
    mutable std::uint64_t mDigest = 0;
};

} // namespace model
