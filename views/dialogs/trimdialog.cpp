// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/trimdialog.h"

#include "commands/animation/trimanimation.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/quantitytext.h"

#include <QFormLayout>

namespace views {

TrimDialog::TrimDialog(commands::AnimationContext &editContext, std::uint32_t first, std::uint32_t last,
                       QWidget *parent)
    : EditDialog(editContext, tr("Trim Animation"), tr("&Trim"), parent)
{
    const NumberRange frames{1, double(document().frameCount()), 0};
    mFirst = new NumberField(tr("First frame"), frames, this);
    mLast = new NumberField(tr("Last frame"), frames, this);
    mFirst->setObjectName(QStringLiteral("first"));
    mLast->setObjectName(QStringLiteral("last"));
    mFirst->setValue(double(first) + 1);
    mLast->setValue(double(last) + 1);
    form().addRow(tr("&First frame:"), mFirst);
    form().addRow(tr("&Last frame:"), mLast);
    connect(mFirst, &NumberField::changed, this, &TrimDialog::refresh);
    connect(mLast, &NumberField::changed, this, &TrimDialog::refresh);
    refresh();
}

QString TrimDialog::problem() const
{
    for (const NumberField *field : {mFirst, mLast})
        if (!field->value())
            return field->problem();
    if (*mFirst->value() > *mLast->value())
        return tr("The first frame must not come after the last.");
    return {};
}

QString TrimDialog::consequence() const
{
    return tr("Frames: %1 → %2")
        .arg(countText(document().frameCount()), countText(std::uint64_t(*mLast->value() - *mFirst->value()) + 1));
}

bool TrimDialog::apply()
{
    context().push<commands::TrimAnimation>(std::uint32_t(*mFirst->value()) - 1, std::uint32_t(*mLast->value()) - 1);
    return true;
}

} // namespace views
