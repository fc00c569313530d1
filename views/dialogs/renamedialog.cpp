// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/renamedialog.h"

#include "commands/animation/renameanimation.h"

#include <QFormLayout>
#include <QLineEdit>

namespace views {

RenameDialog::RenameDialog(commands::AnimationContext &editContext, QWidget *parent)
    : EditDialog(editContext, tr("Rename Animation"), tr("&Rename"), parent)
    , mName(new QLineEdit(QString::fromStdString(document().name()), this))
{
    mName->setObjectName(QStringLiteral("name"));
    mName->setAccessibleName(tr("Name"));
    mName->selectAll();
    form().addRow(tr("&Name:"), mName);
    refresh();
}

bool RenameDialog::apply()
{
    context().push<commands::RenameAnimation>(mName->text().trimmed().toStdString());
    return true;
}

} // namespace views
