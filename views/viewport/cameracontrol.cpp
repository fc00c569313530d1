// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/viewport/cameracontrol.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QWheelEvent>
#include <QWidget>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

/// Zoom by one notch of a wheel or one press of a key; three notches halve the distance.
constexpr float ZoomStep = 0.79f;
constexpr float NotchDegrees = 15;
/// Turn of an arrow key, as a share of the picture's height: 15 degrees.
constexpr float KeyTurn = 15.0f / 180;
constexpr float KeyPan = 0.05f;

bool isArrow(int key)
{
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

} // namespace

CameraControl::CameraControl(QWidget &view)
    : mView(view)
{}

void CameraControl::setCamera(const model::OrbitCamera &camera)
{
    mCamera = camera;
    noteMove();
}

void CameraControl::zoom(float factor)
{
    mCamera.zoom(factor);
    noteMove();
}

void CameraControl::fit(const model::Box3f &box)
{
    mCamera.fit(box, aspect());
    mIsMoved = false;
    emit moved();
}

float CameraControl::aspect() const
{
    return float(std::max(mView.width(), 1)) / float(std::max(mView.height(), 1));
}

void CameraControl::noteMove()
{
    mIsMoved = true;
    emit moved();
}

void CameraControl::zoomAt(float factor, QPointF place)
{
    const QPointF fromMiddle = (place - QPointF(mView.width(), mView.height()) / 2) / std::max(mView.height(), 1);
    mCamera.zoomAt(factor, float(fromMiddle.x()), float(fromMiddle.y()));
    noteMove();
}

bool CameraControl::handle(QEvent &event)
{
    switch (event.type()) {
    case QEvent::MouseButtonPress:
        return press(static_cast<QMouseEvent &>(event));
    case QEvent::MouseMove:
        return drag(static_cast<QMouseEvent &>(event));
    case QEvent::MouseButtonRelease: {
        const bool wasDragging = isDragging();
        if (static_cast<QMouseEvent &>(event).buttons() == Qt::NoButton)
            endDrag();
        return wasDragging;
    }
    case QEvent::MouseButtonDblClick:
        if (static_cast<QMouseEvent &>(event).button() != Qt::LeftButton)
            return press(static_cast<QMouseEvent &>(event));
        if (mIsLeftTaken)
            return false;
        emit fitAsked();
        return true;
    case QEvent::Wheel: {
        const auto &wheel = static_cast<QWheelEvent &>(event);
        const float notches = float(wheel.angleDelta().y()) / (8 * NotchDegrees);
        if (notches != 0)
            zoomAt(std::pow(ZoomStep, notches), wheel.position());
        event.accept();
        return true;
    }
    case QEvent::NativeGesture: {
        const auto &gesture = static_cast<QNativeGestureEvent &>(event);
        if (gesture.gestureType() != Qt::ZoomNativeGesture)
            return false;
        zoomAt(float(1 / std::clamp(1 + gesture.value(), 0.1, 10.0)), gesture.position());
        return true;
    }
    case QEvent::ShortcutOverride: // with the focus here the arrow keys are the camera's, whatever else they do
        if (!isArrow(static_cast<QKeyEvent &>(event).key()))
            return false;
        event.accept();
        return true;
    case QEvent::KeyPress:
        return pressKey(static_cast<QKeyEvent &>(event));
    default:
        return false;
    }
}

bool CameraControl::press(const QMouseEvent &event)
{
    if (isDragging())
        return true; // a second button during a drag changes nothing
    const Qt::MouseButton orbiting = mIsLeftTaken ? Qt::RightButton : Qt::LeftButton;
    if (event.button() == orbiting)
        mDrag = event.modifiers() & Qt::ShiftModifier ? Drag::Pan : Drag::Orbit;
    else if (event.button() == Qt::MiddleButton)
        mDrag = Drag::Pan;
    else if (event.button() == Qt::RightButton)
        mDrag = Drag::Zoom;
    else
        return false;
    mDragPlace = event.position();
    return true;
}

bool CameraControl::drag(const QMouseEvent &event)
{
    if (!isDragging())
        return false;
    const QPointF moved = (event.position() - mDragPlace) / std::max(mView.height(), 1);
    mDragPlace = event.position();
    const auto dx = float(moved.x()), dy = float(moved.y());
    if (mDrag == Drag::Orbit)
        mCamera.orbit(dx, dy);
    else if (mDrag == Drag::Pan)
        mCamera.pan(dx, dy);
    else
        mCamera.zoom(std::pow(4.0f, dy));
    noteMove();
    return true;
}

bool CameraControl::pressKey(const QKeyEvent &event)
{
    const bool pans = event.modifiers() & Qt::ShiftModifier;
    const auto move = [&](float x, float y) {
        if (pans)
            mCamera.pan(x * KeyPan, y * KeyPan);
        else
            mCamera.orbit(x * KeyTurn, y * KeyTurn);
        noteMove();
    };
    switch (event.key()) {
    case Qt::Key_Left:
        move(-1, 0);
        return true;
    case Qt::Key_Right:
        move(1, 0);
        return true;
    case Qt::Key_Up:
        move(0, -1);
        return true;
    case Qt::Key_Down:
        move(0, 1);
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoom(ZoomStep);
        return true;
    case Qt::Key_Minus:
        zoom(1 / ZoomStep);
        return true;
    case Qt::Key_F:
    case Qt::Key_Home:
        emit fitAsked();
        return true;
    default:
        return false;
    }
}

} // namespace views
