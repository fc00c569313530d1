// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/dialogs/exportdialog.h"

#include <vector>

class QComboBox;

namespace views {

class AnimationViewport;
class PathField;
class PictureSizeFields;

/// Export of the playback as numbered PNG pictures, as the viewport draws it. Modal for its window, so that the view
/// stays as it is; still drawn in pieces, so that the program answers.
class ExportPicturesDialog final : public ExportDialog
{
    Q_OBJECT

public:
    /// How frames follow one another in the pictures.
    enum class Order { Forward, Backward, ThereAndBack };

    /// \param viewport     outlives the dialog and has been shown
    /// \param frames       what the viewport shows
    /// \param folder       proposed; made if it does not exist
    /// \param first, last  proposed, 0-based
    ExportPicturesDialog(AnimationViewport &viewport, model::FrameSourcePtr frames, const QString &folder,
                         std::uint32_t first, std::uint32_t last, QWidget *parent = nullptr);

    void setOrder(Order order);
    /// Why pictures cannot be written to a folder, as a sentence; empty if they can.
    static QString folderProblem(const QString &path);

protected:
    QString problem() const override;
    QString consequence() const override;
    QString outputPath() const override;
    Work work() override;

private:
    std::vector<std::uint32_t> frameOrder() const;

    AnimationViewport &mViewport;
    const model::FrameSourcePtr mFrames;
    PathField *mFolder;
    PictureSizeFields *mSize;
    FrameRangeFields *mRange;
    QComboBox *mOrder;
};

} // namespace views
