// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/player.h"

#include "views/scene/frameworker.h"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace views {

namespace {

bool isSameState(const model::Playback &a, const model::Playback &b)
{
    return a.isPlaying() == b.isPlaying() && a.framesPerSecond() == b.framesPerSecond() &&
           a.isReversed() == b.isReversed() && a.loopMode() == b.loopMode() && a.pacing() == b.pacing() &&
           a.rangeFirst() == b.rangeFirst() && a.rangeLast() == b.rangeLast() && a.frameCount() == b.frameCount();
}

} // namespace

Player::Player(QObject *parent)
    : QObject(parent)
{
    mTimer.setSingleShot(true);
    mTimer.setTimerType(Qt::PreciseTimer);
    connect(&mTimer, &QTimer::timeout, this, &Player::tick);
    mWorker = std::make_unique<FrameWorker>([this](FrameDataPtr frame, FramePurpose purpose) {
        // Events still queued when the player goes are dropped by QObject.
        QMetaObject::invokeMethod(
            this, [this, frame = std::move(frame), purpose] { receive(frame, purpose); }, Qt::QueuedConnection);
    });
}

Player::~Player() = default;

void Player::setSource(model::FrameSourcePtr source)
{
    if (source == mSource)
        return;
    const model::FrameSourcePtr before = std::exchange(mSource, std::move(source));
    mOriginal.reset();
    mAhead.reset();
    mAheadUse = Ahead::Drop;
    mWorker->cancel();
    if (!mSource)
        mCurrent.reset();
    update([&] {
        mPlayback.setFrameCount(mSource ? mSource->frameCount() : 1);
        if (!mSource)
            mPlayback.stop();
        else if (!before || before->frameRate() != mSource->frameRate())
            mPlayback.setFramesPerSecond(mSource->frameRate());
    });
    emit sourceChanged();
}

void Player::setOriginal(OriginalPtr original)
{
    if (original == mOriginal)
        return;
    mOriginal = std::move(original);
    mAhead.reset();
    mAheadUse = Ahead::Drop;
    requestFrame();
}

bool Player::isFor(const FrameDataPtr &data, std::uint32_t frame) const
{
    return data && data->source == mSource && data->original == mOriginal && data->frame == frame;
}

template <class Change>
void Player::update(Change change)
{
    const model::Playback before = mPlayback;
    change();
    if (mPlayback.frame() != before.frame())
        mAheadUse = Ahead::Drop;
    if (mPlayback.isPlaying() && !before.isPlaying())
        mClock.start();
    requestFrame();
    scheduleTick();
    announce(before);
}

void Player::announce(const model::Playback &before)
{
    if (mPlayback.frame() != before.frame())
        emit frameChanged(mPlayback.frame());
    if (!isSameState(mPlayback, before))
        emit stateChanged();
}

void Player::play()
{
    if (!mSource)
        return;
    mResumeAfterScrub = false;
    update([this] { mPlayback.play(); });
}

void Player::pause()
{
    mResumeAfterScrub = false;
    update([this] { mPlayback.pause(); });
}

void Player::togglePlay()
{
    if (mPlayback.isPlaying())
        pause();
    else
        play();
}

void Player::stop()
{
    mResumeAfterScrub = false;
    update([this] { mPlayback.stop(); });
}

void Player::seek(qint64 frame)
{
    update([&] { mPlayback.seek(frame); });
}

void Player::step(qint64 frames)
{
    update([&] { mPlayback.step(frames); });
}

void Player::goToFirst()
{
    seek(mPlayback.rangeFirst());
}

void Player::goToLast()
{
    seek(mPlayback.rangeLast());
}

void Player::setFramesPerSecond(double rate)
{
    update([&] { mPlayback.setFramesPerSecond(rate); });
}

void Player::setReversed(bool reversed)
{
    update([&] { mPlayback.setReversed(reversed); });
}

void Player::setLoopMode(model::LoopMode mode)
{
    update([&] { mPlayback.setLoopMode(mode); });
}

void Player::setPacing(model::Pacing pacing)
{
    mAwaitingShown = false;
    update([&] { mPlayback.setPacing(pacing); });
}

void Player::setRange(qint64 first, qint64 last)
{
    update([&] { mPlayback.setRange(first, last); });
}

void Player::beginScrub()
{
    if (mScrubbing)
        return;
    mScrubbing = true;
    const bool wasPlaying = mPlayback.isPlaying();
    pause();
    mResumeAfterScrub = wasPlaying;
}

