// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/camera.h"

#include <QObject>
#include <QPointF>

class QEvent;
class QKeyEvent;
class QMouseEvent;
class QWidget;

namespace views {

/// Turns what a user does with mouse, keys and touchpad over a 3D view into movements of its camera, alike in every
/// view: orbit (left drag, arrow keys), pan (middle or Shift+left drag, Shift+arrows), zoom (wheel, pinch, right drag,
/// + and -), fit (F, Home, double click). A member of its view, not a child: a view may not hear of its children while
/// they are being made.
class CameraControl final : public QObject
{
    Q_OBJECT

public:
    /// \param view  whose events come to handle(); its size is the picture's
    explicit CameraControl(QWidget &view);

    const model::OrbitCamera &camera() const { return mCamera; }
    void setCamera(const model::OrbitCamera &camera);
    /// Factor < 1 comes nearer, to the middle of the picture.
    void zoom(float factor);
    /// Shows all of `box`. The camera is then nobody's again: isMoved() is false.
    void fit(const model::Box3f &box);
    /// Someone other than fit() has moved the camera since.
    bool isMoved() const { return mIsMoved; }
    float aspect() const;

    /// The left button belongs to a tool: the right one does what it did, orbit and pan.
    void setLeftButtonTaken(bool taken) { mIsLeftTaken = taken; }
    bool isDragging() const { return mDrag != Drag::None; }
    void endDrag() { mDrag = Drag::None; }

    /// True if the event was meant for the camera.
    bool handle(QEvent &event);

signals:
    void moved();
    /// The user wants to see everything: who knows what that is calls fit().
    void fitAsked();

private:
    enum class Drag { None, Orbit, Pan, Zoom };

    bool press(const QMouseEvent &event);
    bool drag(const QMouseEvent &event);
    bool pressKey(const QKeyEvent &event);
    void zoomAt(float factor, QPointF place);
    void noteMove();

    QWidget &mView;
    model::OrbitCamera mCamera;
    Drag mDrag = Drag::None;
    QPointF mDragPlace;
    bool mIsLeftTaken = false;
    bool mIsMoved = false;
};

} // namespace views
