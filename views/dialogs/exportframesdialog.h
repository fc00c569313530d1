// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/dialogs/exportdialog.h"

class QComboBox;

namespace views {

class PathField;

/// Export of frames as a folder of OBJ, OFF or PLY files. Not modal: works on the animation as it was when it opened.
class ExportFramesDialog final : public ExportDialog
{
    Q_OBJECT

public:
    /// \param folder       proposed; made if it does not exist
    /// \param first, last  proposed, 0-based
    ExportFramesDialog(model::FrameSourcePtr frames, const QString &folder, std::uint32_t first, std::uint32_t last,
                       QWidget *parent = nullptr);

protected:
    QString problem() const override;
    QString consequence() const override;
    QString outputPath() const override;
    Work work() override;

private:
    const model::FrameSourcePtr mFrames;
    PathField *mFolder;
    QComboBox *mFormat;
    FrameRangeFields *mRange;
};

} // namespace views
