// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "views/scene/player.h"
#include "views/viewport/errorcoloring.h"
#include "views/viewport/overlay.h"
#include "views/viewport/scenerenderer.h"
#include "views/viewport/sceneviewport.h"

#include <QFutureWatcher>
#include <QImage>

#include <deque>
#include <optional>

namespace views {

/// Draws the player's current frame with OpenGL 3.3 core. A CameraControl moves the camera. Only positions and normals
/// are uploaded per frame.
///
/// At first the camera holds the whole animation; it stays where the user puts it when the animation is edited, unless
/// that would leave the picture empty. Precondition: glSupport().isSufficient.
class AnimationViewport final : public SceneViewport, public ErrorColoring
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

    /// The picture at another size than the widget's, without the read-out; for screenshots and PNG sequences.
    /// A null image if the widget was never shown or the size is not within maximumPictureSize().
    QImage renderPicture(const FrameData &frame, QSize size);

protected:
    void makeRenderer(QOpenGLFunctions_3_3_Core &gl) override;
    void freeRenderer() override;
    void paintGL() override;
    void paletteChanged() override;
    const FrameData *coloredFrame() const override { return mUploaded.get(); }
    void errorColoringChanged() override { update(); }

private:
    void sourceChanged();
    void boundsFound();
    /// The box over all frames, that of the current frame until it is known.
    model::Box3f sceneBox() const override;
    void uploadCurrentFrame();
    void drawOverlay();
    void frameSwapped();
    /// Null if the frame does not go with its source.
    model::FrameSourcePtr sourceOf(const FrameData &frame) const;

    Player &mPlayer;
    ViewStyle mStyle;
    bool mStatisticsVisible = true;

    std::unique_ptr<SceneRenderer> mRenderer;
    FrameDataPtr mUploaded;

    std::optional<model::Box3f> mBounds;
    model::FrameSourcePtr mBoundsSource;
    QFutureWatcher<model::Box3f> mBoundsWatcher;
    model::Progress mBoundsProgress;

    ViewportStatistics mStatistics;
    std::deque<qint64> mShownAt; ///< milliseconds, of the last second
    QElapsedTimer mClock;
};

} // namespace views
