// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/mesh/camera.h"
#include "views/jobs/job.h"

#include <QImage>
#include <QWidget>

#include <optional>

class QLabel;
class QSlider;

namespace views {

/// A picture of a mesh, drawn without OpenGL in the background; a drag turns it. The newest wish is drawn when the
/// one before is ready, so that it follows the mouse with any mesh.
class FramePicture final : public QWidget
{
    Q_OBJECT

public:
    explicit FramePicture(QWidget *parent = nullptr);

    /// Null: an empty picture with `text`.
    void setFrames(model::FrameSourcePtr frames, const model::Box3f &box);
    void setEmptyText(const QString &text);
    void setFrame(std::uint32_t frame);
    const QImage &picture() const { return mPicture; }

    QSize sizeHint() const override { return {320, 240}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;

private:
    void request();
    void draw();

    model::FrameSourcePtr mFrames;
    model::Box3f mBox;
    std::uint32_t mFrame = 0;
    model::OrbitCamera mCamera;
    bool mTurned = false; ///< by the user; else the camera fits itself
    QPointF mDragFrom;
    QString mEmptyText;
    QImage mPicture;
    bool mOutdated = false; ///< something changed while a picture was being drawn
    Job mDrawing;
};

/// The picture with a slider for the frame under it.
class FramePreview final : public QWidget
{
    Q_OBJECT

public:
    explicit FramePreview(QWidget *parent = nullptr);

    void setFrames(model::FrameSourcePtr frames, const model::Box3f &box);
    void clear(const QString &text);
    const FramePicture &picture() const { return *mPicture; }

private:
    void showFrame(int frame);

    FramePicture *mPicture;
    QSlider *mSlider;
    QLabel *mFrameText;
};

} // namespace views
