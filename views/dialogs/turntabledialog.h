// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/dialogs/exportdialog.h"
#include "views/scene/picturefiles.h"

class QComboBox;
class QLabel;
class QSlider;

namespace views {

class PathField;
class PictureSizeFields;
class SceneViewport;

/// Export of numbered PNG pictures from all around a scene: the camera goes once round what it looks at. Modal for its
/// window, so that the view stays as it is; still drawn in pieces, so that the program answers.
class TurntableDialog final : public ExportDialog
{
    Q_OBJECT

public:
    /// \param viewport  outlives the dialog and has been shown; its camera is the first
    /// \param draw      draws what it shows
    /// \param folder    proposed; made if it does not exist
    TurntableDialog(SceneViewport &viewport, DrawView draw, const QString &folder, QWidget *parent = nullptr);

    /// The camera of a picture, counted from 0.
    static model::OrbitCamera cameraOf(model::OrbitCamera first, std::size_t picture, std::size_t count,
                                       bool isClockwise);

protected:
    QString problem() const override;
    QString consequence() const override;
    QString outputPath() const override;
    Work work() override;

private:
    bool isClockwise() const;
    QSize previewSize() const;
    void showPreview();

    SceneViewport &mViewport;
    const DrawView mDraw;
    PathField *mFolder;
    PictureSizeFields *mSize;
    NumberField *mCount;
    QComboBox *mDirection;
    QSlider *mTurn;
    QLabel *mPreview;
    Job mDrawing;
    bool mIsPreviewOld = false; ///< another one is wanted than the one that is being drawn
};

} // namespace views
