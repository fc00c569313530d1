// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspect/inspectordock.h"

#include "views/inspect/parttable.h"
#include "views/widgets/icons.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QSortFilterProxyModel>
#include <QTabWidget>
#include <QTableView>
#include <QToolBar>
#include <QVBoxLayout>

namespace views {

InspectorDock::InspectorDock(QWidget *parent)
    : QDockWidget(parent)
    , mTabs(new QTabWidget(this))
    , mCopy(new QAction(icon(QStringLiteral("copy")), QString(), this))
    , mSave(new QAction(icon(QStringLiteral("export")), QString(), this))
{
    setObjectName(QStringLiteral("inspectorDock"));
    mTabs->setObjectName(QStringLiteral("inspectorLists"));
    mTabs->setDocumentMode(true);
    // Four short titles: the dock is as wide as they are.
    mTabs->setUsesScrollButtons(false);
    mTabs->setElideMode(Qt::ElideNone);
    for (const PartKind kind : EveryPartKind)
        mLists[std::size_t(kind)] = makeList(kind);
    mCopy->setObjectName(QStringLiteral("inspector.copy"));
    mSave->setObjectName(QStringLiteral("inspector.save"));
    mCopy->setShortcut(QKeySequence::Copy);
    mCopy->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(mCopy, &QAction::triggered, this, &InspectorDock::copy);
    connect(mSave, &QAction::triggered, this, &InspectorDock::saveAsked);
    auto *content = new QWidget(this);
    content->addAction(mCopy);
    auto *bar = new QToolBar(content);
    bar->setIconSize({16, 16});
    bar->addActions({mCopy, mSave});
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(mTabs, 1);
    column->addWidget(bar);
    setWidget(content);
    retranslate();
}

InspectorDock::~InspectorDock() = default;

InspectorDock::List InspectorDock::makeList(PartKind kind)
{
    static constexpr const char *Names[] = {"componentList", "holeList", "handleList", "problemList"};
    List list;
    auto *page = new QWidget(mTabs);
    list.table = new PartTable(kind, this);
    list.sorted = new QSortFilterProxyModel(this);
    list.sorted->setSourceModel(list.table);
    list.sorted->setSortRole(PartTable::SortRole);
    list.view = new QTableView(page);
    list.view->setObjectName(QLatin1String(Names[std::size_t(kind)]));
    list.view->setModel(list.sorted);
    list.view->setSelectionBehavior(QAbstractItemView::SelectRows);
    list.view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list.view->setSortingEnabled(true);
    list.view->sortByColumn(-1, Qt::AscendingOrder);
    list.view->setAlternatingRowColors(true);
    list.view->setShowGrid(false);
    list.view->setWordWrap(false);
    list.view->setFrameShape(QFrame::NoFrame);
    list.view->setTabKeyNavigation(false);
    list.view->verticalHeader()->hide();
    list.view->verticalHeader()->setDefaultSectionSize(list.view->fontMetrics().height() + 6);
    list.view->horizontalHeader()->setSectionResizeMode(kind == PartKind::Problem ? QHeaderView::Stretch
                                                                                  : QHeaderView::ResizeToContents);
    list.view->horizontalHeader()->setResizeContentsPrecision(100);
    list.view->setContextMenuPolicy(Qt::ActionsContextMenu);
    list.view->addActions({mCopy, mSave});
    list.explanation = new QLabel(page);
    list.explanation->setWordWrap(true);
    list.explanation->setMargin(6);
    auto *column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(list.explanation);
    column->addWidget(list.view, 1);
    mTabs->addTab(page, QString());
    connect(list.view->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            [this, kind] { takeSelection(mLists[std::size_t(kind)]); });
    return list;
}

void InspectorDock::setInspection(Inspection *inspection)
{
    if (inspection == mInspection)
        return;
    if (mInspection)
        mInspection->disconnect(this);
    mInspection = inspection;
    // The tables first: what follows reads them.
    mIsShowing = true;
    for (const List &list : mLists)
        list.table->setInspection(inspection);
    mIsShowing = false;
    if (inspection) {
        connect(inspection, &Inspection::meshChanged, this, &InspectorDock::showCounts);
        connect(inspection, &Inspection::found, this, &InspectorDock::showCounts);
        connect(inspection, &Inspection::busyChanged, this, &InspectorDock::showCounts);
        connect(inspection, &Inspection::selectionChanged, this, &InspectorDock::showSelection);
    }
    showCounts();
    showSelection();
}

PartKind InspectorDock::currentList() const
{
    return PartKind(mTabs->currentIndex());
}

void InspectorDock::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDockWidget::changeEvent(event);
}

