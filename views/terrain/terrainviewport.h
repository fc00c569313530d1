// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/terraindocument.h"
#include "views/terrain/grounddispatcher.h"
#include "views/terrain/groundray.h"
#include "views/terrain/picture/terrainrenderer.h"
#include "views/viewport/cameracontrol.h"

#include <QElapsedTimer>
#include <QImage>
#include <QOpenGLWidget>
#include <QTimer>

#include <memory>

class QOpenGLFramebufferObject;

namespace views {

/// Draws a terrain with OpenGL 3.3 core. A CameraControl moves the camera; what happens on the ground goes to a
/// GroundInteraction. Listens to the document and uploads what its edits wrote, no more.
///
/// The picture of the ground is kept: moving the pointer over it, and a tool's outline, cost no drawing of the terrain.
/// Precondition: glSupport().isSufficient.
class TerrainViewport final : public QOpenGLWidget, public GroundView
{
    Q_OBJECT

public:
    explicit TerrainViewport(const model::TerrainDocument &document, QWidget *parent = nullptr);
    ~TerrainViewport() override;

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

    const model::OrbitCamera &camera() const { return mControl.camera(); }
    void setCamera(const model::OrbitCamera &camera) { mControl.setCamera(camera); }
    void fitView();
    /// Factor < 1 comes nearer, to the middle of the picture.
    void zoom(float factor) { mControl.zoom(factor); }
    /// Where a point of the ground is seen, in logical pixels; nothing behind the camera.
    std::optional<QPointF> placeOf(const model::terrain::Point3 &point) const;

    /// The picture at another size than the widget's, without lines and legend; for screenshots and turntables.
    /// A null image if the widget was never shown or the size is not within maximumPictureSize().
    QImage renderPicture(QSize size, const model::OrbitCamera &camera);
    QImage renderPicture(QSize size) { return renderPicture(size, camera()); }
    /// What the GPU can draw at once; empty before the widget was shown.
    QSize maximumPictureSize() const { return mMaximumPictureSize; }

    /// Bytes sent to the GPU.
    UploadCount uploadCount() const { return mRenderer ? mRenderer->buffers().uploadCount() : UploadCount(); }
    /// A part of the terrain is not drawn yet.
    bool isLoading() const { return !mRenderer || mRenderer->buffers().hasMore(); }

    QSize minimumSizeHint() const override { return {160, 120}; }
    QSize sizeHint() const override { return {800, 600}; }

signals:
    void cameraChanged();
    void styleChanged();

protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    bool event(QEvent *event) override;

private:
    void releaseGl();
    void documentChanged(const model::TerrainChange &change);
    void redraw();
    void applyPalette();
    void drawPicture();
    void blitPicture();
    void drawOverlay();
    QSize pixelSize() const { return size() * devicePixelRatioF(); }
    /// All of the terrain, in the scene.
    model::Box3f sceneBox() const;
    GroundRay rayAt(QPointF place) const;
    std::optional<GroundEvent> groundAt(QPointF place) const;

    const model::TerrainDocument &mDocument;
    const GroundFrame mFrame;
    CameraControl mControl;
    GroundDispatcher mDispatcher;
    TerrainStyle mStyle;
    const int mSamples; ///< of the picture on the screen

    QOpenGLFunctions_3_3_Core *mGl = nullptr; ///< the context's
    std::unique_ptr<TerrainRenderer> mRenderer;
    std::unique_ptr<QOpenGLFramebufferObject> mPicture; ///< the ground, without lines
    std::shared_ptr<const model::terrain::Terrain> mReference;
    std::shared_ptr<const model::terrain::PaintMask> mMask;
    std::vector<model::terrain::TriangleId> mActive;
    bool mIsActiveStale = true;
    bool mIsStale = true; ///< the picture shows something else
    QElapsedTimer mDrawnAgo;
    QTimer mCameraPause; ///< runs while the camera moves
    QTimer mShadowPause; ///< runs while shadows wait for the end of a stroke
    QSize mMaximumPictureSize;
    bool mShowsFocus = false; ///< got the focus by the keyboard
};

} // namespace views
