// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/animation/playback.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <memory>
#include <vector>

namespace views {

/// What is drawn for one frame; immutable once made.
struct FrameData
{
    std::uint32_t frame = 0;
    std::vector<model::Vec3f> positions; ///< #V x 3
    std::vector<model::Vec3f> normals;   ///< #V x 3, unit
    double computeMilliseconds = 0;      ///< decoding and normals
};
using FrameDataPtr = std::shared_ptr<const FrameData>;

/// Plays an animation: drives model::Playback by the clock, makes frames in a worker (the newest request wins, the next
/// frame is made ahead), and hands them to whoever draws. One per open document; viewport and timeline share it.
class Player final : public QObject
{
    Q_OBJECT

public:
    explicit Player(QObject *parent = nullptr);
    ~Player() override;

    /// Shows another animation, or the same one edited; frame and range are clamped.
    void setSource(model::FrameSourcePtr source);
    const model::FrameSourcePtr &source() const { return mSource; }

    const model::Playback &playback() const { return mPlayback; }
    /// The newest frame that is ready to be drawn; null before the first.
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
    // Replaced or extended by the implementation as it needs.
    model::FrameSourcePtr mSource;
    model::Playback mPlayback;
    FrameDataPtr mCurrent;
};

} // namespace views
