// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/animationdocument.h"

#include "model/animation/settingsfields.h"
#include "model/base/digest.h"

#include <cassert>
#include <utility>

namespace model {

AnimationDocument::AnimationDocument(FrameSourcePtr source, CompressionSettings settings, QObject *parent)
    : QObject(parent)
    , mSource(std::move(source))
    , mTiming{TimeMap::identity(mSource->frameCount()), mSource->frameRate()}
    , mName(mSource->name())
    , mCompression(settings)
{
    rebuildFrames();
}

Timing AnimationDocument::setTiming(Timing timing)
{
    if (timing == mTiming)
        return timing;
    Timing old = std::exchange(mTiming, std::move(timing));
    rebuildFrames();
    emit changed(TimingChanged{});
    return old;
}

Similarity AnimationDocument::setPlacement(const Similarity &placement)
{
    if (placement == mPlacement)
        return placement;
    const Similarity old = std::exchange(mPlacement, placement);
    rebuildFrames();
    emit changed(PlacementChanged{});
    return old;
}

std::string AnimationDocument::setName(std::string name)
{
    if (name == mName)
        return name;
    std::string old = std::exchange(mName, std::move(name));
    rebuildFrames();
    emit changed(NameChanged{});
    return old;
}

CompressionSettings AnimationDocument::setCompression(const CompressionSettings &settings)
{
    if (settings == mCompression)
        return settings;
    const CompressionSettings old = std::exchange(mCompression, settings);
    emit changed(CompressionChanged{});
    return old;
}

std::uint64_t AnimationDocument::fingerprint() const
{
    std::uint64_t digest = digestOfArray(mTiming.map.sourcePositions(), mSource->digest());
    const double numbers[] = {mTiming.frameRate, mPlacement.scale, mPlacement.offset[0], mPlacement.offset[1],
                              mPlacement.offset[2]};
    digest = digestOfArray(std::span<const double>(numbers), digest);
    const std::string compression = settingsText(mCompression);
    digest = digestOfArray(std::span<const char>(compression), digest);
    return digestOfArray(std::span<const char>(mName), digest);
}

void AnimationDocument::rebuildFrames()
{
    mFrames = std::make_shared<const EditedFrames>(mSource, mTiming.map, mPlacement, mTiming.frameRate, mName);
}

} // namespace model
