// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/sequence.h"

#include "model/base/digest.h"
#include "model/base/parallel.h"

#include <algorithm>
#include <cassert>

namespace model {

Sequence::Sequence(Connectivity connectivity, std::vector<Vec3f> positions, double frameRate, std::string name)
    : mConnectivity(std::move(connectivity))
    , mPositions(std::move(positions))
    , mFrameCount(mConnectivity.vertexCount ? std::uint32_t(mPositions.size() / mConnectivity.vertexCount) : 0)
    , mFrameRate(frameRate)
    , mName(std::move(name))
{
    assert(mFrameCount > 0 && "a sequence has at least one vertex and one frame");
    assert(mPositions.size() == std::size_t(mFrameCount) * mConnectivity.vertexCount && "whole frames only");
    assert(mFrameRate > 0);
}

void Sequence::positions(std::uint32_t frame, std::span<Vec3f> out) const
{
    assert(out.size() == vertexCount());
    std::ranges::copy(frameView(frame), out.begin());
}

std::uint64_t Sequence::digest() const
{
    std::call_once(mDigestOnce, [this] {
        const std::uint64_t seed = mConnectivity.vertexCount;
        const std::uint64_t triangles = digestOfArray(std::span<const Triangle>(mConnectivity.triangles), seed);
        mDigest = digestOfArray(std::span<const Vec3f>(mPositions), triangles);
    });
    return mDigest;
}

std::size_t Sequence::memoryBytes() const
{
    return mPositions.capacity() * sizeof(Vec3f) + mConnectivity.triangles.capacity() * sizeof(Triangle);
}

std::span<const Vec3f> Sequence::frameView(std::uint32_t frame) const
{
    assert(frame < mFrameCount);
    return std::span(mPositions).subspan(std::size_t(frame) * vertexCount(), vertexCount());
}

std::shared_ptr<const Sequence> toSequence(const FrameSourcePtr &source)
{
    if (auto sequence = std::dynamic_pointer_cast<const Sequence>(source))
        return sequence;
    const std::size_t vertexCount = source->vertexCount();
    std::vector<Vec3f> positions(vertexCount * source->frameCount());
    parallelFor(source->frameCount(), [&](std::size_t frame) {
        source->positions(std::uint32_t(frame), std::span(positions).subspan(frame * vertexCount, vertexCount));
    });
    return std::make_shared<Sequence>(source->connectivity(), std::move(positions), source->frameRate(),
                                      source->name());
}

} // namespace model
