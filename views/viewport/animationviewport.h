// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/camera.h"
#include "views/scene/player.h"

#include <QImage>
#include <QOpenGLWidget>

namespace views {

enum class DrawMode : std::uint8_t { Shaded, ShadedWireframe, Wireframe, Points };

/// Draws the player's current frame with OpenGL 3.3 core; orbit (left drag), pan (middle or Shift+left drag), zoom
/// (wheel, right drag), fit (F). Only positions and normals are uploaded per frame.
class AnimationViewport final : public QOpenGLWidget
{
    Q_OBJECT

public:
    explicit AnimationViewport(Player &player, QWidget *parent = nullptr);
    ~AnimationViewport() override;

    DrawMode drawMode() const { return mDrawMode; }
    void setDrawMode(DrawMode mode);
    /// Share of the vertices drawn in Points mode, 0..1.
    double pointDensity() const { return mPointDensity; }
    void setPointDensity(double density);
    void setStatisticsVisible(bool visible);
    bool isStatisticsVisible() const { return mStatisticsVisible; }

    const model::OrbitCamera &camera() const { return mCamera; }
    void setCamera(const model::OrbitCamera &camera);
    void fitView();

    /// The picture at another size than the widget's, without the read-out; for screenshots and PNG sequences.
    QImage renderPicture(const FrameData &frame, QSize size);

signals:
    void cameraChanged();

private:
    // Replaced or extended by the implementation as it needs.
    Player &mPlayer;
    model::OrbitCamera mCamera;
    DrawMode mDrawMode = DrawMode::Shaded;
    double mPointDensity = 1.0;
    bool mStatisticsVisible = true;
};

} // namespace views
