// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/historydock.h"

#include "commands/terrain/terraincontext.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/quantitytext.h"
#include "views/widgets/icons.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QUndoView>
#include <QVBoxLayout>

namespace views {

namespace {

constexpr double Megabyte = 1 << 20;

} // namespace

HistoryDock::HistoryDock(QWidget *parent)
    : QDockWidget(parent)
    , mSteps(new QUndoView(this))
    , mBudgetRow(new QWidget(this))
    , mUsed(new QLabel(mBudgetRow))
    , mLimitLabel(new QLabel(mBudgetRow))
{
    setObjectName(QStringLiteral("historyDock"));
    mSteps->setObjectName(QStringLiteral("historySteps"));
    mSteps->setFrameShape(QFrame::NoFrame);
    mSteps->setAlternatingRowColors(true);
    mSteps->setIconSize({16, 16});
    mSteps->setCleanIcon(icon(QStringLiteral("save")));
    auto *content = new QWidget(this);
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(mSteps, 1);
    column->addWidget(mBudgetRow);
    mUsed->setObjectName(QStringLiteral("historyUsed"));
    mUsed->setWordWrap(true);
    auto *budget = new QVBoxLayout(mBudgetRow);
    budget->addWidget(mUsed);
    auto *row = new QHBoxLayout;
    row->addWidget(mLimitLabel);
    budget->addLayout(row);
    setWidget(content);
    retranslate();
    setContext(nullptr);
}

void HistoryDock::setContext(commands::EditContext *context)
{
    disconnect(mBudgetChanges);
    mSteps->setStack(context ? &context->undoStack() : nullptr);
    mSteps->setEnabled(context != nullptr);
    mSteps->setEmptyLabel(context ? tr("As Opened") : QString());
    auto *const terrain = qobject_cast<commands::TerrainContext *>(context);
    mBudget = terrain ? &terrain->history() : nullptr;
    mBudgetRow->setVisible(terrain);
    if (mBudget)
        mBudgetChanges = connect(mBudget, &commands::HistoryBudget::changed, this, &HistoryDock::showBudget);
    showBudget();
}

void HistoryDock::showBudget()
{
    if (!mBudget)
        return;
    QString text = tr("In memory: %1").arg(bytesText(mBudget->used()));
    if (const int dropped = mBudget->droppedCount())
        text += QLatin1Char('\n') + tr("%n older steps were dropped to stay within the limit.", nullptr, dropped);
    mUsed->setText(text);
    const double limit = double(mBudget->limit()) / Megabyte;
    if (mLimit->value() != limit) {
        const QSignalBlocker blocker(mLimit);
        mLimit->setValue(limit);
    }
    // The first row is no longer the document as it was opened.
    mSteps->setEmptyLabel(mBudget->droppedCount() ? tr("Oldest Step Kept") : tr("As Opened"));
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
    mSteps->setAccessibleName(tr("Steps of the document"));
    if (mSteps->stack())
        mSteps->setEmptyLabel(tr("As Opened"));
    delete mLimit; // it says its range in the language that it was made in
    mLimit = new NumberField(tr("Limit of the history"), {1, 65536, 0}, mBudgetRow);
    mLimit->setObjectName(QStringLiteral("historyLimit"));
    mLimit->setStep(64);
    mLimit->setHint(QStringLiteral("MB"));
    mLimitLabel->setText(tr("&Limit:"));
    mLimitLabel->setBuddy(&mLimit->input());
    static_cast<QHBoxLayout *>(mBudgetRow->layout()->itemAt(1)->layout())->addWidget(mLimit, 1);
    // When the typing is over: on the way to 512, 5 would drop nearly everything.
    connect(&mLimit->input(), &QLineEdit::editingFinished, this, [this] {
        if (mBudget && mLimit->value())
            mBudget->setLimit(std::size_t(*mLimit->value() * Megabyte));
    });
    showBudget();
}

} // namespace views
