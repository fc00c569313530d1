// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/normalisedialog.h"

#include "commands/animation/normaliseanimation.h"
#include "model/io/errortext.h"
#include "views/dialogs/jobpanel.h"
#include "views/dialogs/normalisationchoice.h"

#include <QFormLayout>
#include <QVBoxLayout>

namespace views {

using model::Normalisation;

NormaliseDialog::NormaliseDialog(commands::AnimationContext &editContext, QWidget *parent)
    : EditDialog(editContext, tr("Normalise Animation"), tr("&Normalise"), parent)
    , mMode(new NormalisationChoice(this))
{
    mMode->setMode(Normalisation::AllFrames);
    form().addRow(tr("&Mode:"), mMode);
    column().insertWidget(2, new JobPanel(mMeasuring, this));
    connect(mMode, &QComboBox::currentIndexChanged, this, &NormaliseDialog::refresh);
    connect(&mMeasuring, &Job::runningChanged, this, [this](bool running) {
        mMode->setEnabled(!running);
        refresh();
    });
    refresh();
}

QString NormaliseDialog::problem() const
{
    return mMeasuring.isRunning() ? tr("Looking at every frame…") : QString();
}

QString NormaliseDialog::consequence() const
{
    return mMode->mode() == Normalisation::None
               ? tr("The animation goes back to the coordinates of its file.")
               : tr("The animation is moved and scaled, by one factor for all axes. Doing it again changes nothing.");
}

bool NormaliseDialog::apply()
{
    if (mPlacement) {
        context().push<commands::NormaliseAnimation>(*mPlacement);
        return true;
    }
    mMeasuring.start([frames = document().frames(), mode = mMode->mode()](
                         const model::Progress &progress) { return normalisingPlacement(*frames, mode, progress); },
                     [this](const model::Result<model::Similarity> &placement) {
                         if (!isVisible())
                             return; // rejected meanwhile
                         if (placement) {
                             mPlacement = *placement;
                             accept();
                         } else if (placement.error().code != model::ErrorCode::Cancelled) {
                             showFailure(model::io::errorText(placement.error()));
                         }
                     });
    return false;
}

void NormaliseDialog::reject()
{
    mMeasuring.cancel();
    EditDialog::reject();
}

} // namespace views
