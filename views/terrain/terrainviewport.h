// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/terraindocument.h"
#include "views/terrain/grounddispatcher.h"
#include "views/terrain/groundray.h"
#include "views/terrain/picture/gradualpicture.h"
#include "views/viewport/sceneviewport.h"

#include <QElapsedTimer>
#include <QImage>
#include <QTimer>

#include <memory>

namespace views {

/// Draws a terrain with OpenGL 3.3 core. A CameraControl moves the camera; what happens on the ground goes to a
/// GroundInteraction. Listens to the document and uploads what its edits wrote, no more.
///
/// The picture of the ground is kept: moving the pointer over it, and a tool's outline, cost no drawing of the terrain.
/// Where the processor draws, it comes in steps between which the event loop runs; see GradualPicture.
/// Precondition: glSupport().isSufficient.
class TerrainViewport final : public SceneViewport, public GroundView
{
    Q_OBJECT

public:
    explicit TerrainViewport(const model::TerrainDocument &document, QWidget *parent = nullptr);
    ~TerrainViewport() override;

    /// Shows another terrain from the same eye, or from one that sees all of it if nobody moved it; reference, mask and
    /// active triangles are gone. The one before may be gone already, but then nothing else may have been asked of the
    /// viewport since. Costs less than a new viewport: context and programs stay.
    void setDocument(const model::TerrainDocument &document);

    void setInteraction(GroundInteraction *interaction) override;
    std::optional<model::terrain::Point3> pick(QPointF place) const override;
    void updateLines() override;

    const TerrainStyle &style() const { return mStyle; }
    void setStyle(const TerrainStyle &style);
    /// The moment that CutAndFill compares with; null: nothing differs. Any snapshot of a terrain over the same domain.
    void setReference(std::shared_ptr<const model::terrain::Terrain> reference);
    /// What the overlay Mask shows; null: nothing is protected.
    void setMask(std::shared_ptr<const model::terrain::PaintMask> mask);
    /// The triangles that erosion works on, for hasActiveTriangles.
    void setActiveTriangles(std::vector<model::terrain::TriangleId> triangles);

    /// Where a point of the ground is seen, in logical pixels; nothing behind the camera.
    std::optional<QPointF> placeOf(const model::terrain::Point3 &point) const;

    /// The picture at another size than the widget's, without lines and legend; drawn at once.
    /// A null image if the widget was never shown or the size is not within maximumPictureSize().
    QImage renderPicture(QSize size, const model::OrbitCamera &camera);
    QImage renderPicture(QSize size) { return renderPicture(size, camera()); }
    /// The same in steps, between which the event loop can run; instead of one that is being made. \returns false if it
    /// cannot be drawn
    bool beginPicture(QSize size, const model::OrbitCamera &camera);
    /// \returns true once it is done, or can be no more
    bool stepPicture();
    /// Null if it could not be drawn.
    QImage takePicture();

    /// Bytes sent to the GPU.
    UploadCount uploadCount() const { return mRenderer ? mRenderer->buffers().uploadCount() : UploadCount(); }
    /// The exact picture of what the document now holds is not shown yet.
    bool isLoading() const;
    GradualPicture::Work workDone() const { return mPicture ? mPicture->workDone() : GradualPicture::Work(); }
    /// How much is drawn at once, instead of what suits the machine. Before the widget is shown.
    void setStepLimits(const StepLimits &limits) { mLimits = limits; }

private:
    void makeRenderer(QOpenGLFunctions_3_3_Core &gl) override;
    void freeRenderer() override;
    void paintGL() override;
    void cameraMoved() override;
    void paletteChanged() override;
    bool handleFirst(QEvent &event) override;
    model::Box3f sceneBox() const override;

    bool isGradual() const { return mLimits.coarsePixels > 0; }
    void documentChanged(const model::TerrainChange &change);
    void redraw();
    void redrawMoving();
    void refine();
    bool beginPicture(QSize size, const model::OrbitCamera &camera, const StepLimits &limits);
    void takeNews();
    bool hasWork() const;
    void drawOverlay();
    GroundRay rayAt(QPointF place) const;
    std::optional<GroundEvent> groundAt(QPointF place) const;

    void listen();

    const model::TerrainDocument *mDocument;
    GroundFrame mFrame;
    GroundDispatcher mDispatcher;
    TerrainStyle mStyle;
    StepLimits mLimits;

    QOpenGLFunctions_3_3_Core *mGl = nullptr; ///< the context's
    std::unique_ptr<TerrainRenderer> mRenderer;
    std::unique_ptr<GradualPicture> mPicture; ///< the ground, without lines
    std::unique_ptr<GradualPicture> mOther;   ///< a picture of another size
    std::shared_ptr<const model::terrain::Terrain> mReference;
    std::shared_ptr<const model::terrain::PaintMask> mMask;
    std::vector<model::terrain::TriangleId> mActive;
    bool mIsActiveStale = true;
    bool mHasNews = true;     ///< something was told that the picture has not heard of
    bool mIsShownOld = false; ///< a part of the picture is newer than the screen
    QElapsedTimer mShownAgo;
    QTimer mMovePause;   ///< runs while camera or style change
    QTimer mShadowPause; ///< runs while shadows wait for the end of a stroke
    QTimer mRefining;    ///< runs while the picture has steps to do
};

} // namespace views
