// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/terrainviewport.h"

#include "views/terrain/drapedlines.h"
#include "views/terrain/groundlegend.h"
#include "views/viewport/glsupport.h"

#include <QFocusEvent>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLVersionFunctionsFactory>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace views {

using namespace model::terrain;

namespace {

constexpr int HardwareSamples = 4;
/// Of a whole terrain, what is uploaded before each repaint: the window stays awake.
constexpr double UploadMilliseconds = 12;
/// Milliseconds between pictures of a terrain that is not all there yet.
constexpr int LoadingPause = 400;
/// Milliseconds without a change after which the processor draws the shadows anew.
constexpr int ShadowPause = 180;
/// Radians: a terrain is looked down upon.
constexpr float StartPitch = 0.6f;
/// Milliseconds without a movement after which it draws all triangles of a large terrain.
constexpr int CameraPause = 200;

QOpenGLFramebufferObjectFormat pictureFormat(int samples)
{
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    format.setSamples(samples);
    return format;
}

} // namespace

TerrainViewport::TerrainViewport(const model::TerrainDocument &document, QWidget *parent)
    : QOpenGLWidget(parent)
    , mDocument(document)
    , mFrame(document.tin())
    , mControl(*this)
    , mDispatcher(*this, [this](QPointF place) { return groundAt(place); })
    , mSamples(glSupport().isSoftware ? 0 : HardwareSamples)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setTabletTracking(true);
    setAccessibleName(tr("Terrain"));
    setAccessibleDescription(
        tr("The terrain in 3D. Plus and minus zoom, Home shows all of it. While you sculpt, arrow keys "
           "move the tool and Space presses and lifts it; with Ctrl they turn the terrain."));
    connect(&mControl, &CameraControl::moved, this, [this] {
        if (mSamples == 0)
            mCameraPause.start();
        redraw();
        emit cameraChanged();
    });
    connect(&mControl, &CameraControl::fitAsked, this, &TerrainViewport::fitView);
    connect(&mDocument, &model::TerrainDocument::changed, this, &TerrainViewport::documentChanged);
    mCameraPause.setSingleShot(true);
    mCameraPause.setInterval(CameraPause);
    connect(&mCameraPause, &QTimer::timeout, this, &TerrainViewport::redraw);
    mShadowPause.setSingleShot(true);
    mShadowPause.setInterval(ShadowPause);
    connect(&mShadowPause, &QTimer::timeout, this, qOverload<>(&QWidget::update));
    mStyle.quality = mSamples == 0 ? GroundQuality::Medium : GroundQuality::High;
    applyPalette();
    model::OrbitCamera start;
    start.pitch = StartPitch;
    mControl.setCamera(start);
    fitView();
}

TerrainViewport::~TerrainViewport()
{
    mDispatcher.setInteraction(nullptr);
    if (context())
        disconnect(context(), nullptr, this, nullptr);
    releaseGl();
}

void TerrainViewport::setInteraction(GroundInteraction *interaction)
{
    mDispatcher.setInteraction(interaction);
    updateLines();
}

