// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/playback.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace model {

namespace {

/// More steps than any animation has frames; keeps a long sleep of the machine within integers.
constexpr double MaxSteps = 1e15;

} // namespace

Playback::Playback(std::uint32_t frameCount, double framesPerSecond)
    : mFrameCount(std::max(frameCount, 1u))
    , mLast(mFrameCount - 1)
    , mRate(std::clamp(framesPerSecond, MinRate, MaxRate))
{}

void Playback::setFrameCount(std::uint32_t count)
{
    const bool wholeRange = mFirst == 0 && mLast == mFrameCount - 1;
    mFrameCount = std::max(count, 1u);
    mLast = wholeRange ? mFrameCount - 1 : std::min(mLast, mFrameCount - 1);
    mFirst = std::min(mFirst, mLast);
    mFrame = std::min(mFrame, mFrameCount - 1);
}

void Playback::seek(std::int64_t frame)
{
    mFrame = clamped(frame);
    mCarry = 0;
}

void Playback::step(std::int64_t frames)
{
    const auto reach = std::int64_t(mFrameCount);
    seek(std::int64_t(mFrame) + std::clamp(frames, -reach, reach));
}

void Playback::play()
{
    if (!isInRange() || (mLoopMode == LoopMode::Once && mFrame == endOfRange())) {
        mFrame = startOfRange();
        mReturning = false;
    }
    mCarry = 0;
    mPlaying = true;
}

void Playback::stop()
{
    mPlaying = false;
    mReturning = false;
    seek(startOfRange());
}

void Playback::setFramesPerSecond(double rate)
{
    if (!(rate > 0))
        return;
    const double wanted = std::clamp(rate, MinRate, MaxRate);
    mCarry *= mRate / wanted; // the same share of a frame has passed
    mRate = wanted;
}

void Playback::setReversed(bool reversed)
{
    mReversed = reversed;
}

void Playback::setLoopMode(LoopMode mode)
{
    if (mode != mLoopMode)
        mReturning = false;
    mLoopMode = mode;
}

void Playback::setRange(std::int64_t first, std::int64_t last)
{
    mFirst = clamped(std::min(first, last));
    mLast = clamped(std::max(first, last));
}

bool Playback::advance(double seconds)
{
    if (!mPlaying || !(seconds >= 0))
        return false;
    mCarry += seconds;
    double steps = std::min(std::floor(mCarry * mRate), MaxSteps);
    if (steps < 1)
        return false;
    if (mPacing == Pacing::EveryFrame) {
        steps = 1;
        // At most one frame of delay is made up for: time stretches, it does not pile up.
        mCarry = std::min(mCarry - 1 / mRate, 1 / mRate);
    } else {
        mCarry -= steps / mRate;
    }
    mCarry = std::clamp(mCarry, 0.0, 1 / mRate);
    const Place next = after(std::uint64_t(steps));
    const bool moved = next.frame != mFrame;
    mFrame = next.frame;
    mReturning = next.returning;
    if (next.ended) {
        mPlaying = false;
        mCarry = 0;
    }
    return moved || next.ended;
}

double Playback::secondsToNextFrame() const
{
    return mPlaying ? std::max(0.0, 1 / mRate - mCarry) : std::numeric_limits<double>::infinity();
}

std::uint32_t Playback::clamped(std::int64_t frame) const
{
    return std::uint32_t(std::clamp<std::int64_t>(frame, 0, std::int64_t(mFrameCount) - 1));
}

Playback::Place Playback::after(std::uint64_t steps) const
{
    if (steps == 0)
        return {mFrame, mReturning, false};
    // Progress along the direction of play, 0 at the start of the range.
    std::uint64_t progress = mReversed ? std::uint64_t(mLast) - mFrame : std::uint64_t(mFrame) - mFirst;
    bool returning = mReturning;
    if (!isInRange()) { // the next frame is where the range starts
        progress = 0;
        returning = false;
        --steps;
    }
    const std::uint64_t length = std::uint64_t(mLast) - mFirst + 1;
    bool ended = false;
    switch (mLoopMode) {
    case LoopMode::Once:
        progress = std::min(progress + steps, length - 1);
        ended = progress == length - 1;
        break;
    case LoopMode::Loop:
        progress = (progress + steps) % length;
        break;
    case LoopMode::PingPong: {
        // There and back as one round, its two ends shown once.
        const std::uint64_t round = std::max<std::uint64_t>(2 * (length - 1), 1);
        const std::uint64_t place = ((returning ? round - progress : progress) + steps) % round;
        returning = place >= length;
        progress = returning ? round - place : place;
        break;
    }
    }
    return {std::uint32_t(mReversed ? mLast - progress : mFirst + progress), returning, ended};
}

} // namespace model
