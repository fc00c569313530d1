// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/editdialog.h"

#include "views/dialogs/inputline.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace views {

EditDialog::EditDialog(commands::AnimationContext &context, const QString &title, const QString &action,
                       QWidget *parent)
    : QDialog(parent)
    , mContext(context)
    , mColumn(new QVBoxLayout(this))
    , mForm(new QFormLayout)
    , mHint(new HintLabel(this))
    , mAccept(new QPushButton(action, this))
{
    setWindowTitle(title);
    setWindowModality(Qt::WindowModal);
    setMinimumWidth(420);
    mHint->setObjectName(QStringLiteral("hint"));
    mHint->setWordWrap(true);
    mHint->setMinimumHeight(2 * fontMetrics().height()); // a sentence that comes and goes must not resize the dialog
    mHint->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    mAccept->setObjectName(QStringLiteral("accept"));
    mAccept->setDefault(true);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->addButton(mAccept, QDialogButtonBox::AcceptRole);
    mColumn->addLayout(mForm);
    mColumn->addWidget(mHint);
    mColumn->addStretch(1);
    mColumn->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &EditDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &EditDialog::reject);
    connect(&mContext, &QObject::destroyed, this, &EditDialog::close);
}

void EditDialog::accept()
{
    if (problem().isEmpty() && apply())
        QDialog::accept();
}

void EditDialog::refresh()
{
    const QString reason = problem();
    mAccept->setEnabled(reason.isEmpty());
    mAccept->setToolTip(reason);
    mHint->showHint(reason.isEmpty() ? consequence() : reason);
}

void EditDialog::showFailure(const QString &text)
{
    mHint->showRefusal(text);
}

} // namespace views
