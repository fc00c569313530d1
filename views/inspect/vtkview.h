// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/viewport/cameracontrol.h"

#include <QOpenGLWidget>

#include <optional>

#include <vtkNew.h>

class QPainter;
class vtkGenericOpenGLRenderWindow;
class vtkObject;
class vtkRenderer;

namespace views {

/// Draws one VTK renderer with Qt's own OpenGL context. The camera is moved as in every other view of the program, by a
/// CameraControl; VTK gets no events. Private to views/inspect, as all of VTK.
/// Precondition: glSupport().isSufficient.
class VtkView : public QOpenGLWidget
{
    Q_OBJECT

public:
    explicit VtkView(QWidget *parent = nullptr);
    ~VtkView() override;

    vtkRenderer &renderer() { return *mRenderer; }
    /// Drawn over the picture, whatever hides it there, with the same camera.
    vtkRenderer &frontRenderer() { return *mFrontRenderer; }
    const model::OrbitCamera &camera() const { return mControl.camera(); }
    void setCamera(const model::OrbitCamera &camera) { mControl.setCamera(camera); }
    /// All that is drawn: near and far planes hold it. Fits it as long as nobody has moved the camera.
    void setSceneBox(const model::Box3f &box);
    /// Shows all of `box`.
    void fit(const model::Box3f &box) { mControl.fit(box); }
    void fitView() { mControl.fit(mSceneBox); }

    /// From the eye through a place of the widget: where the ray starts, and its direction of length 1.
    struct Ray
    {
        model::Vec3f origin, direction;
    };
    Ray rayAt(QPointF place) const;
    /// Where a point is seen in the widget; nothing for what lies behind the eye.
    std::optional<QPointF> placeOf(const model::Vec3f &point) const;

    /// Of the last picture: milliseconds that VTK took for it.
    double drawMilliseconds() const { return mDrawMilliseconds; }
    QSize minimumSizeHint() const override { return {160, 120}; }
    QSize sizeHint() const override { return {640, 480}; }

signals:
    void cameraMoved();
    /// A click of the left button that moved nothing.
    void clicked(QPointF place, Qt::KeyboardModifiers modifiers);
    void paletteChanged();

protected:
    /// Over the picture.
    virtual void drawOverlay(QPainter &) {}

    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    bool event(QEvent *event) override;
    void changeEvent(QEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void vtkAsks(vtkObject *, unsigned long asked, void *answer);
    void release();
    void placeCamera();

    vtkNew<vtkGenericOpenGLRenderWindow> mWindow;
    vtkNew<vtkRenderer> mRenderer, mFrontRenderer;
    CameraControl mControl;
    model::Box3f mSceneBox;
    QPointF mPressed;
    bool mMayBeClick = false;
    bool mShowsFocus = false; ///< got the focus by the keyboard
    double mDrawMilliseconds = 0;
};

} // namespace views
