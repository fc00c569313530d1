// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "views/scene/player.h"
#include "views/viewport/cameracontrol.h"
#include "views/viewport/errorcoloring.h"
#include "views/viewport/overlay.h"
#include "views/viewport/scenerenderer.h"

#include <QFutureWatcher>
#include <QImage>
#include <QOpenGLWidget>

#include <deque>
#include <optional>

namespace views {

/// Draws the player's current frame with OpenGL 3.3 core. A CameraControl moves the camera. Only positions and normals
/// are uploaded per frame.
///
/// At first the camera holds the whole animation; it stays where the user puts it when the animation is edited, unless
/// that would leave the picture empty. Precondition: glSupport().isSufficient.
class AnimationViewport final : public QOpenGLWidget, public ErrorColoring
{
    Q_OBJECT

public:
    explicit AnimationViewport(Player &player, QWidget *parent = nullptr);
    ~AnimationViewport() override;

    DrawMode drawMode() const { return mStyle.drawMode; }
    void setDrawMode(DrawMode mode);
    /// Share of the vertices drawn in Points mode, 0..1.
    double pointDensity() const { return mStyle.pointDensity; }
    void setPointDensity(double density);
    void setStatisticsVisible(bool visible);
    bool isStatisticsVisible() const { return mStatisticsVisible; }
    void setGridVisible(bool visible);
    bool isGridVisible() const { return mStyle.hasGrid; }

    const model::OrbitCamera &camera() const { return mControl.camera(); }
    void setCamera(const model::OrbitCamera &camera) { mControl.setCamera(camera); }
    void fitView();
    /// Factor < 1 comes nearer, to the middle of the picture.
    void zoom(float factor) { mControl.zoom(factor); }

    /// The picture at another size than the widget's, without the read-out; for screenshots and PNG sequences.
    /// A null image if the widget was never shown or the size is not within maximumPictureSize().
    QImage renderPicture(const FrameData &frame, QSize size);
    /// What the GPU can draw at once; empty before the widget was shown.
    QSize maximumPictureSize() const { return mMaximumPictureSize; }

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
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    const FrameData *coloredFrame() const override { return mUploaded.get(); }
    void errorColoringChanged() override { update(); }

private:
    void releaseGl();
    void sourceChanged();
    void boundsFound();
    /// The box over all frames, that of the current frame until it is known.
    model::Box3f sceneBox() const;
    void uploadCurrentFrame();
    void drawOverlay();
    void frameSwapped();
    void applyPalette();
    QSize pixelSize() const { return size() * devicePixelRatioF(); }
    /// Null if the frame does not go with its source.
    model::FrameSourcePtr sourceOf(const FrameData &frame) const;

    Player &mPlayer;
    CameraControl mControl;
    ViewStyle mStyle;
    bool mStatisticsVisible = true;

    QOpenGLFunctions_3_3_Core *mGl = nullptr; ///< the context's
    std::unique_ptr<SceneRenderer> mRenderer;
    FrameDataPtr mUploaded;
    QSize mMaximumPictureSize;

    std::optional<model::Box3f> mBounds;
    model::FrameSourcePtr mBoundsSource;
    QFutureWatcher<model::Box3f> mBoundsWatcher;
    model::Progress mBoundsProgress;

    bool mShowsFocus = false; ///< got the focus by the keyboard

    ViewportStatistics mStatistics;
    std::deque<qint64> mShownAt; ///< milliseconds, of the last second
    QElapsedTimer mClock;
};

} // namespace views
