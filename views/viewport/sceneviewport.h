// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/viewport/cameracontrol.h"

#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLWidget>

class QPainter;

namespace views {

/// What the 3D views have in common: OpenGL 3.3 core, a camera that mouse and keys move and that shows everything until
/// somebody moves it, a background that goes with the palette, and the frame of a view that got the focus by the
/// keyboard. Precondition: glSupport().isSufficient.
class SceneViewport : public QOpenGLWidget
{
    Q_OBJECT

public:
    const model::OrbitCamera &camera() const { return mControl.camera(); }
    void setCamera(const model::OrbitCamera &camera) { mControl.setCamera(camera); }
    void fitView() { mControl.fit(sceneBox()); }
    /// Factor < 1 comes nearer, to the middle of the picture.
    void zoom(float factor) { mControl.zoom(factor); }
    /// What the GPU can draw at once; empty before the widget was shown.
    QSize maximumPictureSize() const { return mMaximumPictureSize; }

    QSize minimumSizeHint() const override { return {160, 120}; }
    QSize sizeHint() const override { return {800, 600}; }

signals:
    void cameraChanged();
    void styleChanged();

protected:
    explicit SceneViewport(QWidget *parent);

    /// All that there is to see.
    virtual model::Box3f sceneBox() const = 0;
    /// What is drawn with, in a context that has just been made. Called again with another context when the widget
    /// moves to another window, as docks do.
    virtual void makeRenderer(QOpenGLFunctions_3_3_Core &gl) = 0;
    /// Frees it; the context is current. Nothing if there is none.
    virtual void freeRenderer() = 0;
    /// The camera has moved.
    virtual void cameraMoved() { update(); }
    /// The background is another one.
    virtual void paletteChanged() { update(); }
    /// What goes before the camera. True: the camera does not hear of the event.
    virtual bool handleFirst(QEvent &) { return false; }

    /// To be called by the destructor of each view: afterwards it is too late for freeRenderer().
    void closeGl();
    void initializeGL() final;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    bool event(QEvent *event) override;

    CameraControl &control() { return mControl; }
    const CameraControl &control() const { return mControl; }
    bool isDark() const;
    QSize pixelSize() const { return size() * devicePixelRatioF(); }
    bool canDraw(QSize picture) const;
    void drawFocus(QPainter &painter) const;
    void drawShaderError(QPainter &painter, const QString &error) const;

private:
    void releaseGl();

    CameraControl mControl;
    QSize mMaximumPictureSize;
    bool mShowsFocus = false; ///< got the focus by the keyboard
};

} // namespace views
