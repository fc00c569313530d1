// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/recovery/recoveryentry.h"
#include "views/jobs/job.h"

#include <QDialog>

class QListWidget;
class QPushButton;

namespace editor {

/// Offers what programs that crashed have left: each with a picture, its name, when it was written last, and its size.
/// Recover opens what is selected; Discard removes it; Later leaves all of it for the next start.
class RecoveryDialog final : public QDialog
{
    Q_OBJECT

public:
    explicit RecoveryDialog(std::vector<Leftover> leftovers, QWidget *parent = nullptr);

signals:
    void recoverRequested(const editor::Leftover &leftover);

private:
    void fill();
    void drawNext();
    /// Rows, the last one first.
    std::vector<int> selectedRows() const;
    void recoverSelected();
    void discardSelected();
    void removeRow(int row);

    std::vector<Leftover> mLeftovers; ///< a row each
    QListWidget *mList;
    QPushButton *mRecover;
    QPushButton *mDiscard;
    QStringList mDrawn; ///< folders whose picture was tried
    views::Job mDrawing;
};

} // namespace editor
