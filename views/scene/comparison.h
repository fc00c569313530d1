// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/metrics.h"
#include "views/jobs/job.h"
#include "views/scene/player.h"

#include <QObject>

#include <optional>

namespace views {

/// What an open animation lost of its original, measured in the background. It belongs to the view of the document, not
/// to the document: it is neither saved nor undone. When the animation is edited it measures anew, by itself.
class Comparison final : public QObject
{
    Q_OBJECT

public:
    /// Measures the player's source, and gives it the original as soon as they are known to match.
    explicit Comparison(Player &player, QObject *parent = nullptr);

    /// Reads an original in the background, then compares with it. Drops the original before.
    /// \param read  gives the original; runs in another thread
    /// \param name  for people
    void start(const QString &name, std::function<model::Result<Original>(const model::Progress &)> read);
    /// Drops original and result.
    void stop();
    /// Stops reading or measuring; a result that is there stays, without one all is as after stop().
    void cancel();

    /// There is something to show: an original, or one being read.
    bool isActive() const { return mIsActive; }
    bool isReading() const { return mIsActive && !mOriginal; }
    bool isMeasuring() const { return mOriginal && mMeasuring.isRunning(); }
    double fraction() const { return isReading() ? mReading.fraction() : mMeasuring.fraction(); }
    const QString &originalName() const { return mName; }
    /// Of the present frames; empty while they are being measured, and if they do not match.
    const std::optional<model::ComparisonResult> &result() const { return mResult; }
    /// Why the present frames and the original cannot be compared: an edit has changed their number.
    const std::optional<model::Error> &mismatch() const { return mMismatch; }

signals:
    void changed();
    void progressed(double fraction);
    /// The original could not be read, or does not match; there is no comparison then.
    /// \param name  of the original
    void failed(const QString &name, const model::Error &error);

private:
    void giveUp(const model::Error &error);
    void measure();
    /// The original with the order of vertices that fits, and what was measured.
    struct Measured
    {
        OriginalPtr original;
        model::ComparisonResult errors;
    };
    static model::Result<Measured> measureMatched(OriginalPtr original, const model::FrameSource &test,
                                                  const model::Progress &progress);
    void measured(model::Result<Measured> result);
    void sourceChanged();

    Player &mPlayer;
    QString mName;
    OriginalPtr mOriginal;
    std::optional<model::ComparisonResult> mResult;
    std::optional<model::Error> mMismatch;
    bool mIsActive = false;
    bool mIsFirst = false; ///< the original has not matched yet
    // Last: destroyed first, so that no result comes to what is half gone.
    Job mReading;
    Job mMeasuring;
};

} // namespace views