void Player::endScrub()
{
    mScrubbing = false;
    if (!std::exchange(mResumeAfterScrub, false))
        return;
    // Left at the very end, a single pass is over; play() would start it again.
    const bool isOver = mPlayback.loopMode() == model::LoopMode::Once &&
                        mPlayback.frame() == (mPlayback.isReversed() ? mPlayback.rangeFirst() : mPlayback.rangeLast());
    if (!isOver)
        play();
}

void Player::frameShown(std::uint32_t frame)
{
    if (frame != mPlayback.frame() || !std::exchange(mAwaitingShown, false))
        return;
    if (mPlayback.isPlaying() && mPlayback.pacing() == model::Pacing::EveryFrame)
        tick();
}

void Player::tick()
{
    if (!mPlayback.isPlaying() || (mPlayback.pacing() == model::Pacing::EveryFrame && mAwaitingShown))
        return;
    const model::Playback before = mPlayback;
    mPlayback.advance(double(mClock.nsecsElapsed()) * 1e-9);
    mClock.start();
    if (mPlayback.frame() != before.frame()) {
        mAwaitingShown = true;
        noteOvertaking(before);
        requestFrame();
    }
    scheduleTick();
    announce(before);
}

void Player::scheduleTick()
{
    const bool waits = mPlayback.pacing() == model::Pacing::EveryFrame && mAwaitingShown;
    if (!mPlayback.isPlaying() || waits) {
        mTimer.stop();
        return;
    }
    const double passed = double(mClock.nsecsElapsed()) * 1e-9;
    const double seconds = std::max(0.0, mPlayback.secondsToNextFrame() - passed);
    mTimer.start(int(std::ceil(seconds * 1000)));
}

void Player::requestFrame()
{
    if (!mSource)
        return;
    if (isFor(mCurrent, mPlayback.frame())) {
        mWorker->cancel();
        mAwaitingShown = false;
        requestAhead();
    } else if (isFor(mAhead, mPlayback.frame())) {
        mWorker->cancel();
        show(std::exchange(mAhead, nullptr));
    } else {
        mWorker->request(mSource, mOriginal, mPlayback.frame(), FramePurpose::Wanted);
    }
}

void Player::requestAhead()
{
    if (!mPlayback.isPlaying())
        return;
    std::uint64_t steps = 1;
    if (mPlayback.pacing() == model::Pacing::RealTime) // slower than real time: aim at what is due when it is made
        steps = std::uint64_t(std::ceil(mCurrent->computeMilliseconds * 1e-3 * mPlayback.framesPerSecond()));
    const std::uint32_t frame = mPlayback.frameAfter(std::max<std::uint64_t>(steps, 1));
    if (isFor(mAhead, frame) || frame == mPlayback.frame())
        return;
    mAheadUse = Ahead::Keep;
    mAheadFrame = frame;
    mWorker->request(mSource, mOriginal, frame, FramePurpose::Ahead);
}

void Player::noteOvertaking(const model::Playback &before)
{
    constexpr std::uint64_t Farthest = 100; // steps of one tick; more means that the machine slept
    for (std::uint64_t steps = 1; steps < Farthest; ++steps) {
        const std::uint32_t passed = before.frameAfter(steps);
        if (passed == mPlayback.frame())
            return;
        if (passed == mAheadFrame && mAheadUse == Ahead::Keep)
            mAheadUse = Ahead::ShowLate;
    }
}

void Player::receive(const FrameDataPtr &frame, FramePurpose purpose)
{
    if (frame->source != mSource || frame->original != mOriginal)
        return;
    const bool isDue = frame->frame == mPlayback.frame();
    // A frame that comes late is better than a picture that stands, if it is nearer to the one wanted than that
    // picture: on a slow machine one asked for earlier may arrive after one made ahead, and the film would jump back.
    const auto distance = [this](std::uint32_t other) {
        return std::abs(std::int64_t(other) - std::int64_t(mPlayback.frame()));
    };
    const bool isWaiting =
        !mCurrent || mCurrent->source != mSource || distance(frame->frame) < distance(mCurrent->frame);
    if (isDue || (purpose == FramePurpose::Wanted && isWaiting)) {
        show(frame); // if not due, scrubbing or play has gone on
    } else if (purpose == FramePurpose::Ahead && mAheadUse == Ahead::Keep) {
        mAhead = frame;
    } else if (purpose == FramePurpose::Ahead && mAheadUse == Ahead::ShowLate && isWaiting) {
        show(frame);
    }
}

void Player::show(const FrameDataPtr &frame)
{
    mCurrent = frame;
    if (frame->frame == mPlayback.frame())
        requestAhead();
    emit frameReady(frame);
}

} // namespace views
