// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace model {

enum class LoopMode : std::uint8_t { Once, Loop, PingPong };
/// RealTime keeps the clock and drops frames when drawing is slow; EveryFrame shows each one and lets time stretch.
enum class Pacing : std::uint8_t { RealTime, EveryFrame };

/// The state of a player, without clock or window: time is handed in. Frames outside the range clamp to it.
class Playback
{
public:
    static constexpr double MinRate = 1;
    static constexpr double MaxRate = 120;

    /// A paused player on frame 0 with the whole animation as its range. Precondition: frameCount > 0.
    explicit Playback(std::uint32_t frameCount = 1, double framesPerSecond = 25);

    std::uint32_t frameCount() const { return mFrameCount; }
    /// The animation became longer or shorter: range and frame are clamped; a range over all stays over all.
    void setFrameCount(std::uint32_t count);

    std::uint32_t frame() const { return mFrame; }
    /// Any value; clamped to the animation (also outside the loop range, so that a user can look there).
    void seek(std::int64_t frame);
    /// Steps without wrapping, as single-step keys do.
    void step(std::int64_t frames);

    bool isPlaying() const { return mPlaying; }
    /// From outside the range, or in LoopMode::Once from its end, play starts over.
    void play();
    void pause() { mPlaying = false; }
    /// Pause and back to the first frame of the range (the last when playing backwards).
    void stop();

    double framesPerSecond() const { return mRate; }
    void setFramesPerSecond(double rate); ///< clamped to MinRate..MaxRate; no number: ignored
    bool isReversed() const { return mReversed; }
    void setReversed(bool reversed);
    LoopMode loopMode() const { return mLoopMode; }
    void setLoopMode(LoopMode mode);
    Pacing pacing() const { return mPacing; }
    void setPacing(Pacing pacing) { mPacing = pacing; }

    std::uint32_t rangeFirst() const { return mFirst; }
    std::uint32_t rangeLast() const { return mLast; }
    /// Both clamped; swapped if in the wrong order.
    void setRange(std::int64_t first, std::int64_t last);

    /// Time passes. Returns true if frame() changed or play ended (LoopMode::Once ends on reaching the end).
    /// RealTime: moves by whole frames and keeps the rest of the time. EveryFrame: at most one frame per call, and at
    /// most one frame of delay is made up for. Negative times and NaN are ignored.
    bool advance(double seconds);
    /// Seconds until advance() will next do something, at least 0; infinite while paused. For the caller's timer.
    double secondsToNextFrame() const;
    /// The frame that play will show `steps` frames from now; for making frames ahead.
    std::uint32_t frameAfter(std::uint64_t steps) const { return after(steps).frame; }

private:
    struct Place
    {
        std::uint32_t frame;
        bool returning;
        bool ended;
    };
    Place after(std::uint64_t steps) const;
    std::uint32_t clamped(std::int64_t frame) const;
    bool isInRange() const { return mFrame >= mFirst && mFrame <= mLast; }
    std::uint32_t startOfRange() const { return mReversed ? mLast : mFirst; }
    std::uint32_t endOfRange() const { return mReversed ? mFirst : mLast; }

    std::uint32_t mFrameCount;
    std::uint32_t mFrame = 0;
    std::uint32_t mFirst = 0;
    std::uint32_t mLast;
    double mRate;
    double mCarry = 0; ///< seconds since the present frame was due
    bool mPlaying = false;
    bool mReversed = false;
    bool mReturning = false; ///< on the way back of a ping-pong
    LoopMode mLoopMode = LoopMode::Loop;
    Pacing mPacing = Pacing::RealTime;
};

} // namespace model
