// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/dialogs/exportdialog.h"

class QCheckBox;

namespace views {

class PathField;

/// Export as a PC2 point cache and, wanted or not, its base mesh. Not modal: works on the animation as it was when it
/// opened.
class ExportPointCacheDialog final : public ExportDialog
{
    Q_OBJECT

public:
    /// \param path         proposed
    /// \param first, last  proposed, 0-based
    ExportPointCacheDialog(model::FrameSourcePtr frames, const QString &path, std::uint32_t first, std::uint32_t last,
                           QWidget *parent = nullptr);

protected:
    QString problem() const override;
    QString consequence() const override;
    QStringList filesToReplace() const override;
    QString outputPath() const override;
    Work work() override;

private:
    /// Where a reader of the cache looks for it; empty if it is not wanted.
    QString baseMeshPath() const;

    const model::FrameSourcePtr mFrames;
    PathField *mOutput;
    QCheckBox *mBaseMesh;
    FrameRangeFields *mRange;
};

} // namespace views
