// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspect/vtkview.h"

#include <QElapsedTimer>
#include <QFocusEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLVersionFunctionsFactory>
#include <QPainter>

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include <cmath>
#include <numbers>

namespace views {

namespace {

constexpr double ClickDistance = 4; ///< pixels that a click may move

} // namespace

VtkView::VtkView(QWidget *parent)
    : QOpenGLWidget(parent)
    , mControl(*this)
{
    setFocusPolicy(Qt::StrongFocus);
    setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);
    // Qt owns the context and the framebuffer: VTK draws into one of its own, which paintGL() copies.
    mWindow->SetReadyForRendering(false);
    mWindow->SetOwnContext(0);
    mWindow->SetMultiSamples(0);
    mWindow->SetFrameBlitModeToNoBlit();
    mWindow->AddRenderer(mRenderer);
    mWindow->SetNumberOfLayers(2);
    mFrontRenderer->SetLayer(1);
    mFrontRenderer->SetActiveCamera(mRenderer->GetActiveCamera());
    mWindow->AddRenderer(mFrontRenderer);
    for (const auto asked : {vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent,
                             vtkCommand::WindowSupportsOpenGLEvent, vtkCommand::WindowIsDirectEvent})
        mWindow->AddObserver(asked, this, &VtkView::vtkAsks);
    connect(&mControl, &CameraControl::moved, this, [this] {
        update();
        emit cameraMoved();
    });
    connect(&mControl, &CameraControl::fitAsked, this, &VtkView::fitView);
}

VtkView::~VtkView()
{
    if (context())
        disconnect(context(), nullptr, this, nullptr); // aboutToBeDestroyed comes when this is gone
    makeCurrent();
    release();
    mWindow->RemoveAllObservers();
    mWindow->RemoveRenderer(mFrontRenderer);
    mWindow->RemoveRenderer(mRenderer);
    doneCurrent();
}

void VtkView::release()
{
    if (!mWindow->GetReadyForRendering())
        return;
    mWindow->Finalize();
    mWindow->SetReadyForRendering(false);
}

void VtkView::vtkAsks(vtkObject *, unsigned long asked, void *answer)
{
    const bool isCurrent = context() && QOpenGLContext::currentContext() == context();
    switch (asked) {
    case vtkCommand::WindowMakeCurrentEvent:
        // makeCurrent() binds Qt's framebuffer behind the back of what VTK knows of the state: only if need be.
        if (context() && !isCurrent)
            makeCurrent();
        break;
    case vtkCommand::WindowIsCurrentEvent:
        *static_cast<bool *>(answer) = isCurrent;
        break;
    default:
        *static_cast<int *>(answer) = 1;
        break;
    }
}

void VtkView::initializeGL()
{
    // Called again with another context when the widget moves to another window, as docks do.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
        makeCurrent();
        release();
        doneCurrent();
    });
    mWindow->SetForceMaximumHardwareLineWidth(1);
    mWindow->SetReadyForRendering(true);
    mWindow->OpenGLInitContext();
    mWindow->SetMapped(true);
}

void VtkView::resizeGL(int, int)
{
    const QSize pixels = size() * devicePixelRatioF();
    mWindow->SetSize(pixels.width(), pixels.height());
    mWindow->SetDPI(int(72 * devicePixelRatioF()));
}

void VtkView::placeCamera()
{
    constexpr double DegreesPerRadian = 180 / std::numbers::pi;
    const model::OrbitCamera &from = camera();
    vtkCamera &to = *mRenderer->GetActiveCamera();
    const model::Vec3f eye = from.position(), up = from.up();
    to.SetPosition(eye.x, eye.y, eye.z);
    to.SetFocalPoint(from.target.x, from.target.y, from.target.z);
    to.SetViewUp(up.x, up.y, up.z);
    to.SetViewAngle(from.fieldOfView * DegreesPerRadian);
    const model::Vec3f middle = mSceneBox.isEmpty() ? from.target : mSceneBox.center();
    const float radius = mSceneBox.isEmpty() ? from.distance : mSceneBox.diagonal() * 0.55f;
    const float depth = dot(middle - eye, normalized(from.target - eye));
    const float farPlane = std::max(depth + radius, from.distance * 0.01f);
    to.SetClippingRange(std::max(depth - radius, farPlane * 0.001f), farPlane * 1.001f);
}

