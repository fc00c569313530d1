// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/inspect/inspection.h"

#include <QDockWidget>
#include <QPointer>

#include <array>

class QAction;
class QLabel;
class QSortFilterProxyModel;
class QTableView;
class QTabWidget;

namespace views {

class PartTable;

/// What a mesh is made of and what is wrong with it: components, holes, handles and problems in a list each, since they
/// are easily taken for one another. What is selected here is shown in every view of the mesh.
class InspectorDock final : public QDockWidget
{
    Q_OBJECT

public:
    explicit InspectorDock(QWidget *parent = nullptr);
    ~InspectorDock() override;

    /// Null: nothing is inspected.
    void setInspection(Inspection *inspection);
    Inspection *inspection() const { return mInspection; }
    /// The list that is open.
    PartKind currentList() const;

    /// For menus and the shortcut editor; they have object names, and texts in the language of now.
    QList<QAction *> commands() const { return {mCopy, mSave}; }

signals:
    /// A file with everything that was found is wanted.
    void saveAsked();

protected:
    void changeEvent(QEvent *event) override;

private:
    struct List
    {
        PartTable *table = nullptr;
        QSortFilterProxyModel *sorted = nullptr;
        QTableView *view = nullptr;
        QLabel *explanation = nullptr;
    };

    List makeList(PartKind kind);
    void retranslate();
    void showCounts();
    void showSelection();
    void takeSelection(const List &list);
    void copy();

    QPointer<Inspection> mInspection;
    QTabWidget *mTabs;
    std::array<List, 4> mLists;
    QAction *mCopy, *mSave;
    bool mIsShowing = false; ///< the lists follow the inspection, not the other way round
};

} // namespace views
