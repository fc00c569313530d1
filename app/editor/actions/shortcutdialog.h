// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/actions/actions.h"
#include "app/editor/start/settings.h"

#include <QDialog>

#include <map>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace editor {

/// Lets a person choose the keys of every action; what is chosen holds at once and is remembered. A key that another
/// action has is shown with that action's name, and moves only when asked for.
class ShortcutDialog final : public QDialog
{
    Q_OBJECT

public:
    ShortcutDialog(const Actions &actions, Settings &settings, QWidget *parent = nullptr);

private:
    void fillTree();
    void filter(const QString &text);
    void showSelected();
    void showConflict();
    void assign();
    void clearSelected();
    void resetSelected();
    void resetAll();
    void change(const Actions::Entry &entry, const QList<QKeySequence> &shortcuts);
    void showShortcuts(const Actions::Entry &entry);
    const Actions::Entry *selected() const;

    const Actions &mActions;
    Settings &mSettings;
    std::map<const Actions::Entry *, QTreeWidgetItem *> mItems;
    QLineEdit *mSearch;
    QTreeWidget *mTree;
    QKeySequenceEdit *mKeys;
    QPushButton *mAssign;
    QPushButton *mClear;
    QPushButton *mReset;
    QLabel *mConflict;
};

} // namespace editor
