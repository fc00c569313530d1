// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/terrainviewport.h"

#include "views/terrain/drapedlines.h"
#include "views/terrain/groundlegend.h"
#include "views/viewport/glsupport.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace views {

using namespace model::terrain;

namespace {

constexpr int HardwareSamples = 4;
/// Of what is to be uploaded, what is sent in one turn of the event loop: the window stays awake.
constexpr double UploadMilliseconds = 8;
/// Milliseconds without a change after which the processor draws the shadows anew.
constexpr int ShadowPause = 180;
/// Radians: a terrain is looked down upon.
constexpr float StartPitch = 0.6f;
/// Milliseconds without a movement after which the processor begins the exact picture.
constexpr int MovePause = 150;
/// Milliseconds between two showings of a picture in the making: showing costs as much as some steps.
constexpr int ShowPause = 40;

} // namespace

TerrainViewport::TerrainViewport(const model::TerrainDocument &document, QWidget *parent)
    : SceneViewport(parent)
    , mDocument(&document)
    , mFrame(document.tin())
    , mDispatcher(*this, [this](QPointF place) { return groundAt(place); })
    , mLimits(glSupport().isSoftware ? StepLimits::software() : StepLimits())
{
    setMouseTracking(true);
    setTabletTracking(true);
    setAccessibleName(tr("Terrain"));
    setAccessibleDescription(
        tr("The terrain in 3D. Plus and minus zoom, Home shows all of it. While you sculpt, arrow keys "
           "move the tool and Space presses and lifts it; with Ctrl they turn the terrain."));
    listen();
    for (const auto &[timer, interval] :
         {std::pair(&mMovePause, MovePause), std::pair(&mShadowPause, ShadowPause), std::pair(&mRefining, 0)}) {
        timer->setSingleShot(true);
        timer->setInterval(interval);
    }
    for (QTimer *timer : {&mMovePause, &mShadowPause, &mRefining})
        connect(timer, &QTimer::timeout, this, &TerrainViewport::refine);
    mStyle.quality = isGradual() ? GroundQuality::Medium : GroundQuality::High;
    mStyle.isDark = isDark();
    model::OrbitCamera start;
    start.pitch = StartPitch;
    setCamera(start);
    fitView();
    mMovePause.stop();
}

TerrainViewport::~TerrainViewport()
{
    mDispatcher.setInteraction(nullptr);
    closeGl();
}

void TerrainViewport::listen()
{
    connect(mDocument, &model::TerrainDocument::changed, this, &TerrainViewport::documentChanged);
}

void TerrainViewport::setDocument(const model::TerrainDocument &document)
{
    mDispatcher.setInteraction(nullptr); // it may hold on to what was there
    mDocument = &document;
    mFrame = GroundFrame(document.tin());
    listen();
    mReference.reset();
    mMask.reset();
    mActive.clear();
    mIsActiveStale = true;
    if (mRenderer) {
        makeCurrent();
        mOther.reset();
        mRenderer->setTerrain(document.terrain());
        mPicture->noteAll();
        doneCurrent();
    }
    if (!control().isMoved())
        fitView();
    redrawMoving();
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
    redrawMoving();
    emit styleChanged();
}

void TerrainViewport::setReference(std::shared_ptr<const Terrain> reference)
{
    mReference = std::move(reference);
    if (mRenderer)
        mRenderer->setReference(mReference);
    redraw();
}

void TerrainViewport::setMask(std::shared_ptr<const PaintMask> mask)
{
    mMask = std::move(mask);
    if (mRenderer)
        mRenderer->setMask(mMask);
    redraw();
}

void TerrainViewport::setActiveTriangles(std::vector<TriangleId> triangles)
{
    mActive = std::move(triangles);
    mIsActiveStale = true;
    if (mStyle.hasActiveTriangles)
        redraw();
}

void TerrainViewport::redraw()
{
    mHasNews = true;
    update();
}

void TerrainViewport::redrawMoving()
{
    if (isGradual())
        mMovePause.start();
    redraw();
}

void TerrainViewport::cameraMoved()
{
    redrawMoving();
}

void TerrainViewport::paletteChanged()
{
    mStyle.isDark = isDark();
    redraw();
}

model::Box3f TerrainViewport::sceneBox() const
{
    const TinArrays &tin = mDocument->tin().arrays();
    const Rectangle &domain = mDocument->tin().domain();
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
    if (isGradual())
        mShadowPause.start();
    redraw();
}

void TerrainViewport::makeRenderer(QOpenGLFunctions_3_3_Core &gl)
{
    mGl = &gl;
    mRenderer = std::make_unique<TerrainRenderer>(gl, mDocument->terrain(), mFrame, mLimits.mapPieces);
    mRenderer->setReference(mReference);
    mRenderer->setMask(mMask);
    // Where the processor draws, smoothing edges costs too much for the screen.
    mPicture = std::make_unique<GradualPicture>(gl, *mRenderer, mLimits, isGradual() ? 0 : HardwareSamples);
    mHasNews = mIsActiveStale = true;
    if (!mRenderer->error().isEmpty())
        qCritical("Shader: %s", qUtf8Printable(mRenderer->error()));
}

void TerrainViewport::freeRenderer()
{
    mOther.reset();
    mPicture.reset();
    mRenderer.reset();
    mGl = nullptr;
}