void TerrainViewport::updateLines()
{
    setCursor(mDispatcher.isActive() ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
}

void TerrainViewport::setStyle(const TerrainStyle &style)
{
    if (style == mStyle)
        return;
    mStyle = style;
    redraw();
    emit styleChanged();
}

void TerrainViewport::setReference(std::shared_ptr<const Terrain> reference)
{
    mReference = std::move(reference);
    if (mRenderer)
        mRenderer->setReference(mReference);
    update();
}

void TerrainViewport::setMask(std::shared_ptr<const PaintMask> mask)
{
    mMask = std::move(mask);
    if (mRenderer)
        mRenderer->setMask(mMask);
    update();
}

void TerrainViewport::setActiveTriangles(std::vector<TriangleId> triangles)
{
    mActive = std::move(triangles);
    mIsActiveStale = true;
    if (mStyle.hasActiveTriangles)
        update();
}

void TerrainViewport::redraw()
{
    mIsStale = true;
    update();
}

model::Box3f TerrainViewport::sceneBox() const
{
    const TinArrays &tin = mDocument.tin().arrays();
    const Rectangle &domain = mDocument.tin().domain();
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    for (VertexId v = 0; v < tin.vertexSlots(); ++v) {
        if (!tin.isVertex(v))
            continue;
        low = std::min(low, tin.heights[v]);
        high = std::max(high, tin.heights[v]);
    }
    model::Box3f box;
    box.add(mFrame.toScene(domain.low.x, domain.low.y, low));
    box.add(mFrame.toScene(domain.high.x, domain.high.y, high));
    return box;
}

void TerrainViewport::fitView()
{
    mControl.fit(sceneBox());
}

void TerrainViewport::documentChanged(const model::TerrainChange &change)
{
    if (const auto *surface = std::get_if<model::SurfaceChanged>(&change)) {
        if (mRenderer)
            mRenderer->note(*surface->edit);
    } else if (std::holds_alternative<model::MaterialsChanged>(change)) {
        if (mRenderer)
            mRenderer->noteMaterials();
    } else {
        return;
    }
    if (mSamples == 0)
        mShadowPause.start();
    update(); // stale only once something was uploaded
}

void TerrainViewport::initializeGL()
{
    // Called again with another context when the widget moves to another window, as docks do.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &TerrainViewport::releaseGl);
    mGl = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(context());
    if (!mGl)
        return;
    GLint texture = 0, renderbuffer = 0, viewport[2] = {};
    mGl->glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    mGl->glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
    mGl->glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    const int side = std::min(texture, renderbuffer);
    mMaximumPictureSize = QSize(std::min(side, viewport[0]), std::min(side, viewport[1]));
    mRenderer = std::make_unique<TerrainRenderer>(*mGl, mDocument.terrain(), mFrame);
    mRenderer->setReference(mReference);
    mRenderer->setMask(mMask);
    mIsStale = mIsActiveStale = true;
    if (!mRenderer->error().isEmpty())
        qCritical("Shader: %s", qUtf8Printable(mRenderer->error()));
}

void TerrainViewport::releaseGl()
{
    if (!mRenderer)
        return;
    makeCurrent();
    mPicture.reset();
    mRenderer.reset();
    mGl = nullptr;
    doneCurrent();
}

void TerrainViewport::paintGL()
{
    if (!mRenderer)
        return;
    mRenderer->upload(mStyle, UploadMilliseconds);
    if (mStyle.hasActiveTriangles && std::exchange(mIsActiveStale, false))
        mRenderer->setActiveTriangles(mActive);
    drawPicture();
    drawOverlay();
    if (mRenderer->buffers().hasMore())
        update();
}

void TerrainViewport::drawPicture()
{
    const QSize size = pixelSize();
    if (!mPicture || mPicture->size() != size) {
        mPicture = std::make_unique<QOpenGLFramebufferObject>(size, pictureFormat(mSamples));
        mIsStale = true;
    }
    // A terrain that is being loaded is not drawn after each portion: drawing takes longer than uploading.
    if (mRenderer->buffers().hasMore() && !mIsStale && mDrawnAgo.isValid() && mDrawnAgo.elapsed() < LoadingPause)
        return blitPicture();
    mDrawnAgo.start();
    const model::Box3f changes = mRenderer->takeChanges();
    mIsStale |= mRenderer->takeIsAllChanged();
    TerrainPicture picture{camera(), mPicture->handle(), size, mStyle, float(devicePixelRatioF())};
    picture.keepsShadows = mShadowPause.isActive();
    picture.isCoarse = mCameraPause.isActive();
    if (std::exchange(mIsStale, false))
        mRenderer->draw(picture);
    else if (!changes.isEmpty() || (mRenderer->hasLateShadows() && !picture.keepsShadows))
        mRenderer->draw(picture, &changes);
    blitPicture();
}

void TerrainViewport::blitPicture()
{
    const QSize size = pixelSize();
    mGl->glBindFramebuffer(GL_READ_FRAMEBUFFER, mPicture->handle());
    mGl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    mGl->glDisable(GL_SCISSOR_TEST);
    mGl->glBlitFramebuffer(0, 0, size.width(), size.height(), 0, 0, size.width(), size.height(), GL_COLOR_BUFFER_BIT,
                           GL_NEAREST);
    mGl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
}

void TerrainViewport::drawOverlay()
{
    QPainter painter(this);
    if (!mRenderer->error().isEmpty()) {
        painter.setPen(Qt::white);
        painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("The graphics driver refused a shader:\n%1").arg(mRenderer->error()));
        return;
    }
    if (const GroundInteraction *interaction = mDispatcher.interaction())
        drawDrapedLines(painter, interaction->lines(), mDocument.tin(),
                        [this](const Point3 &point) { return placeOf(point); });
    if (mStyle.hasLegend && mStyle.overlay != GroundOverlay::None)
        drawGroundLegend(painter, rect(), mStyle, mRenderer->rangeOf(mStyle.overlay), mDocument.terrain());
    if (mShowsFocus) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

QImage TerrainViewport::renderPicture(QSize size, const model::OrbitCamera &camera)
{
    if (!mRenderer || size.isEmpty() || size.width() > mMaximumPictureSize.width() ||
        size.height() > mMaximumPictureSize.height())
        return {};
    makeCurrent();
    QImage picture;
    {
        QOpenGLFramebufferObject target(size, pictureFormat(HardwareSamples));
        if (target.isValid()) {
            mRenderer->upload(mStyle, std::numeric_limits<double>::infinity());
            // Lines as thick as on the screen, in proportion to the picture.
            const float ratio = std::max(1.0f, float(size.height()) / float(std::max(height(), 1)));
            mRenderer->draw({camera, target.handle(), size, mStyle, ratio});
            picture = target.toImage().convertToFormat(QImage::Format_RGB32);
        }
    }
    doneCurrent();
    return picture;
}

GroundRay TerrainViewport::rayAt(QPointF place) const
{
    const model::OrbitCamera &eye = camera();
    const double slope = std::tan(double(eye.fieldOfView) / 2) * 2 / std::max(height(), 1);
    const auto right = float((place.x() - width() / 2.0) * slope), up = float((height() / 2.0 - place.y()) * slope);
    const model::Vec3f from = eye.position();
    const model::Vec3f forward = model::normalized(eye.target - from);
    const model::Vec3f towards = forward + eye.right() * right + eye.up() * up;
    return {mFrame.toGround(from.x, from.y, from.z), {towards.x, -towards.z, towards.y}};
}

std::optional<Point3> TerrainViewport::pick(QPointF place) const
{
    return hitOf(mDocument.tin(), rayAt(place));
}

std::optional<GroundEvent> TerrainViewport::groundAt(QPointF place) const
{
    const GroundRay ray = rayAt(place);
    GroundEvent event;
    std::optional<Point3> hit = hitOf(mDocument.tin(), ray);
    event.isOnTerrain = hit.has_value();
    if (!hit)
        hit = hitBeyond(mDocument.tin(), ray);
    if (!hit)
        return std::nullopt;
    event.point = *hit;
    const model::Vec3f seen = mFrame.toScene(hit->x, hit->y, hit->z) - camera().position();
    const double depth = model::dot(seen, model::normalized(camera().target - camera().position()));
    event.metresPerPixel = 2 * depth * std::tan(double(camera().fieldOfView) / 2) / std::max(height(), 1);
    return event;
}

std::optional<QPointF> TerrainViewport::placeOf(const Point3 &point) const
{
    const model::OrbitCamera &eye = camera();
    const model::Vec3f seen = mFrame.toScene(point.x, point.y, point.z) - eye.position();
    const float depth = model::dot(seen, model::normalized(eye.target - eye.position()));
    if (depth <= 1e-6f * eye.distance)
        return std::nullopt;
    const double scale = height() / (2 * std::tan(double(eye.fieldOfView) / 2) * double(depth));
    return QPointF(width() / 2.0 + double(model::dot(seen, eye.right())) * scale,
                   height() / 2.0 - double(model::dot(seen, eye.up())) * scale);
}

void TerrainViewport::resizeEvent(QResizeEvent *event)
{
    QOpenGLWidget::resizeEvent(event);
    if (!mControl.isMoved() && !size().isEmpty())
        fitView();
}

void TerrainViewport::applyPalette()
{
    mStyle.isDark = palette().color(QPalette::Window).lightness() < 128;
    redraw();
}

void TerrainViewport::changeEvent(QEvent *event)
{
    QOpenGLWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        applyPalette();
}

bool TerrainViewport::event(QEvent *event)
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
    if (!mControl.isDragging() && mDispatcher.handle(*event))
        return true;
    mControl.setLeftButtonTaken(mDispatcher.isActive());
    return mControl.handle(*event) || QOpenGLWidget::event(event);
}

} // namespace views
