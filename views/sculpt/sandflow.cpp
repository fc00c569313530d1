// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sculpt/sandflow.h"

#include "model/terrain/tin/query/surface.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace views {

using namespace model::terrain;

namespace {

constexpr int FrameMilliseconds = 16;
constexpr int FiguresMilliseconds = 200;
/// The volume of a million vertices takes 10 to 20 ms to add up: what is larger than this is measured when the flow
/// stops, and not while frames have to keep their time.
constexpr int DriftMilliseconds = 2000;
constexpr std::uint32_t LargestMeasured = 200000;
/// Faces looked at in a frame, for the steepest one: a third of a millisecond.
constexpr TriangleId ScanPerFrame = 10000;
/// What flows slower than this part of the fastest is not seen any more, and takes as many sweeps to end as it took to
/// come there, or a thousand times that in a corner that is narrow: it gets all the sweeps that its milliseconds hold.
constexpr double Unseen = 1e-3;
constexpr double HurriedSpeed = 1000;
/// A face less high than this part of its length is a sliver.
constexpr double Sliver = 1e-6;
/// A frame that came late is not caught up with.
constexpr double LongestFrame = 0.05;

} // namespace

SandFlow::SandFlow(commands::TerrainContext &context, const ToolSettings &settings, QObject *parent)
    : QObject(parent)
    , mContext(context)
    , mSettings(settings)
{
    mTimer.setInterval(FrameMilliseconds);
    mTimer.setTimerType(Qt::PreciseTimer);
    connect(&mTimer, &QTimer::timeout, this, &SandFlow::tick);
    connect(&mSettings, &ToolSettings::flowChanged, this, &SandFlow::forget);
    connect(&mContext, &commands::TerrainContext::gestureEnded, this, [this] {
        if (mIsEnding)
            return;
        // Undone, or another command comes: what lies on the list may be gone.
        stop();
        mErosion.reset();
    });
    connect(&mContext.document(), &model::TerrainDocument::changed, this, [this](const model::TerrainChange &change) {
        if (std::holds_alternative<model::MaterialsChanged>(change))
            forget();
    });
}

/// The list is lost with the erosion that had it; the flow itself goes on with the new settings.
void SandFlow::forget()
{
    const bool wasRunning = isRunning();
    mErosion.reset();
    if (wasRunning && ensureErosion())
        mErosion->activateAll(mContext.document().tin());
}

bool SandFlow::ensureErosion()
{
    if (mErosion)
        return true;
    auto erosion = Erosion::create(mSettings.flow().erosion, mContext.document().terrain().materials);
    if (erosion)
        mErosion = std::move(*erosion);
    return erosion.has_value();
}

void SandFlow::note(const Edit &edit)
{
    if (!mSettings.flow().isOn || !ensureErosion())
        return;
    mErosion->activate(mContext.document().tin(), edit);
    start();
}

void SandFlow::start()
{
    if (mTimer.isActive())
        return;
    mFigures = {};
    mMovedSinceFigures = 0;
    mFastest = mRate = 0;
    mScanned = 0;
    mSteepest = 0;
    mSinceFrame.start();
    mSinceFigures.start();
    mSinceDrift.start();
    mTimer.start();
    emit runningChanged(true);
}

void SandFlow::stop()
{
    if (!mTimer.isActive())
        return;
    mTimer.stop();
    mFigures.movedPerSecond = 0;
    mFigures.activeTriangles = mErosion ? mErosion->activeCount() : 0;
    measure();
    if (const TinArrays &tin = mContext.document().tin().arrays(); tin.totals.vertices <= LargestMeasured) {
        mScanned = 0;
        mSteepest = 0;
        scan(tin.triangleSlots());
    }
    emit runningChanged(false);
    emit figuresChanged();
}

void SandFlow::run()
{
    if (!ensureErosion())
        return;
    mContext.beginGesture(QCoreApplication::translate("Undo", "Let Sand Slide"));
    if (!ensureErosion()) // the gesture before has taken it along
        return;
    mErosion->activateAll(mContext.document().tin());
    start();
}

