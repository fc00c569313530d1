// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/dialogs/exportdialog.h"
#include "views/scene/framedata.h"
#include "views/scene/picturefiles.h"

namespace views {

class AnimationViewport;
class PathField;
class PictureSizeFields;
class SceneViewport;

/// Saves what the viewport shows as a PNG, at any size. Modal for its window, so that the view stays as it is.
class ScreenshotDialog final : public ExportDialog
{
    Q_OBJECT

public:
    /// \param viewport  outlives the dialog and has been shown
    /// \param draw      draws what it shows
    /// \param path      proposed
    ScreenshotDialog(SceneViewport &viewport, DrawView draw, const QString &path, QWidget *parent = nullptr);
    /// \param frame     the one to draw
    ScreenshotDialog(AnimationViewport &viewport, FrameDataPtr frame, const QString &path, QWidget *parent = nullptr);

protected:
    QString problem() const override;
    QString consequence() const override;
    QStringList filesToReplace() const override;
    QString outputPath() const override;
    Work work() override;

private:
    SceneViewport &mViewport;
    const DrawView mDraw;
    PathField *mOutput;
    PictureSizeFields *mSize;
};

} // namespace views
