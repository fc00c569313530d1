// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/camera.h"
#include "views/scene/player.h"
#include "views/viewport/errorcoloring.h"

#include <QFutureWatcher>
#include <QImage>
#include <QWidget>

class QLabel;

namespace views {

/// Stands where the viewport would, on a machine without sufficient OpenGL: says what was found and what to do, and
/// plays with pictures that the processor draws, as fast as it can.
class NoGlView final : public QWidget, public ErrorColoring
{
    Q_OBJECT

public:
    explicit NoGlView(Player &player, QWidget *parent = nullptr);
    ~NoGlView() override;

    /// What was found and what to do about it, in the user's language.
    QString message() const;
    /// The last picture drawn; null before the first.
    const QImage &picture() const { return mPicture; }

    QSize sizeHint() const override { return {800, 600}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    const FrameData *coloredFrame() const override { return mDrawing.get(); }
    void errorColoringChanged() override { request(); }

private:
    void request();
    void drawn();
    QRect pictureArea() const;

    Player &mPlayer;
    QLabel *mMessage;
    model::FrameSourcePtr mFitted; ///< the camera holds its first frame
    model::OrbitCamera mCamera;
    QFutureWatcher<QImage> mWatcher;
    FrameDataPtr mDrawing;
    QImage mPicture;
    bool mIsOutdated = false; ///< something changed while a picture was being drawn
};

} // namespace views