void SandFlow::pause()
{
    mIsEnding = true;
    stop();
    mContext.endGesture();
    mIsEnding = false;
}

void SandFlow::step()
{
    pause();
    if (!ensureErosion())
        return;
    if (mErosion->isAtRest())
        mErosion->activateAll(mContext.document().tin());
    mContext.beginGesture(QCoreApplication::translate("Undo", "Let Sand Slide One Step"));
    advance(1 / mSettings.flow().erosion.sweepsPerSecond + 1e-9, 1e9);
    pause();
    measure();
    mFigures.activeTriangles = mErosion ? mErosion->activeCount() : 0;
    emit figuresChanged();
}

void SandFlow::advance(double seconds, double milliseconds)
{
    ErosionStatistics statistics;
    const Edit *const edit = mContext.edit([&](TinEdit &open) {
        if (const auto done = mErosion->run(open, seconds, {.milliseconds = milliseconds}))
            statistics = *done;
    });
    mFigures.movedVolume += statistics.movedVolume;
    mMovedSinceFigures += statistics.movedVolume;
    if (edit)
        emit flowed(*edit);
}

void SandFlow::tick()
{
    if (!mContext.hasGesture() || !ensureErosion())
        return stop();
    const double elapsed = std::min(double(mSinceFrame.nsecsElapsed()) * 1e-9, LongestFrame);
    mSinceFrame.start();
    const double seconds = elapsed * mSettings.flow().speed, moved = mFigures.movedVolume;
    advance(mRate < Unseen * mFastest ? seconds * HurriedSpeed : seconds, mSettings.flow().milliseconds);
    mRate = (mFigures.movedVolume - moved) / std::max(seconds, 1e-9);
    mFastest = std::max(mFastest, mRate);
    const TinArrays &tin = mContext.document().tin().arrays();
    scan(std::min(mScanned + ScanPerFrame, tin.triangleSlots()));
    if (mSinceFigures.elapsed() >= FiguresMilliseconds) {
        mFigures.movedPerSecond = mMovedSinceFigures * 1e3 / double(mSinceFigures.restart());
        mMovedSinceFigures = 0;
        mFigures.activeTriangles = mErosion->activeCount();
        if (mSinceDrift.elapsed() >= DriftMilliseconds && tin.totals.vertices <= LargestMeasured) {
            mSinceDrift.restart();
            measure();
        }
        emit figuresChanged();
    }
    if (mErosion->isAtRest()) {
        if (mIsHeld)
            stop();
        else
            pause();
    }
}

/// Looks for the steepest face up to `end`; after the last one the figure is known. Slivers, whose vertices lie in a
/// line but for their rounding, have any slope.
void SandFlow::scan(TriangleId end)
{
    const TinArrays &tin = mContext.document().tin().arrays();
    for (; mScanned < end; ++mScanned) {
        if (!tin.isTriangle(mScanned) || tin.isVoid(mScanned))
            continue;
        const Point2 a = tin.pointAt(cornerOf(mScanned, 0)), b = tin.pointAt(cornerOf(mScanned, 1)),
                     c = tin.pointAt(cornerOf(mScanned, 2));
        const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
        if (!(ux * vy - uy * vx > Sliver * std::max(ux * ux + uy * uy, vx * vx + vy * vy)))
            continue;
        const Gradient g = gradientOf(tin, mScanned);
        mSteepest = std::max(mSteepest, g.x * g.x + g.y * g.y);
    }
    if (mScanned >= tin.triangleSlots()) {
        mFigures.steepest = std::atan(std::sqrt(mSteepest)) * 180 / M_PI;
        mScanned = 0;
        mSteepest = 0;
    }
}

/// What the ledger does not explain, in parts of the volume.
void SandFlow::measure()
{
    const Tin &tin = mContext.document().tin();
    const double volume = tin.volume(), expected = tin.ledger().expected();
    mFigures.drift = (volume - expected) / std::max(std::abs(expected), 1e-300);
}

} // namespace views
