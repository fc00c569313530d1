// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/grounddispatcher.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QWheelEvent>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace views {

namespace {

constexpr double NotchAngle = 120; // in eighths of a degree
/// Logical pixels that an arrow key moves the cursor by, and with Shift.
constexpr double KeyStep = 6, LargeKeyStep = 48;

void describe(GroundEvent &ground, const QSinglePointEvent &event)
{
    ground.position = event.position();
    ground.button = event.button();
    ground.modifiers = event.modifiers();
    ground.time = event.timestamp();
}

} // namespace

void GroundDispatcher::setInteraction(GroundInteraction *interaction)
{
    cancelStroke();
    leave();
    mInteraction = interaction;
}

void GroundDispatcher::cancelStroke()
{
    mIsKeyStroke = false;
    if (std::exchange(mIsStroking, false))
        mInteraction->cancel();
}

bool GroundDispatcher::begin(const std::optional<GroundEvent> &ground)
{
    if (!ground || mIsStroking)
        return mIsStroking;
    mIsStroking = mInteraction->press(*ground);
    mLast = ground;
    return mIsStroking;
}

void GroundDispatcher::end(const std::optional<GroundEvent> &ground)
{
    mIsKeyStroke = false;
    // Let go over the sky: where the ground was last.
    if (std::exchange(mIsStroking, false))
        mInteraction->release(ground ? *ground : *mLast);
}

void GroundDispatcher::hover(const std::optional<GroundEvent> &ground)
{
    if (!ground)
        return leave();
    mIsHovering = true;
    mInteraction->hover(*ground);
}

void GroundDispatcher::leave()
{
    if (std::exchange(mIsHovering, false) && mInteraction)
        mInteraction->leave();
}

bool GroundDispatcher::handle(QEvent &event)
{
    if (!mInteraction)
        return false;
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
        return handleMouse(static_cast<QMouseEvent &>(event));
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
        return handleTablet(static_cast<QTabletEvent &>(event));
    case QEvent::Wheel: {
        const auto &wheel = static_cast<QWheelEvent &>(event);
        // Alt turns a vertical wheel into a horizontal one.
        const QPoint angle = wheel.angleDelta();
        const double notches = (angle.y() != 0 ? angle.y() : angle.x()) / NotchAngle;
        auto ground = mFind(wheel.position());
        if (!ground || notches == 0)
            return false;
        describe(*ground, wheel);
        return mInteraction->wheel(*ground, notches);
    }
    case QEvent::ShortcutOverride: {
        const auto &key = static_cast<QKeyEvent &>(event);
        if (key.key() == Qt::Key_Escape && mIsStroking) {
            event.accept();
            return true;
        }
        if (!takesKey(key) && !mInteraction->keyPress(key))
            return false;
        event.accept();
        return true;
    }
    case QEvent::KeyPress:
        if (static_cast<QKeyEvent &>(event).key() == Qt::Key_Escape && mIsStroking) {
            cancelStroke();
            return true;
        }
        if (takesKey(static_cast<QKeyEvent &>(event)))
            return handleKey(static_cast<QKeyEvent &>(event));
        return mInteraction->keyPress(static_cast<QKeyEvent &>(event));
    case QEvent::KeyRelease:
        return mInteraction->keyRelease(static_cast<QKeyEvent &>(event));
    case QEvent::Leave:
        leave();
        return false;
    case QEvent::FocusOut:
    case QEvent::Hide:
        cancelStroke();
        return false;
    default:
        return false;
    }
}

bool GroundDispatcher::handleMouse(const QMouseEvent &event)
{
    auto ground = mFind(event.position());
    if (ground)
        describe(*ground, event);
    if (!mIsKeyStroke)
        mPlace = event.position();
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: // the second press of two
        if (event.button() == Qt::RightButton && mIsStroking) {
            cancelStroke();
            mIgnoresRight = true;
            return true;
        }
        if (mIsStroking)
            return true;
        return event.button() == Qt::LeftButton && isActive() && begin(ground);
    case QEvent::MouseButtonRelease:
        if (event.button() == Qt::RightButton && std::exchange(mIgnoresRight, false))
            return true;
        if (event.button() != Qt::LeftButton || !mIsStroking || mIsPenStroke || mIsKeyStroke)
            return mIsStroking;
        end(ground);
        return true;
    default:
        if (mIsStroking) {
            if (ground && !mIsPenStroke && !mIsKeyStroke) {
                mLast = ground;
                mInteraction->move(*ground);
            }
            return true;
        }
        if (event.buttons() == Qt::NoButton)
            hover(ground);
        return false;
    }
}

bool GroundDispatcher::handleTablet(const QTabletEvent &event)
{
    if (!isActive())
        return false; // comes again as a mouse event, for the camera
    auto ground = mFind(event.position());
    if (ground) {
        describe(*ground, event);
        ground->isPen = true;
        ground->isEraser = event.pointerType() == QPointingDevice::PointerType::Eraser;
        ground->pressure = event.pressure();
        ground->xTilt = event.xTilt();
        ground->yTilt = event.yTilt();
    }
    switch (event.type()) {
    case QEvent::TabletPress:
        if (event.button() == Qt::RightButton && mIsStroking) { // the pen's button
            cancelStroke();
            return true;
        }
        if (event.button() != Qt::LeftButton)
            return false;
        mIsPenStroke = begin(ground);
        return mIsPenStroke;
    case QEvent::TabletRelease:
        if (event.button() != Qt::LeftButton || !std::exchange(mIsPenStroke, false))
            return false;
        end(ground);
        return true;
    default:
        if (mIsStroking && mIsPenStroke) {
            if (ground) {
                mLast = ground;
                mInteraction->move(*ground);
            }
            return true;
        }
        if (event.buttons() != Qt::NoButton)
            return false;
        hover(ground);
        return true;
    }
}

bool GroundDispatcher::takesKey(const QKeyEvent &event) const
{
    if (!isActive() || (mIsStroking && !mIsKeyStroke))
        return false;
    switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down: // with Ctrl they are the camera's
        return !(event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return true;
    default:
        return false;
    }
}

bool GroundDispatcher::handleKey(const QKeyEvent &event)
{
    const bool isPress = event.key() == Qt::Key_Space || event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    if (isPress && event.isAutoRepeat())
        return true;
    QPointF place = mPlace.value_or(QRectF(mView.rect()).center());
    const double step = event.modifiers() & Qt::ShiftModifier ? LargeKeyStep : KeyStep;
    if (event.key() == Qt::Key_Left || event.key() == Qt::Key_Right)
        place.rx() += event.key() == Qt::Key_Left ? -step : step;
    else if (!isPress)
        place.ry() += event.key() == Qt::Key_Up ? -step : step;
    place = {std::clamp(place.x(), 0.0, double(mView.width())), std::clamp(place.y(), 0.0, double(mView.height()))};
    auto ground = mFind(place);
    if (!ground)
        return true; // the sky: the cursor stays
    mPlace = place;
    ground->position = place;
    ground->isByKeys = true;
    ground->time = event.timestamp();
    if (isPress) {
        ground->modifiers = event.modifiers() & ~Qt::KeypadModifier; // of the arrows, Shift is their step
        if (mIsKeyStroke)
            end(ground);
        else
            mIsKeyStroke = begin(ground);
    } else if (mIsKeyStroke) {
        mLast = ground;
        mInteraction->move(*ground);
    } else {
        hover(ground);
    }
    return true;
}

} // namespace views
