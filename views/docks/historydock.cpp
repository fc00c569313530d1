// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/historydock.h"

#include "views/widgets/icons.h"

#include <QEvent>
#include <QUndoView>

namespace views {

HistoryDock::HistoryDock(QWidget *parent)
    : QDockWidget(parent)
    , mSteps(new QUndoView(this))
{
    setObjectName(QStringLiteral("historyDock"));
    mSteps->setObjectName(QStringLiteral("historySteps"));
    mSteps->setFrameShape(QFrame::NoFrame);
    mSteps->setAlternatingRowColors(true);
    mSteps->setIconSize({16, 16});
    mSteps->setCleanIcon(icon(QStringLiteral("save")));
    setWidget(mSteps);
    retranslate();
    setContext(nullptr);
}

void HistoryDock::setContext(commands::EditContext *context)
{
    mSteps->setStack(context ? &context->undoStack() : nullptr);
    mSteps->setEnabled(context != nullptr);
    mSteps->setEmptyLabel(context ? tr("As Opened") : QString());
}

void HistoryDock::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDockWidget::changeEvent(event);
}

void HistoryDock::retranslate()
{
    setWindowTitle(tr("History"));
    mSteps->setAccessibleName(tr("Steps of the animation"));
    if (mSteps->stack())
        mSteps->setEmptyLabel(tr("As Opened"));
}

} // namespace views