void VtkView::paintGL()
{
    if (!mWindow->GetReadyForRendering())
        return;
    QElapsedTimer clock;
    clock.start();
    placeCamera();
    vtkOpenGLState &state = *mWindow->GetState();
    state.Reset(); // Qt has drawn in between
    state.Push();
    state.vtkglDepthFunc(GL_LEQUAL);
    mWindow->Render();
    state.Pop();

    auto &gl = *QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(context());
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    gl.glDisable(GL_SCISSOR_TEST);
    const int *pixels = mWindow->GetSize();
    mWindow->BlitDisplayFramebuffer(0, 0, 0, pixels[0], pixels[1], 0, 0, pixels[0], pixels[1], GL_COLOR_BUFFER_BIT,
                                    GL_NEAREST);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    // Where the widget is not opaque Qt lets the window shine through.
    gl.glColorMask(false, false, false, true);
    gl.glClearColor(0, 0, 0, 1);
    gl.glClear(GL_COLOR_BUFFER_BIT);
    gl.glColorMask(true, true, true, true);
    mDrawMilliseconds = double(clock.nsecsElapsed()) * 1e-6;

    gl.glUseProgram(0);
    gl.glBindVertexArray(0);
    gl.glDisable(GL_DEPTH_TEST);
    QPainter painter(this);
    drawOverlay(painter);
    if (mShowsFocus) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void VtkView::setSceneBox(const model::Box3f &box)
{
    mSceneBox = box;
    if (!mControl.isMoved())
        fitView();
    update();
}

VtkView::Ray VtkView::rayAt(QPointF place) const
{
    const model::OrbitCamera &from = camera();
    const float half = std::tan(from.fieldOfView / 2);
    const auto x = float((place.x() - width() / 2.0) / (height() / 2.0)) * half;
    const auto y = float((height() / 2.0 - place.y()) / (height() / 2.0)) * half;
    const model::Vec3f eye = from.position();
    return {eye, normalized(normalized(from.target - eye) + from.right() * x + from.up() * y)};
}

std::optional<QPointF> VtkView::placeOf(const model::Vec3f &point) const
{
    const model::OrbitCamera &from = camera();
    const model::Vec3f eye = from.position(), way = point - eye;
    const float depth = dot(way, normalized(from.target - eye));
    if (depth <= 0)
        return std::nullopt;
    const float scale = float(height()) / 2 / (std::tan(from.fieldOfView / 2) * depth);
    return QPointF(width() / 2.0 + double(dot(way, from.right()) * scale),
                   height() / 2.0 - double(dot(way, from.up()) * scale));
}

bool VtkView::event(QEvent *event)
{
    const auto *mouse = dynamic_cast<QMouseEvent *>(event);
    if (mouse && event->type() == QEvent::MouseButtonPress) {
        mPressed = mouse->position();
        mMayBeClick = mouse->button() == Qt::LeftButton;
        if (std::exchange(mShowsFocus, false))
            update();
    }
    const bool isRelease = mouse && event->type() == QEvent::MouseButtonRelease && mouse->button() == Qt::LeftButton;
    const QPointF place = mouse ? mouse->position() : QPointF();
    const bool handled = mControl.handle(*event) || QOpenGLWidget::event(event);
    if (isRelease && std::exchange(mMayBeClick, false) && QLineF(place, mPressed).length() <= ClickDistance)
        emit clicked(place, mouse->modifiers());
    return handled;
}

void VtkView::changeEvent(QEvent *event)
{
    QOpenGLWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        emit paletteChanged();
}

void VtkView::resizeEvent(QResizeEvent *event)
{
    QOpenGLWidget::resizeEvent(event);
    if (!mControl.isMoved() && !size().isEmpty())
        fitView();
}

void VtkView::focusInEvent(QFocusEvent *event)
{
    const Qt::FocusReason reason = event->reason();
    mShowsFocus = reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason || reason == Qt::ShortcutFocusReason;
    update();
}

void VtkView::focusOutEvent(QFocusEvent *)
{
    mShowsFocus = false;
    update();
}

} // namespace views
