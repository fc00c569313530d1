// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/playback.h"
#include "views/scene/framedata.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <memory>

namespace views {

class FrameWorker;
enum class FramePurpose : std::uint8_t;

/// Plays an animation: drives model::Playback by the clock, has frames made by a worker (the newest request wins, the
/// next frame is made ahead), and hands them to whoever draws. One per open document; viewport and timeline share it.
class Player final : public QObject
{
    Q_OBJECT

public:
    explicit Player(QObject *parent = nullptr);
    ~Player() override;

    /// Shows another animation, or the same one edited; frame and range are clamped. The rate becomes the source's if
    /// that is another than the last source's. Null: nothing to play.
    void setSource(model::FrameSourcePtr source);
    const model::FrameSourcePtr &source() const { return mSource; }

    /// What the frames are compared with from now on; null: with nothing. Forgotten when another source is set.
    /// Precondition: as many frames and vertices as source().
    void setOriginal(OriginalPtr original);
    const OriginalPtr &original() const { return mOriginal; }

    const model::Playback &playback() const { return mPlayback; }
    /// The newest frame that is ready to be drawn; null before the first. For a moment after setSource() still one of
    /// the source before.
    FrameDataPtr currentFrame() const { return mCurrent; }

public slots:
    void play();
    void pause();
    void togglePlay();
    void stop();
    void seek(qint64 frame);
    void step(qint64 frames);
    void goToFirst();
    void goToLast();
    void setFramesPerSecond(double rate);
    void setReversed(bool reversed);
    void setLoopMode(model::LoopMode mode);
    void setPacing(model::Pacing pacing);
    void setRange(qint64 first, qint64 last);
    /// Scrubbing pauses; its end resumes if it was playing.
    void beginScrub();
    void endScrub();
    /// Called by the viewport when a frame is on the screen; paces EveryFrame.
    void frameShown(std::uint32_t frame);

signals:
    void sourceChanged();
    /// playback().frame() moved (the picture may still be on its way).
    void frameChanged(quint32 frame);
    /// A frame is ready to be drawn.
    void frameReady(const views::FrameDataPtr &frame);
    /// Playing, rate, direction, loop mode, pacing or range changed.
    void stateChanged();

private:
    void receive(const FrameDataPtr &frame, FramePurpose purpose);
    void show(const FrameDataPtr &frame);
    void requestFrame();
    void requestAhead();
    void noteOvertaking(const model::Playback &before);
    void tick();
    void scheduleTick();
    /// Runs `change` on the playback and tells of what became different.
    template <class Change>
    void update(Change change);
    /// Emits what differs from `before`.
    void announce(const model::Playback &before);

    /// `data` is what is to be drawn for the frame.
    bool isFor(const FrameDataPtr &data, std::uint32_t frame) const;

    model::FrameSourcePtr mSource;
    OriginalPtr mOriginal;
    model::Playback mPlayback;
    FrameDataPtr mCurrent;
    FrameDataPtr mAhead; ///< made before it is due
    bool mScrubbing = false;
    bool mResumeAfterScrub = false;
    /// What is to become of the frame that is being made ahead: kept until it is due; shown late, since play has
    /// overtaken it and nothing newer is there; or nothing, after a jump.
    enum class Ahead { Keep, ShowLate, Drop } mAheadUse = Ahead::Drop;
    std::uint32_t mAheadFrame = 0;
    bool mAwaitingShown = false; ///< EveryFrame: the present frame is not on the screen yet
    QTimer mTimer;
    QElapsedTimer mClock;
    std::unique_ptr<FrameWorker> mWorker; ///< last: its thread ends before the rest goes
};

} // namespace views
