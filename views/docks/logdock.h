// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/itemmodels/logmodel.h"

#include <QDockWidget>

class QAction;
class QTreeView;

namespace views {

/// The messages of the session, with Copy and Clear.
class LogDock final : public QDockWidget
{
    Q_OBJECT

public:
    explicit LogDock(LogModel &log, QWidget *parent = nullptr);

protected:
    void changeEvent(QEvent *event) override;

private:
    void retranslate();
    void copy() const;
    void updateActions();

    LogModel &mLog;
    QTreeView *mList;
    QAction *mCopy;
    QAction *mClear;
};

} // namespace views
