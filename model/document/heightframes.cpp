// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/heightframes.h"

#include "model/base/digest.h"

#include <cassert>

namespace model {

HeightFrames::HeightFrames(Connectivity connectivity, std::vector<Vec3f> places,
                           std::vector<std::vector<float>> heights, double frameRate, std::string name)
    : mConnectivity(std::move(connectivity))
    , mPlaces(std::move(places))
    , mHeights(std::move(heights))
    , mFrameRate(frameRate)
    , mName(std::move(name))
{
    assert(mPlaces.size() == mConnectivity.vertexCount);
    assert(!mHeights.empty() && mHeights.front().size() == mPlaces.size());
    assert(mFrameRate > 0);
}

void HeightFrames::positions(std::uint32_t frame, std::span<Vec3f> out) const
{
    assert(frame < mHeights.size() && out.size() == mPlaces.size());
    const std::vector<float> &heights = mHeights[frame];
    for (std::size_t v = 0; v < out.size(); ++v)
        out[v] = {mPlaces[v].x, heights[v], mPlaces[v].z};
}

std::uint64_t HeightFrames::digest() const
{
    std::call_once(mDigestOnce, [this] {
        const std::uint64_t triangles =
            digestOfArray(std::span<const Triangle>(mConnectivity.triangles), mConnectivity.vertexCount);
        mDigest = digestOfArray(std::span<const Vec3f>(mPlaces), triangles);
        for (const std::vector<float> &heights : mHeights)
            mDigest = digestOfArray(std::span<const float>(heights), mDigest);
    });
    return mDigest;
}

std::size_t HeightFrames::memoryBytes() const
{
    return mHeights.size() * mPlaces.size() * sizeof(float) + mPlaces.capacity() * sizeof(Vec3f) +
           mConnectivity.triangles.capacity() * sizeof(Triangle);
}

} // namespace model
