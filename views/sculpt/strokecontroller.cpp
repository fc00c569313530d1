// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sculpt/strokecontroller.h"

#include "model/io/errortext.h"
#include "views/sculpt/tooloutline.h"
#include "views/sculpt/toolvalues.h"

#include <QElapsedTimer>
#include <QKeyEvent>

#include <algorithm>
#include <cmath>

namespace views {

using namespace model::terrain;

namespace {

/// What stamps of one event, or of one frame, may take; those that are due then come in the next one.
constexpr qint64 StampNanoseconds = 5'000'000;
/// Between two frames of stamps that are due.
constexpr int FrameMilliseconds = 8;
/// A pen held flatter than this, in degrees from the vertical, draws wider: twice as wide when it lies.
constexpr double UprightTilt = 30, FlatTilt = 60;
/// Pixels of a drag that double what a stamp does.
constexpr double DoublingPixels = 100;

} // namespace

StrokeController::StrokeController(commands::TerrainContext &context, ToolSettings &settings, GroundView *view,
                                   QObject *parent)
    : QObject(parent)
    , mContext(context)
    , mSettings(settings)
    , mView(view)
    , mFlow(context, settings)
    , mReference(context.document())
{
    mDrawing.setInterval(FrameMilliseconds);
    connect(&mDrawing, &QTimer::timeout, this, &StrokeController::drawDue);
    connect(&mFlow, &SandFlow::flowed, this, [this](const Edit &edit) {
        if (mStroke)
            mStroke->note(edit);
    });
    connect(&mContext, &commands::TerrainContext::gestureEnded, this, [this] {
        if (!mIsEnding)
            abandon(); // undone in the midst of it
    });
    connect(&mSettings, &ToolSettings::toolChanged, this, &StrokeController::updateLines);
}

StrokeController::~StrokeController()
{
    cancel();
}

void StrokeController::setActive(bool isActive)
{
    if (isActive == mIsActive)
        return;
    cancel();
    mIsActive = isActive;
    updateLines();
}

OwnerId StrokeController::nextOwner()
{
    // Owners of strokes that were undone are not used again: their constraints may come back.
    if (mNextOwner == None)
        mNextOwner = nextFreeOwner(mContext.document().tin());
    return mNextOwner;
}

Tool StrokeController::toolFor(const GroundEvent &event) const
{
    Tool tool = mSettings.tool();
    if (event.modifiers & Qt::ShiftModifier)
        tool = smoothing(tool);
    else if (event.modifiers & Qt::AltModifier)
        tool = lifting(tool);
    else if ((event.modifiers & Qt::ControlModifier) || event.isEraser)
        tool = inverted(tool);
    if (const Mask *const mask = mMask && mMask->value() ? maskOf(tool) : nullptr) {
        Mask painted = *mask;
        painted.paint = mMask->value();
        views::setMask(tool, painted);
    }
    const double tilt = std::hypot(event.xTilt, event.yTilt);
    if (event.isPen && tilt > UprightTilt)
        setRadius(tool, radiusOf(tool) * (1 + std::min(1.0, (tilt - UprightTilt) / (FlatTilt - UprightTilt))));
    return tool;
}

bool StrokeController::press(const GroundEvent &event)
{
    if (!mIsActive || (mStroke && !mStroke->isEnded())) // another device draws: this one may move the camera
        return false;
    if (mAdjusting != Adjusting::Nothing) {
        mAdjusting = Adjusting::Nothing; // the click that ends it
        updateLines();
        return true;
    }
    Tool tool = toolFor(event);
    if (std::holds_alternative<Restore>(tool) && !mReference.terrain()) {
        emit strokeRefused(tr("The ground to restore is still being copied. Try again in a moment."));
        return true;
    }
    mIsEnding = true;
    mFlow.pause(); // what slides still goes on, as part of this gesture
    const Terrain &terrain = mContext.document().terrain();
    const Point2 at{event.point.x, event.point.y};
    if (auto *restore = std::get_if<Restore>(&tool))
        restore->reference.tin = std::shared_ptr<const Tin>(mReference.terrain(), &mReference.terrain()->tin);
    if (auto *imprint = std::get_if<Imprint>(&tool); imprint && imprint->isRimOfMaterial && event.isOnTerrain)
        if (const Material *const material = terrain.topMaterialAt(at))
            imprint->rim = rimOf(*material, imprint->rim);
    mContext.beginGesture(titleOf(tool));
    mIsEnding = false;
    auto stroke = LiveStroke::begin(mContext.document().tin(), tool, mSettings.symmetry(), nextOwner());
    if (!stroke) {
        mContext.endGesture();
        emit strokeRefused(model::io::errorText(stroke.error()));
        return true;
    }
    mStroke = std::move(*stroke);
    mFlow.setHolding(true);
    mSpeed = 0;
    mLast.reset();
    add(event);
    return true;
}

double StrokeController::speedAt(const GroundEvent &event)
{
    if (!mLast || event.time <= mLast->time)
        return mSpeed;
    const double way = std::hypot(event.point.x - mLast->point.x, event.point.y - mLast->point.y);
    const double speed = way * 1e3 / double(event.time - mLast->time);
    return mSpeed += 0.3 * (speed - mSpeed);
}

void StrokeController::add(const GroundEvent &event)
{
    const PathPoint point{{event.point.x, event.point.y},
                          std::clamp(event.isPen ? event.pressure : 1.0, 0.0, 1.0),
                          std::max(0.0, speedAt(event))};
    mLast = event;
    if (const auto added = mStroke->add(point); !added) {
        emit strokeRefused(model::io::errorText(added.error()));
        finish();
        return;
    }
    drawDue();
    updateLines();
    showReading(event);
}

void StrokeController::drawDue()
{
    if (!mStroke || !mStroke->isDue()) {
        mDrawing.stop();
        return;
    }
    QElapsedTimer clock;
    clock.start();
    model::Result<void> drawn;
    const Edit *const edit = mContext.edit(
        [&](TinEdit &open) {
            do
                drawn = mStroke->draw(open, mMemory, 1);
            while (drawn && mStroke->isDue() && clock.nsecsElapsed() < StampNanoseconds);
            if (!drawn)
                open.rollBack();
        },
        VolumeRule::Keep);
    mNextOwner = std::max(mNextOwner, mStroke->report().nextOwner);
    if (edit) {
        mStroke->note(*edit);
        mFlow.note(*edit);
    }
    if (!drawn) {
        emit strokeRefused(model::io::errorText(drawn.error()));
        return cancel();
    }
    if (mStroke->isDue()) {
        mDrawing.start();
    } else {
        mDrawing.stop();
        if (mStroke->isEnded())
            finish();
    }
}

void StrokeController::move(const GroundEvent &event)
{
    if (mStroke && !mStroke->isEnded())
        add(event);
    else
        hover(event);
}

void StrokeController::release(const GroundEvent &event)
{
    if (!mStroke || mStroke->isEnded())
        return;
    // A pen that is lifted presses no more: its last point counts with the pressure before.
    GroundEvent last = event;
    last.pressure = mLast ? mLast->pressure : event.pressure;
    add(last);
    if (!mStroke)
        return;
    mStroke->end();
    if (mStroke->isDue())
        drawDue();
    else
        finish();
}

/// All stamps are made. The gesture goes on as long as sand slides.
void StrokeController::finish()
{
    mDrawing.stop();
    const StrokeReport report = mStroke->report();
    mStroke.reset();
    mFlow.setHolding(false);
    if (!mFlow.isRunning()) {
        mIsEnding = true;
        mFlow.pause();
        mIsEnding = false;
    }
    updateLines();
    emit strokeEnded(report);
}

/// The gesture is gone.
void StrokeController::abandon()
{
    mDrawing.stop();
    mStroke.reset();
    mFlow.setHolding(false);
    updateLines();
}

void StrokeController::cancel()
{
    if (mAdjusting != Adjusting::Nothing) {
        mAdjusting = Adjusting::Nothing;
        mSettings.setTool(mBeforeAdjusting);
    }
    if (!mStroke)
        return;
    abandon();
    mContext.cancelGesture();
}

void StrokeController::adjust(const GroundEvent &event)
{
    const double pixels = event.position.x() - mAdjustFrom.position.x();
    Tool tool = mBeforeAdjusting;
    if (mAdjusting == Adjusting::Radius)
        setRadius(tool, radiusOf(tool) + pixels * mAdjustFrom.metresPerPixel);
    else if (amountKindOf(tool) == AmountKind::Share)
        setAmount(tool, amountOf(tool) + pixels / (2 * DoublingPixels));
    else
        setAmount(tool, amountOf(tool) * std::exp2(pixels / DoublingPixels));
    mSettings.setTool(tool);
}

void StrokeController::hover(const GroundEvent &event)
{
    if (mAdjusting != Adjusting::Nothing)
        return adjust(event);
    if (mStroke && !mStroke->isEnded())
        return; // another device draws
    mLast = event;
    showReading(event);
    updateLines();
}

void StrokeController::leave()
{
    if (mStroke)
        return;
    mLast.reset();
    emit readingChanged(std::nullopt);
    updateLines();
}

bool StrokeController::keyPress(const QKeyEvent &event)
{
    const bool isQuestion = event.type() == QEvent::ShortcutOverride;
    switch (event.key()) {
    case Qt::Key_F:
        if (!mIsActive || (event.modifiers() & ~Qt::ShiftModifier) || !mLast || mStroke)
            return false;
        if (!isQuestion) {
            mAdjustFrom = *mLast;
            mBeforeAdjusting = mSettings.tool();
            mAdjusting = (event.modifiers() & Qt::ShiftModifier) ? Adjusting::Amount : Adjusting::Radius;
        }
        return true;
    case Qt::Key_Escape:
        if (mAdjusting == Adjusting::Nothing)
            return false;
        if (!isQuestion)
            cancel();
        return true;
    default:
        return false;
    }
}

void StrokeController::showReading(const GroundEvent &event)
{
    emit readingChanged(readingAt(mContext.document().terrain(), event));
}

void StrokeController::updateLines()
{
    if (mView)
        mView->updateLines();
}

std::vector<GroundLine> StrokeController::lines() const
{
    if (!mIsActive)
        return {};
    std::vector<GroundLine> lines = axesOf(mSettings.symmetry(), mContext.document().tin().domain());
    if (!mLast)
        return lines;
    const Tool tool = mStroke ? mStroke->tool() : toolFor(mAdjusting == Adjusting::Nothing ? *mLast : mAdjustFrom);
    const GroundEvent &at = mAdjusting == Adjusting::Nothing ? *mLast : mAdjustFrom;
    const Symmetry &symmetry = mSettings.symmetry();
    for (std::uint32_t i = 0; i < symmetry.count(); ++i)
        for (GroundLine line : outlineOf(tool, {at.point.x, at.point.y}, at.metresPerPixel)) {
            for (Point2 &p : line.points)
                p = symmetry.copyOf(p, i);
            if (i > 0)
                line.color.setAlphaF(0.5f);
            lines.push_back(std::move(line));
        }
    if (mStroke && (std::holds_alternative<Ramp>(tool) || std::holds_alternative<Breakline>(tool)))
        lines.push_back(pathOf(tool, mStroke->path()));
    return lines;
}

} // namespace views
