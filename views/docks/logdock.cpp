// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/logdock.h"

#include "views/widgets/icons.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QScrollBar>
#include <QToolBar>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>
#include <numeric>

namespace views {

LogDock::LogDock(LogModel &log, QWidget *parent)
    : QDockWidget(parent)
    , mLog(log)
    , mList(new QTreeView)
    , mCopy(new QAction(icon(QStringLiteral("copy")), QString(), this))
    , mClear(new QAction(icon(QStringLiteral("clear")), QString(), this))
{
    setObjectName(QStringLiteral("logDock"));
    auto *content = new QWidget(this);
    auto *layout = new QHBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);

    auto *bar = new QToolBar(content);
    bar->setOrientation(Qt::Vertical);
    bar->setIconSize({16, 16});
    bar->addAction(mCopy);
    bar->addAction(mClear);
    layout->addWidget(bar);

    mList->setModel(&mLog);
    mList->setObjectName(QStringLiteral("logList"));
    mList->setRootIsDecorated(false);
    mList->setUniformRowHeights(true);
    mList->setAlternatingRowColors(true);
    mList->setSelectionMode(QAbstractItemView::ExtendedSelection);
    mList->setFrameShape(QFrame::NoFrame);
    mList->header()->setStretchLastSection(true);
    mList->header()->setSectionResizeMode(LogModel::Time, QHeaderView::ResizeToContents);
    mList->header()->setSectionResizeMode(LogModel::Level, QHeaderView::ResizeToContents);
    mList->setContextMenuPolicy(Qt::ActionsContextMenu);
    mList->addActions({mCopy, mClear});
    layout->addWidget(mList);
    setWidget(content);

    mCopy->setShortcut(QKeySequence::Copy);
    mCopy->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    content->addAction(mCopy);
    connect(mCopy, &QAction::triggered, this, &LogDock::copy);
    connect(mClear, &QAction::triggered, &mLog, &LogModel::clear);
    connect(&mLog, &LogModel::modelReset, this, &LogDock::updateActions);
    connect(&mLog, &LogModel::rowsInserted, this, [this] {
        updateActions();
        // Follow the newest, unless somebody reads further up.
        QScrollBar *bar_ = mList->verticalScrollBar();
        if (bar_->value() >= bar_->maximum() - 1)
            QMetaObject::invokeMethod(mList, &QTreeView::scrollToBottom, Qt::QueuedConnection);
    });
    retranslate();
    updateActions();
}

void LogDock::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDockWidget::changeEvent(event);
}

void LogDock::retranslate()
{
    setWindowTitle(tr("Log"));
    mCopy->setText(tr("Copy"));
    mCopy->setToolTip(tr("Copy the selected messages, or all"));
    mClear->setText(tr("Clear"));
    mClear->setToolTip(tr("Clear the log"));
    mList->setAccessibleName(tr("Messages"));
    emit mLog.headerDataChanged(Qt::Horizontal, 0, LogModel::ColumnCount - 1);
}

void LogDock::copy() const
{
    QList<int> rows;
    const QModelIndexList selected = mList->selectionModel()->selectedRows();
    for (const QModelIndex &index : selected)
        rows << index.row();
    std::sort(rows.begin(), rows.end());
    if (rows.isEmpty()) {
        rows.resize(mLog.rowCount());
        std::iota(rows.begin(), rows.end(), 0);
    }
    QGuiApplication::clipboard()->setText(mLog.asText(rows));
}

void LogDock::updateActions()
{
    const bool any = mLog.rowCount() > 0;
    mCopy->setEnabled(any);
    mClear->setEnabled(any);
}

} // namespace views