bool TerrainViewport::hasWork() const
{
    const TerrainBuffers &buffers = mRenderer->buffers();
    return buffers.hasMore() || buffers.hasMoved() || (!mMovePause.isActive() && !mPicture->isDone());
}

bool TerrainViewport::isLoading() const
{
    return !mRenderer || mHasNews || mMovePause.isActive() || hasWork();
}

void TerrainViewport::takeNews()
{
    mHasNews = false;
    mRenderer->upload(mStyle, UploadMilliseconds);
    if (mStyle.hasActiveTriangles && std::exchange(mIsActiveStale, false))
        mRenderer->setActiveTriangles(mActive);
    mPicture->setPicture({camera(), pixelSize(), mStyle, float(devicePixelRatioF()), mShadowPause.isActive()});
    mPicture->noteChanges();
}

void TerrainViewport::paintGL()
{
    if (!mRenderer || pixelSize().isEmpty())
        return;
    const bool hasNews = mHasNews;
    takeNews();
    if (!isGradual()) {
        mPicture->work();
    } else if (mMovePause.isActive() || !mPicture->hasPicture()) {
        mPicture->work(GradualPicture::Kind::Maps);
        mPicture->drawCoarsely();
    } else if (hasNews) { // small edits show at once
        mPicture->work();
    }
    mPicture->show(defaultFramebufferObject());
    mShownAgo.start();
    drawOverlay();
    if (hasWork())
        mRefining.start();
}

void TerrainViewport::refine()
{
    if (!mRenderer || pixelSize().isEmpty())
        return;
    if (!isGradual())
        return update();
    makeCurrent();
    takeNews();
    const bool isMoving = mMovePause.isActive();
    bool isOld = mPicture->work(isMoving ? GradualPicture::Kind::Maps : GradualPicture::Kind::All);
    if (mPicture->wantsCoarse() || !mPicture->hasPicture())
        isOld |= mPicture->drawCoarsely();
    doneCurrent();
    mIsShownOld |= isOld;
    if (mIsShownOld && (!hasWork() || mShownAgo.elapsed() >= ShowPause)) {
        mIsShownOld = false;
        update();
    } else if (hasWork()) {
        mRefining.start();
    }
}

void TerrainViewport::drawOverlay()
{
    QPainter painter(this);
    if (!mRenderer->error().isEmpty())
        return drawShaderError(painter, mRenderer->error());
    if (const GroundInteraction *interaction = mDispatcher.interaction())
        drawDrapedLines(painter, interaction->lines(), mDocument->tin(),
                        [this](const Point3 &point) { return placeOf(point); });
    if (mStyle.hasLegend && mStyle.overlay != GroundOverlay::None)
        drawGroundLegend(painter, rect(), mStyle, mRenderer->rangeOf(mStyle.overlay), mDocument->terrain());
    drawFocus(painter);
}

bool TerrainViewport::beginPicture(QSize size, const model::OrbitCamera &camera, const StepLimits &limits)
{
    if (!mRenderer || !canDraw(size))
        return false;
    makeCurrent();
    mOther = std::make_unique<GradualPicture>(*mGl, *mRenderer, limits, HardwareSamples);
    // Lines as thick as on the screen, in proportion to the picture.
    const float ratio = std::max(1.0f, float(size.height()) / float(std::max(height(), 1)));
    mOther->setPicture({camera, size, mStyle, ratio});
    doneCurrent();
    return true;
}

bool TerrainViewport::beginPicture(QSize size, const model::OrbitCamera &camera)
{
    StepLimits limits = mLimits;
    limits.coarsePixels = 0; // nobody sees it before it is done
    return beginPicture(size, camera, limits);
}

bool TerrainViewport::stepPicture()
{
    if (!mOther)
        return true;
    makeCurrent();
    mRenderer->upload(mStyle, isGradual() ? UploadMilliseconds : std::numeric_limits<double>::infinity());
    const bool isThere = !mRenderer->buffers().hasMore() && !mRenderer->buffers().hasMoved();
    if (isThere)
        mOther->work();
    doneCurrent();
    return isThere && mOther->isDone();
}

QImage TerrainViewport::takePicture()
{
    if (!mOther)
        return {};
    makeCurrent();
    const QImage picture = mOther->toImage();
    if (mOther->workDone().mapSteps > 0) { // other shadows
        mPicture->noteAll();
        redraw();
    }
    mOther.reset();
    doneCurrent();
    return picture;
}

QImage TerrainViewport::renderPicture(QSize size, const model::OrbitCamera &camera)
{
    if (!beginPicture(size, camera, StepLimits()))
        return {};
    while (!stepPicture())
        ;
    return takePicture();
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
    return hitOf(mDocument->tin(), rayAt(place));
}

std::optional<GroundEvent> TerrainViewport::groundAt(QPointF place) const
{
    const GroundRay ray = rayAt(place);
    GroundEvent event;
    std::optional<Point3> hit = hitOf(mDocument->tin(), ray);
    event.isOnTerrain = hit.has_value();
    if (!hit)
        hit = hitBeyond(mDocument->tin(), ray);
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

bool TerrainViewport::handleFirst(QEvent &event)
{
    if (!control().isDragging() && mDispatcher.handle(event))
        return true;
    control().setLeftButtonTaken(mDispatcher.isActive());
    return false;
}

} // namespace views
