// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/base/editcontext.h"

#include <QDockWidget>

class QUndoView;

namespace views {

/// The steps of the document, by name; a click goes there, the one that is saved is marked.
class HistoryDock final : public QDockWidget
{
    Q_OBJECT

public:
    explicit HistoryDock(QWidget *parent = nullptr);

    /// \param context  null: no document; must be taken away before it is destroyed
    void setContext(commands::EditContext *context);

protected:
    void changeEvent(QEvent *event) override;

private:
    void retranslate();

    QUndoView *mSteps;
};

} // namespace views
