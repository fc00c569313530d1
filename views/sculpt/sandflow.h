// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/terrain/terraincontext.h"
#include "model/terrain/erosion/erosion.h"
#include "views/sculpt/toolsettings.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <optional>
#include <vector>

namespace views {

/// What is said about sand that slides.
struct FlowFigures
{
    std::size_t activeTriangles = 0;
    double movedPerSecond = 0;      ///< cubic metres
    double movedVolume = 0;         ///< since the flow began
    std::optional<double> steepest; ///< degrees, of all faces; nothing until all were looked at
    double drift = 0;               ///< volume that the ledger does not explain, of the whole
};

/// Lets the sand of one terrain slide, a little in each frame, within the gesture that is open. It keeps what may still
/// move from gesture to gesture; an undo makes it forget.
class SandFlow final : public QObject
{
    Q_OBJECT

public:
    SandFlow(commands::TerrainContext &context, const ToolSettings &settings, QObject *parent = nullptr);

    /// Something was changed by an edit of the gesture: what it touched may slide from now on. Starts the flow if it is
    /// switched on.
    void note(const model::terrain::Edit &edit);
    /// All of the terrain may slide, as a gesture of its own that ends when it rests or pause() is called.
    void run();
    /// The gesture ends; what may still slide is remembered.
    void pause();
    /// One sweep, as a gesture of its own.
    void step();
    bool isRunning() const { return mTimer.isActive(); }
    /// It is all that goes on: nobody draws.
    void setHolding(bool isHeld) { mIsHeld = isHeld; }
    bool isAtRest() const { return !mErosion || mErosion->isAtRest(); }

    const FlowFigures &figures() const { return mFigures; }
    /// What may still slide. Cost: a copy of the list.
    std::vector<model::terrain::TriangleId> activeTriangles() const
    {
        return mErosion ? mErosion->activeTriangles() : std::vector<model::terrain::TriangleId>();
    }

signals:
    void runningChanged(bool isRunning);
    /// At most ten times a second.
    void figuresChanged();
    /// An edit of the gesture was made by the flow.
    void flowed(const model::terrain::Edit &edit);

private:
    bool ensureErosion();
    void forget();
    void start();
    void stop();
    void tick();
    void advance(double seconds, double milliseconds);
    void measure();
    void scan(model::terrain::TriangleId end);

    commands::TerrainContext &mContext;
    const ToolSettings &mSettings;
    std::optional<model::terrain::Erosion> mErosion;
    QTimer mTimer;
    QElapsedTimer mSinceFrame, mSinceFigures, mSinceDrift;
    bool mIsHeld = false;   ///< a pen is down: the gesture is not ours to end
    bool mIsEnding = false; ///< we end the gesture ourselves
    FlowFigures mFigures;
    double mMovedSinceFigures = 0;
    double mRate = 0, mFastest = 0;          ///< cubic metres in a simulated second, in the frame before and at most
    model::terrain::TriangleId mScanned = 0; ///< of the search for the steepest face
    double mSteepest = 0;
};

} // namespace views
