// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/frameratedialog.h"

#include "commands/animation/setframerate.h"
#include "views/dialogs/framerates.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/quantitytext.h"

#include <QFormLayout>

namespace views {

FrameRateDialog::FrameRateDialog(commands::AnimationContext &editContext, QWidget *parent)
    : EditDialog(editContext, tr("Frame Rate"), tr("&Set Frame Rate"), parent)
    , mRate(new NumberField(tr("Frame rate"), FrameRates, this))
{
    mRate->setObjectName(QStringLiteral("rate"));
    mRate->setHint(tr("frames per second"));
    mRate->setValue(document().timing().frameRate);
    form().addRow(tr("&Frame rate:"), mRate);
    connect(mRate, &NumberField::changed, this, &FrameRateDialog::refresh);
    refresh();
}

QString FrameRateDialog::problem() const
{
    return mRate->problem();
}

QString FrameRateDialog::consequence() const
{
    const double frames = document().frameCount();
    return tr("Duration: %1 → %2. The frames stay as they are.")
        .arg(durationText(frames / document().timing().frameRate), durationText(frames / *mRate->value()));
}

bool FrameRateDialog::apply()
{
    context().push<commands::SetFrameRate>(*mRate->value());
    return true;
}

} // namespace views
