// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/resampledialog.h"

#include "commands/animation/resampleanimation.h"
#include "views/dialogs/framerates.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/quantitytext.h"

#include <QFormLayout>

namespace views {

using model::TimeMap;

ResampleDialog::ResampleDialog(commands::AnimationContext &editContext, QWidget *parent)
    : EditDialog(editContext, tr("Resample Animation"), tr("&Resample"), parent)
    , mRate(new NumberField(tr("New frame rate"), FrameRates, this))
{
    mRate->setObjectName(QStringLiteral("rate"));
    mRate->setHint(tr("frames per second"));
    mRate->setValue(document().timing().frameRate);
    form().addRow(tr("&New frame rate:"), mRate);
    connect(mRate, &NumberField::changed, this, &ResampleDialog::refresh);
    refresh();
}

QString ResampleDialog::problem() const
{
    if (!mRate->value())
        return mRate->problem();
    if (frameCount() > TimeMap::MaxFrameCount)
        return tr("That would make %1 frames; %2 are allowed.")
            .arg(countText(frameCount()), countText(TimeMap::MaxFrameCount));
    return {};
}

QString ResampleDialog::consequence() const
{
    return tr("Frames: %1 → %2. The speed stays; frames in between are blended.")
        .arg(countText(document().frameCount()), countText(frameCount()));
}

bool ResampleDialog::apply()
{
    context().push<commands::ResampleAnimation>(*mRate->value());
    return true;
}

std::uint64_t ResampleDialog::frameCount() const
{
    return TimeMap::resampledFrameCount(document().frameCount(), document().timing().frameRate, *mRate->value());
}

} // namespace views
