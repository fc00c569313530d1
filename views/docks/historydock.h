// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/base/editcontext.h"

#include <QDockWidget>
#include <QPointer>

class QLabel;
class QUndoView;

namespace commands {
class HistoryBudget;
}

namespace views {

class NumberField;

/// The steps of the document, by name; a click goes there, the one that is saved is marked. Below them, for a terrain,
/// what they keep in memory, and how much they may.
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
    void showBudget();

    QUndoView *mSteps;
    QWidget *mBudgetRow;
    QLabel *mUsed;
    QLabel *mLimitLabel;
    NumberField *mLimit = nullptr;
    QPointer<commands::HistoryBudget> mBudget;
    QMetaObject::Connection mBudgetChanges;
};

} // namespace views
