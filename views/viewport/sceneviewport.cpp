// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/viewport/sceneviewport.h"

#include <QFocusEvent>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace views {

SceneViewport::SceneViewport(QWidget *parent)
    : QOpenGLWidget(parent)
    , mControl(*this)
{
    setFocusPolicy(Qt::StrongFocus);
    connect(&mControl, &CameraControl::moved, this, [this] {
        cameraMoved();
        emit cameraChanged();
    });
    connect(&mControl, &CameraControl::fitAsked, this, &SceneViewport::fitView);
}

void SceneViewport::closeGl()
{
    if (context())
        disconnect(context(), nullptr, this, nullptr);
    releaseGl();
}

void SceneViewport::releaseGl()
{
    if (!context())
        return;
    makeCurrent();
    freeRenderer();
    doneCurrent();
}

void SceneViewport::initializeGL()
{
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &SceneViewport::releaseGl);
    auto *gl = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(context());
    if (!gl)
        return;
    GLint texture = 0, renderbuffer = 0, viewport[2] = {};
    gl->glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    gl->glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
    gl->glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    const int side = std::min(texture, renderbuffer);
    mMaximumPictureSize = QSize(std::min(side, viewport[0]), std::min(side, viewport[1]));
    makeRenderer(*gl);
}

void SceneViewport::resizeEvent(QResizeEvent *event)
{
    QOpenGLWidget::resizeEvent(event);
    if (!mControl.isMoved() && !size().isEmpty())
        fitView();
}

void SceneViewport::changeEvent(QEvent *event)
{
    QOpenGLWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        paletteChanged();
}

bool SceneViewport::event(QEvent *event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::FocusOut:
        if (std::exchange(mShowsFocus, false))
            update();
        break;
    case QEvent::FocusIn: {
        const Qt::FocusReason reason = static_cast<QFocusEvent *>(event)->reason();
        mShowsFocus =
            reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason || reason == Qt::ShortcutFocusReason;
        update();
        break;
    }
    default:
        break;
    }
    return handleFirst(*event) || mControl.handle(*event) || QOpenGLWidget::event(event);
}

bool SceneViewport::isDark() const
{
    return palette().color(QPalette::Window).lightness() < 128;
}

bool SceneViewport::canDraw(QSize picture) const
{
    return !picture.isEmpty() && picture.width() <= mMaximumPictureSize.width() &&
           picture.height() <= mMaximumPictureSize.height();
}

void SceneViewport::drawFocus(QPainter &painter) const
{
    if (!mShowsFocus)
        return;
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

void SceneViewport::drawShaderError(QPainter &painter, const QString &error) const
{
    painter.setPen(Qt::white);
    painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("The graphics driver refused a shader:\n%1").arg(error));
}

} // namespace views
