// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/viewport/animationviewport.h"

#include "model/animation/normalisation.h"
#include "views/viewport/glsupport.h"

#include <QOpenGLFramebufferObject>
#include <QPainter>
#include <QtConcurrentRun>

#include <algorithm>
#include <cmath>
#include <limits>

namespace views {

namespace {

constexpr int HardwareSamples = 4;

} // namespace

AnimationViewport::AnimationViewport(Player &player, QWidget *parent)
    : SceneViewport(parent)
    , mPlayer(player)
{
    QSurfaceFormat wanted = QSurfaceFormat::defaultFormat();
    wanted.setSamples(glSupport().isSoftware ? 0 : HardwareSamples);
    setFormat(wanted);
    setAccessibleName(tr("Animation"));
    setAccessibleDescription(tr("The mesh in 3D. Arrow keys turn it, plus and minus zoom, F shows all of it."));
    mStyle.isDark = isDark();
    mClock.start();
    connect(&mPlayer, &Player::frameReady, this, [this] { update(); });
    connect(&mPlayer, &Player::sourceChanged, this, &AnimationViewport::sourceChanged);
    connect(this, &QOpenGLWidget::frameSwapped, this, &AnimationViewport::frameSwapped);
    connect(&mBoundsWatcher, &QFutureWatcherBase::finished, this, &AnimationViewport::boundsFound);
    sourceChanged();
}

AnimationViewport::~AnimationViewport()
{
    mBoundsProgress.cancel();
    mBoundsWatcher.disconnect(this);
    closeGl();
}

void AnimationViewport::setDrawMode(DrawMode mode)
{
    if (mode == mStyle.drawMode)
        return;
    mStyle.drawMode = mode;
    update();
    emit styleChanged();
}

void AnimationViewport::setPointDensity(double density)
{
    const double wanted = std::clamp(density, 0.0, 1.0);
    if (wanted == mStyle.pointDensity)
        return;
    mStyle.pointDensity = wanted;
    update();
    emit styleChanged();
}

void AnimationViewport::setStatisticsVisible(bool visible)
{
    mStatisticsVisible = visible;
    update();
}

void AnimationViewport::setGridVisible(bool visible)
{
    mStyle.hasGrid = visible;
    update();
}

model::Box3f AnimationViewport::sceneBox() const
{
    if (mBounds)
        return *mBounds;
    const FrameDataPtr frame = mPlayer.currentFrame();
    return frame ? model::boundingBox(frame->positions) : model::Box3f();
}

void AnimationViewport::sourceChanged()
{
    mBoundsProgress.cancel();
    mBoundsProgress = model::Progress();
    mBoundsSource = mPlayer.source();
    if (!mBoundsSource) {
        mBounds.reset();
        update();
        return;
    }
    mBoundsWatcher.setFuture(QtConcurrent::run([source = mBoundsSource, progress = mBoundsProgress] {
        return model::boundingBoxOfAll(*source, progress).value_or(model::Box3f()); // empty: cancelled
    }));
}

void AnimationViewport::boundsFound()
{
    if (mBoundsProgress.isCancelled() || !mBoundsSource || mBoundsWatcher.future().resultCount() == 0)
        return;
    const model::Box3f found = mBoundsWatcher.result();
    const std::optional<model::Box3f> before = std::exchange(mBounds, found);
    if (!control().isMoved()) {
        fitView();
    } else if (before && !before->isEmpty() && before->diagonal() > 0 && found.diagonal() > 0) {
        // An edit such as normalising moves and scales everything: the camera goes along. Small changes leave it.
        const float scale = found.diagonal() / before->diagonal();
        const float shift = model::length(found.center() - before->center()) / before->diagonal();
        if (scale < 0.67f || scale > 1.5f || shift > 0.25f) {
            model::OrbitCamera moved = camera();
            moved.target = found.center() + (moved.target - before->center()) * scale;
            moved.distance *= scale;
            setCamera(moved);
        }
    }
    update();
}

void AnimationViewport::makeRenderer(QOpenGLFunctions_3_3_Core &gl)
{
    mRenderer = std::make_unique<SceneRenderer>(gl);
    if (!mRenderer->error().isEmpty())
        qCritical("Shader: %s", qUtf8Printable(mRenderer->error()));
}

void AnimationViewport::freeRenderer()
{
    mRenderer.reset();
    mUploaded.reset();
}

model::FrameSourcePtr AnimationViewport::sourceOf(const FrameData &frame) const
{
    const model::FrameSourcePtr &source = frame.source ? frame.source : mPlayer.source();
    return source && source->vertexCount() == frame.positions.size() ? source : nullptr;
}

void AnimationViewport::uploadCurrentFrame()
{
    const FrameDataPtr frame = mPlayer.currentFrame();
    const model::FrameSourcePtr source = frame ? sourceOf(*frame) : nullptr;
    if (!source) {
        mRenderer->clearMesh();
        mUploaded.reset();
        return;
    }
    if (frame == mUploaded)
        return;
    const qint64 start = mClock.nsecsElapsed();
    mRenderer->upload(*frame, source);
    mStatistics.uploadMilliseconds = double(mClock.nsecsElapsed() - start) * 1e-6;
    mStatistics.computeMilliseconds = frame->computeMilliseconds;
    mStatistics.vertexCount = source->vertexCount();
    mStatistics.triangleCount = source->connectivity().triangles.size();
    if (!mUploaded || mUploaded->frame != frame->frame)
        mShownAt.push_back(mClock.elapsed());
    mUploaded = frame;
    if (!control().isMoved() && !mBounds) // until the box over all frames is known
        fitView();
}

void AnimationViewport::paintGL()
{
    if (!mRenderer)
        return;
    const qint64 now = mClock.elapsed();
    uploadCurrentFrame();
    while (!mShownAt.empty() && mShownAt.front() < now - 1000)
        mShownAt.pop_front();
    mStatistics.framesPerSecond = double(mShownAt.size());
    const qint64 start = mClock.nsecsElapsed();
    mStyle.pixelRatio = float(devicePixelRatioF());
    mStyle.errorRange = errorRange();
    mRenderer->draw(camera(), pixelSize(), sceneBox(), mStyle);
    mStatistics.drawMilliseconds = double(mClock.nsecsElapsed() - start) * 1e-6;
    drawOverlay();
}

void AnimationViewport::drawOverlay()
{
    QPainter painter(this);
    if (!mRenderer->error().isEmpty())
        return drawShaderError(painter, mRenderer->error());
    if (mUploaded) {
        drawAxes(painter, rect(), camera(), mStyle.isDark);
        if (mStatisticsVisible)
            drawStatistics(painter, mStatistics, mStyle.isDark);
        drawErrorScale(painter, rect(), mStyle.isDark);
    }
    drawFocus(painter);
}

void AnimationViewport::frameSwapped()
{
    if (mUploaded && mUploaded->source == mPlayer.source())
        mPlayer.frameShown(mUploaded->frame);
}

QImage AnimationViewport::renderPicture(const FrameData &frame, QSize size)
{
    const model::FrameSourcePtr source = sourceOf(frame);
    if (!mRenderer || !source || !canDraw(size))
        return {};
    makeCurrent();
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    format.setSamples(HardwareSamples);
    QImage picture;
    {
        QOpenGLFramebufferObject target(size, format);
        if (target.isValid() && target.bind()) {
            ViewStyle style = mStyle;
            // Lines as thick as on the screen, in proportion to the picture.
            style.pixelRatio = std::max(1.0f, float(size.height()) / float(std::max(height(), 1)));
            mRenderer->upload(frame, source);
            mUploaded.reset();
            mRenderer->draw(camera(), size, sceneBox(), style);
            target.release();
            picture = target.toImage().convertToFormat(QImage::Format_RGB32);
        }
    }
    doneCurrent();
    return picture;
}

void AnimationViewport::paletteChanged()
{
    mStyle.isDark = isDark();
    update();
}

} // namespace views