void InspectorDock::retranslate()
{
    setWindowTitle(tr("Inspector"));
    mTabs->setAccessibleName(tr("Lists of the inspector"));
    mCopy->setText(tr("&Copy Rows"));
    mCopy->setStatusTip(tr("Copy the selected rows, or all, as a table"));
    mSave->setText(tr("&Save Report…"));
    mSave->setStatusTip(tr("Write everything that was found as CSV or JSON"));
    const QString explanations[] = {
        tr("Parts that hang together by edges. Selecting one makes the others step back."),
        tr("Missing faces: loops of edges that have a face on one side only."),
        tr("Nothing is missing here: a handle is a bridge over a tunnel, as in a ring. One loop goes round it, the "
           "other through its tunnel."),
        tr("What a program that expects a clean surface may stumble over. Nothing is repaired unasked."),
    };
    const QString names[] = {tr("Components of the mesh"), tr("Holes of the mesh"), tr("Handles of the mesh"),
                             tr("Problems of the mesh")};
    for (std::size_t kind = 0; kind < mLists.size(); ++kind) {
        mLists[kind].explanation->setText(explanations[kind]);
        mLists[kind].view->setAccessibleName(names[kind]);
        mLists[kind].view->setAccessibleDescription(explanations[kind]);
        mLists[kind].table->retranslate();
    }
    showCounts();
}

void InspectorDock::showCounts()
{
    const QString titles[] = {tr("Components (%1)"), tr("Holes (%1)"), tr("Handles (%1)"), tr("Problems (%1)")};
    for (const PartKind kind : EveryPartKind) {
        const bool isKnown = mInspection && mInspection->isKnown(kind);
        const QString count = isKnown                                ? QLocale().toString(mInspection->countOf(kind))
                              : mInspection && mInspection->isBusy() ? QStringLiteral("…")
                                                                     : QStringLiteral("–");
        mTabs->setTabText(int(kind), titles[std::size_t(kind)].arg(count));
    }
    const bool isKnown = mInspection && mInspection->report();
    mCopy->setEnabled(isKnown);
    mSave->setEnabled(isKnown);
}

void InspectorDock::showSelection()
{
    if (mIsShowing)
        return;
    mIsShowing = true;
    for (const List &list : mLists) {
        QItemSelection rows;
        if (mInspection)
            for (const PartId part : mInspection->selection())
                if (part.kind == list.table->kind()) {
                    const QModelIndex at = list.sorted->mapFromSource(list.table->index(int(part.index), 0));
                    rows.select(at, at);
                }
        list.view->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
        if (!rows.isEmpty()) {
            mTabs->setCurrentIndex(int(list.table->kind()));
            list.view->scrollTo(rows.indexes().constFirst());
        }
    }
    mIsShowing = false;
}

void InspectorDock::takeSelection(const List &list)
{
    if (mIsShowing || !mInspection)
        return;
    mIsShowing = true;
    std::vector<PartId> parts;
    for (const QModelIndex &row : list.view->selectionModel()->selectedRows())
        parts.push_back({list.table->kind(), std::uint32_t(list.sorted->mapToSource(row).row())});
    // One list at a time: who goes on to the holes is done with the component.
    for (const List &other : mLists)
        if (other.table != list.table)
            other.view->clearSelection();
    mInspection->select(std::move(parts), true);
    mIsShowing = false;
}

void InspectorDock::copy()
{
    const List &list = mLists[std::size_t(mTabs->currentIndex())];
    const bool isAll = !list.view->selectionModel()->hasSelection();
    QStringList lines, cells;
    for (int column = 0; column < list.table->columnCount(); ++column)
        cells << list.table->headerData(column, Qt::Horizontal).toString();
    lines << cells.join(QLatin1Char('\t'));
    for (int row = 0; row < list.sorted->rowCount(); ++row) {
        if (!isAll && !list.view->selectionModel()->isRowSelected(row))
            continue;
        cells.clear();
        for (int column = 0; column < list.table->columnCount(); ++column)
            cells << list.sorted->index(row, column).data(PartTable::PlainRole).toString();
        lines << cells.join(QLatin1Char('\t'));
    }
    QGuiApplication::clipboard()->setText(lines.join(QLatin1Char('\n')) + QLatin1Char('\n'));
}

} // namespace views
