// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/animation/timemap.h"
#include "model/geometry/similarity.h"

namespace model {

/// Another source seen through a time map and a placement, under another name and rate. Holds no positions of its own.
/// A whole source position costs what the source costs, a fraction twice that; the placement is applied to the blend.
class EditedFrames final : public FrameSource
{
public:
    /// Precondition: every position of `timeMap` is at most source->frameCount() - 1.
    EditedFrames(FrameSourcePtr source, TimeMap timeMap, Similarity placement, double frameRate, std::string name);

    std::uint32_t frameCount() const override { return mTimeMap.frameCount(); }
    const Connectivity &connectivity() const override { return mSource->connectivity(); }
    void positions(std::uint32_t frame, std::span<Vec3f> out) const override;
    double frameRate() const override { return mFrameRate; }
    const std::string &name() const override { return mName; }
    /// That of the source while keepsFrames(); else made from it and the edits.
    std::uint64_t digest() const override;
    std::size_t memoryBytes() const override { return mSource->memoryBytes(); }

    const FrameSourcePtr &source() const { return mSource; }
    const TimeMap &timeMap() const { return mTimeMap; }
    /// What is done to each position of the source.
    const Similarity &placement() const { return mPlacement; }
    /// True if the frames are those of the source, untouched: then an `.anim` need not be encoded again.
    bool keepsFrames() const { return mPlacement.isIdentity() && mTimeMap.isIdentity(mSource->frameCount()); }

private:
    FrameSourcePtr mSource;
    TimeMap mTimeMap;
    Similarity mPlacement;
    double mFrameRate;
    std::string mName;
};

} // namespace model
